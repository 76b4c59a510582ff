// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/atomic_file.h>
#include <thermocontact/base/text.h>
#include <thermocontact/output/snapshot_series.h>

#include <cstdio>

namespace ThermoContact
{
  SnapshotSeries::SnapshotSeries(const std::string &directory,
                                 const std::string &name,
                                 const Conversion  &time_unit)
    : directory(directory)
    , name(name)
    , time_unit(time_unit)
  {}



  std::string
  SnapshotSeries::file_name(const unsigned int i) const
  {
    return "fields/" + name + "-" + align_right(text(i), 5, '0') + ".vtu";
  }



  void
  SnapshotSeries::add(const double time)
  {
    entries += "    <DataSet timestep=\"";
    append_number(entries, time_unit(time), all_digits);
    entries +=
      "\" group=\"\" part=\"0\" file=\"" + file_name(times_.size()) + "\"/>\n";
    times_.push_back(time);
  }



  std::string
  SnapshotSeries::write_pvd()
  {
    if (n_listed == times_.size())
      return "";
    const std::string fault =
      write_atomically(directory + "/" + name + ".pvd",
                       "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"0.1\">\n"
                       "  <Collection>\n" +
                         entries + "  </Collection>\n</VTKFile>\n");
    if (fault.empty())
      n_listed = times_.size();
    return fault;
  }



  void
  SnapshotSeries::restore(const std::vector<double> &times)
  {
    times_.clear();
    entries.clear();
    for (const double time : times)
      add(time);
    n_listed = 0;
    n_synced = times.size(); // before the checkpoint was written
  }



  std::string
  SnapshotSeries::remove_later()
  {
    unsigned int i = times_.size();
    while (std::remove(path_of(i).c_str()) == 0)
      ++i;
    if (!times_.empty())
      return write_pvd();
    std::remove((directory + "/" + name + ".pvd").c_str());
    return "";
  }



  std::string
  SnapshotSeries::sync()
  {
    if (n_synced == times_.size())
      return "";
    std::string fault;
    for (; n_synced < times_.size() && fault.empty(); ++n_synced)
      fault = sync_file(path_of(n_synced));
    sync_directory(directory + "/fields");
    return fault;
  }
} // namespace ThermoContact
