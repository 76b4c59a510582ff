// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_unknown_names_h
#define thermocontact_unknown_names_h

#include <string>
#include <vector>

#include "declared_entries.h"
#include "parameter_text.h"

namespace ThermoContact
{
  /** "Section" of "Section/Entry", or nothing. */
  std::string
  section_of(const std::string &path);

  /**
   * @throw InputError, with the nearest name, if none of the entries is in
   *   @p section
   */
  void
  check_section(const std::string                &place,
                const std::string                &section,
                const std::vector<DeclaredEntry> &entries);

  /**
   * @throw InputError that says whether section or entry does not exist, and
   *   names the nearest one that does
   */
  [[noreturn]] void
  refuse_entry(const Assignment                 &assignment,
               const std::vector<DeclaredEntry> &entries);
} // namespace ThermoContact

#endif
