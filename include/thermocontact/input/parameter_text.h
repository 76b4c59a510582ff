// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_parameter_text_h
#define thermocontact_input_parameter_text_h

#include <iosfwd>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** The place of assignments on the command line, which override others. */
  constexpr const char *command_line_place = "command line";



  /** One statement of a parameter file or of the command line. */
  struct Assignment
  {
    std::string place; ///< "rod.prm, line 12" or the command line
    std::string path;  ///< "Section/Entry", or "Entry" outside sections
    std::string value;

    /** True for `subsection`, whose path is "Section/", without a value. */
    bool
    is_section() const
    {
      return !path.empty() && path.back() == '/';
    }

    /** For other ranks. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &place &path &value;
    }
  };



  /**
   * The text as messages show it: invisible characters (control characters,
   * blanks of other widths, bytes that are not UTF-8) by their numbers, and no
   * more than the beginning of a long text.
   */
  std::string
  quote(const std::string &text, const unsigned int max_length = 200);

  /** True for UTF-8 without control characters other than tabs. */
  bool
  is_plain_text(const std::string &text);

  /**
   * The text of a file or of a pipe, "-" for the standard input.
   *
   * @param wanted the file that a message asks for: a table; empty: a parameter
   *   file
   * @throw InputError if it cannot be opened or read, is a directory, empty, or
   *   larger than any parameter file
   */
  std::string
  read_text(const std::string &file_name, const std::string &wanted = "");

  /**
   * Reads the statements of a parameter file in deal.II's format: `set`,
   * `subsection`, `end`, `include FILE` (beside the file that says so, in the
   * section where it stands), comments from '#', lines continued by '\'. Lines
   * end as on Unix or on Windows.
   *
   * @param name of the input in messages
   * @throw InputError naming line and remedy on any other statement, on
   *   `subsection` without `end` and the reverse, on a binary file
   */
  std::vector<Assignment>
  read_assignments(std::istream &input, const std::string &name);

  /** The same of a file, "-" for the standard input. */
  std::vector<Assignment>
  read_parameter_file(const std::string &file_name);

  /** The last assignment to an entry, the one that holds, or null. */
  const Assignment *
  last_assignment(const std::vector<Assignment> &assignments,
                  const std::string             &path);

  /**
   * Throws the fault of a value.
   *
   * @param allowed, remedy left out if empty
   * @throw InputError
   */
  [[noreturn]] void
  refuse(const Assignment  &assignment,
         const std::string &fault,
         const std::string &allowed,
         const std::string &remedy);

  /** @throw InputError with all of them, if there are any */
  void
  throw_faults(const std::vector<std::string> &faults);

  /**
   * Reads 'Section/Entry=value', the argument of the option --set.
   *
   * @throw InputError if there is no '=' or no entry
   */
  Assignment
  parse_override(const std::string &argument);
} // namespace ThermoContact

#endif
