// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/base/writable_file.h>
#include <thermocontact/output/snapshot_series.h>

#include <cstdio>

namespace ThermoContact
{
  std::string
  SnapshotSeries::file_name(const unsigned int i) const
  {
    return "fields/" + name + "-" + align_right(text(i), 5, '0') + ".vtu";
  }



  std::string
  SnapshotSeries::write_pvd()
  {
    if (n_listed == times_.size())
      return "";
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"0.1\">\n"
                       "  <Collection>\n";
    for (unsigned int i = 0; i < times_.size(); ++i)
      text += "    <DataSet timestep=\"" +
              significant(time_unit(times_[i]), all_digits) +
              "\" group=\"\" part=\"0\" file=\"" + file_name(i) + "\"/>\n";
    text += "  </Collection>\n</VTKFile>\n";
    const std::string fault =
      write_atomically(directory + "/" + name + ".pvd", text);
    if (fault.empty())
      n_listed = times_.size();
    return fault;
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
