// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_snapshot_series_h
#define thermocontact_output_snapshot_series_h

#include <thermocontact/base/conversion.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * VTU files of one kind at times, fields/NAME-NNNNN.vtu, and NAME.pvd, which
   * lists them for ParaView. The PVD file is replaced in one piece, so that it
   * can be opened while the run goes on.
   *
   * All ranks know the times; files are written on one.
   */
  class SnapshotSeries
  {
  public:
    /** @param time_unit in which the PVD file has the times */
    SnapshotSeries(const std::string &directory,
                   const std::string &name,
                   const Conversion  &time_unit)
      : directory(directory)
      , name(name)
      , time_unit(time_unit)
    {}

    /** Times of the snapshots so far. */
    const std::vector<double> &
    times() const
    {
      return times_;
    }

    /** The file of the snapshot that comes next. */
    std::string
    next_path() const
    {
      return path_of(times_.size());
    }

    /** That snapshot is there, of a state at @p time. */
    void
    add(const double time)
    {
      times_.push_back(time);
    }

    /**
     * Writes the PVD file if it lacks snapshots; returns the fault, or
     * nothing. On one rank.
     */
    std::string
    write_pvd();

    /** Goes on behind the snapshots at @p times. */
    void
    restore(const std::vector<double> &times)
    {
      times_   = times;
      n_listed = 0;
      n_synced = times.size(); // before the checkpoint was written
    }

    /**
     * Removes the files that an earlier run has written after these snapshots;
     * returns the fault, or nothing. On one rank.
     */
    std::string
    remove_later();

    /**
     * The snapshots so far survive a loss of power, as far as this rank has
     * written them; returns the fault, or nothing.
     */
    std::string
    sync();

  private:
    const std::string   directory;
    const std::string   name;
    const Conversion    time_unit;
    std::vector<double> times_;
    unsigned int        n_listed = 0; ///< snapshots in it
    unsigned int        n_synced = 0; ///< snapshots

    /** File of snapshot @p i, from the output directory. */
    std::string
    file_name(const unsigned int i) const;

    std::string
    path_of(const unsigned int i) const
    {
      return directory + "/" + file_name(i);
    }
  };
} // namespace ThermoContact

#endif
