// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_space_time_file_h
#define thermocontact_output_space_time_file_h

#include <thermocontact/output/output_units.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * What the columns of a space-time file have in common. At the head of the
   * file of columns, as doubles of the machine: number of places, places per
   * cell, 1 or 0 for the presence of temperature and of displacement, then x of
   * all places. Each column is its time, then the values of the fields that are
   * present at all places: temperature, displacement, velocity, stress.
   */
  struct SpaceTimeLayout
  {
    unsigned int        places_per_cell  = 0;
    bool                has_temperature  = false;
    bool                has_displacement = false;
    std::vector<double> x; ///< of all places, cell by cell

    /** Names of the fields that are present. */
    std::vector<std::string>
    field_names() const;

    /** The head of a file of columns. */
    std::vector<double>
    head() const;
  };



  /**
   * Makes a VTU file of a file of columns: x is the first coordinate, time the
   * second. Between places of a cell and two columns lies one quadrilateral, so
   * that values may jump between cells. Columns whose times are equal in the
   * single precision of the file have none between them. Memory does not grow
   * with the number of columns.
   *
   * @param units of the VTU file; the columns have none
   * @return what is wrong, with the path, or nothing. No file is written if all
   *   columns are at one time. A column that is not whole is left out.
   */
  std::string
  write_space_time_vtu(const std::string &columns_path,
                       const std::string &vtu_path,
                       const OutputUnits &units);
} // namespace ThermoContact

#endif
