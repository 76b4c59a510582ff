// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_fuzz_reading_h
#define thermocontact_fuzz_reading_h

#include <thermocontact/input/parameter_text.h>

#include <map>
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

    unsigned int dimension = 1;

    /** By path, those with another value than the default; of paths_read(). */
    std::map<std::string, std::string> entries;
  };



  /** All entries. */
  std::vector<std::string>
  paths_read();

  /** What --units prints of it. */
  std::string
  scene_without_units(const std::vector<Assignment> &assignments);

  /** All entries of a scene with their values, as used.prm has them. */
  std::string
  all_entries(const std::vector<Assignment> &assignments);



  /**
   * What main() does with a file for --check, and for --units.
   *
   * @param scratch a directory for the files of the first steps, made and
   *   emptied here; none: no step is taken
   * @throw InputError, ComputationError as the program; std::logic_error if
   *   what is accepted, or the scene of a rod in units, reads differently once
   *   it is written
   */
  Reading
  read_as_program(const std::string &text, const std::string &scratch);
} // namespace ThermoContact

#endif
