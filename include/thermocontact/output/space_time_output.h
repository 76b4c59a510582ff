// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_space_time_output_h
#define thermocontact_output_space_time_output_h

#include <thermocontact/base/table_file.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/point_values.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The whole run in one picture: space-time.vtu, whose first coordinate is x
   * and whose second is time, with temperature, displacement, velocity and
   * stress as in the snapshots, in dim > 1 their axial components along the
   * axis. While the run goes on columns are appended to space-time.columns, as
   * doubles of the machine: the time, then the values of each field that is
   * present at all places. The VTU file is made of it at the end.
   */
  template <int dim>
  class SpaceTimeOutput
  {
  public:
    /** @param body borrowed */
    SpaceTimeOutput(const std::string &directory, const Body<dim> &body);

    /**
     * Begins the file of columns, or goes on behind its first @p size bytes if
     * that is not 0. On one rank.
     */
    void
    open(const std::uint64_t size)
    {
      columns_file.open(columns_path, "", size);
    }

    /** Adds a column. Collective. A fault shows when file() is flushed. */
    void
    write(const State &state);

    /** The file of columns; open on rank 0 alone. */
    TableFile &
    file()
    {
      return columns_file;
    }

    /**
     * Makes space-time.vtu from the columns so far, but not if all are at one
     * time. Between places of a cell and two columns lies one quadrilateral, so
     * that values may jump between cells; none between columns whose times are
     * equal in the single precision of the file. Memory does not grow with the
     * number of columns. On one rank.
     *
     * @param is_done removes the columns if no checkpoint needs them
     * @return the fault, with the path, or nothing
     */
    std::string
    write_vtu(const bool is_done);

  private:
    const std::string             directory;
    const std::string             columns_path;
    const OutputUnits             units;
    const std::vector<Place<dim>> places;
    const unsigned int            places_per_cell;
    PointValues<dim>              point_values;
    TableFile                     columns_file;

    /** Fields that the scene has, and their names. */
    std::vector<unsigned int> quantities;
    std::vector<std::string>  names;
  };
} // namespace ThermoContact

#endif
