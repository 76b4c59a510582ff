// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_scope_page_h
#define thermocontact_input_scope_page_h

#include <string>

namespace ThermoContact
{
  /** doc/scope.md: parts that the model has, parts that it lacks, remedies. */
  extern const char *const scope_page;

  /**
   * The answer of the table of @ref scope_page to @p name, which is the name of
   * no entry and no section: lines "answer:" and "remedy:" of a message, each
   * behind a line break; nothing where no row has a word of the name.
   */
  std::string
  scope_answer(const std::string &name);
} // namespace ThermoContact

#endif
