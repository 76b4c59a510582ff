// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_fuzz_entries_h
#define thermocontact_fuzz_entries_h

#include <thermocontact/input/parameter_text.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** The statements of the text of a parameter file. */
  std::vector<Assignment>
  statements(const std::string &text);

  /** Entries that get their values together. */
  using Group = std::vector<Assignment>;

  /**
   * The groups of a file of this folder: one to a line, what --set takes for
   * each, ' & ' between them; comments from '#'.
   *
   * @throw InputError if there is no such file, or a line is something else
   */
  std::vector<Group>
  listed_values(const std::string &file_name);

  /** @p text with a value of an entry, in place of what it says of it. */
  std::string
  with_entry(const std::string &text, const Assignment &entry);
} // namespace ThermoContact

#endif
