// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_parameter_file_h
#define thermocontact_parameter_file_h

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "parameters.h"

namespace ThermoContact
{
  /** The place of assignments on the command line, which override others. */
  constexpr const char *command_line_place = "command line";



  /** One `set` statement of a parameter file or of the command line. */
  struct Assignment
  {
    std::string place; ///< "rod.prm, line 12" or the command line
    std::string path;  ///< "Section/Entry", or "Entry" outside sections
    std::string value;
  };



  /**
   * Reads the statements of a parameter file in deal.II's format: `set`,
   * `subsection`, `end`, comments from '#', lines continued by '\'.
   *
   * @param name what messages call the input
   * @throw InputError naming line and remedy on any other statement, on
   *   `subsection` without `end` and the reverse, on a binary file
   */
  std::vector<Assignment>
  read_assignments(std::istream &input, const std::string &name);

  /**
   * The text of a file.
   *
   * @throw InputError if it cannot be opened or read, or is a directory
   */
  std::string
  read_text(const std::string &file_name);

  /**
   * Reads 'Section/Entry=value', the argument of the option --set.
   *
   * @throw InputError if there is no '='
   */
  Assignment
  parse_override(const std::string &argument);

  /**
   * Writes @p assignments into @p prm, whose entries are bound to a
   * Parameters object.
   *
   * @throw InputError with place, path, value, what is allowed and the meaning
   *   of the entry if a name is unknown (then with the nearest known one), a
   *   value does not fit, or a file sets an entry twice
   */
  void
  assign_entries(const std::vector<Assignment> &assignments,
                 ParameterHandler              &prm);

  /**
   * Puts the place of the last assignment to an entry before a message that
   * begins with the path of that entry; other messages stay as they are.
   */
  std::string
  add_place(const std::string             &message,
            const std::vector<Assignment> &assignments);

  /**
   * Refuses values that the scene would ignore.
   *
   * @throw InputError if an entry of parameters.unused_entries() differs from
   *   its default
   */
  void
  check_unused_entries(const Parameters &parameters, ParameterHandler &prm);

  /** Path and present value of every entry. */
  std::map<std::string, std::string>
  entry_values(const ParameterHandler &prm);

  /** True for the same text or the same number. */
  bool
  equal_values(const std::string &a, const std::string &b);

  /**
   * Writes all entries with their present values as a parameter file, in the
   * order of declaration.
   *
   * @param omit paths that are left out
   */
  void
  write_entries(const ParameterHandler      &prm,
                const std::set<std::string> &omit,
                std::ostream                &output);
} // namespace ThermoContact

#endif
