// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_constants_h
#define thermocontact_input_constants_h

#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/parameter_text.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** The entry of section Constants that stands for all of them. */
  inline const std::string name_of_constants = "NAME";



  /** True for an entry of that section. */
  bool
  is_constant_path(const std::string &path);



  /**
   * Declares the constants of @p assignments, those of a whole file, in @p prm
   * and evaluates them.
   *
   * @return their values
   * @throw InputError if a name cannot be that of a constant, if a value cannot
   *   be read, or depends on itself, or if one of the command line is neither
   *   in the file nor named anywhere
   */
  std::map<std::string, double>
  assign_constants(const std::vector<Assignment> &assignments,
                   dealii::ParameterHandler      &prm);



  /**
   * The value of an entry for numbers, with those of a list, as numbers: where
   * it is no number but an expression in constants, its value.
   *
   * @throw InputError if it is neither
   */
  std::string
  as_numbers(const Assignment                    &assignment,
             const std::map<std::string, double> &constants);

  /** Whether an entry may be a number. */
  bool
  is_numeric(const DeclaredEntry &entry);

  /** The same assignments, with numbers where they are expressions in constants
   * and the entry may be a number. */
  std::vector<Assignment>
  with_numbers(std::vector<Assignment>              assignments,
               const std::map<std::string, double> &constants);
} // namespace ThermoContact

#endif
