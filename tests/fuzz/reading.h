// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_fuzz_reading_h
#define thermocontact_fuzz_reading_h

#include <string>
#include <vector>

namespace ThermoContact
{
  /** What a parameter file that was accepted holds. */
  struct Reading
  {
    bool is_large        = false; ///< its matrices were not made
    bool is_rod_in_units = false;
    bool is_study        = false;
    bool has_begun       = false; ///< the first steps were taken
  };



  /**
   * Texts of files that the program accepts: those of prm, a scene of each rod
   * in units there, with its scales, and files that hold all entries.
   */
  std::vector<std::string>
  valid_files();



  /**
   * What main() does with a file for --check, and for --units.
   *
   * @param scratch a directory for the files of the first steps of a rod, made
   *   and emptied here; none: no step is taken
   * @throw InputError, ComputationError as the program; std::logic_error if
   *   what is accepted reads differently once it is written
   */
  Reading
  read_as_program(const std::string &text, const std::string &scratch);
} // namespace ThermoContact

#endif
