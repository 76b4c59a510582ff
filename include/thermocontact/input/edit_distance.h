// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_edit_distance_h
#define thermocontact_input_edit_distance_h

#include <string>

namespace ThermoContact
{
  /**
   * Number of single-letter insertions, deletions and substitutions that turn
   * one name into the other (Levenshtein distance); upper and lower case are
   * the same.
   */
  unsigned int
  edit_distance(const std::string &a, const std::string &b);
} // namespace ThermoContact

#endif
