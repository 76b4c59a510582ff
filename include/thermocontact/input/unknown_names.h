// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_unknown_names_h
#define thermocontact_input_unknown_names_h

#include <thermocontact/input/parameter_text.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** "Section" of "Section/Entry", or nothing. */
  std::string
  section_of(const std::string &path);

  /** "Entry" of it. */
  std::string
  name_of(const std::string &path);

  /** "; did you mean NAME?" with the nearest of those, or nothing. */
  std::string
  did_you_mean(const std::string &name, const std::vector<std::string> &known);

  /**
   * @throw InputError, with the nearest name, if none of the entries is in
   *   @p section
   */
  void
  check_section(const std::string &place, const std::string &section);

  /**
   * @throw InputError that says whether section or entry does not exist, and
   *   names the nearest one that does
   */
  [[noreturn]] void
  refuse_entry(const Assignment &assignment);
} // namespace ThermoContact

#endif
