// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_words_of_kinds_h
#define thermocontact_input_words_of_kinds_h

#include <string>
#include <vector>

namespace ThermoContact
{
  /** The names of all kinds, separated by '|', as a Selection has them. */
  template <typename Kind>
  std::string
  names_of(const std::vector<Kind> &kinds)
  {
    std::string names;
    for (const Kind &kind : kinds)
      names += (names.empty() ? "" : "|") + kind.name;
    return names;
  }



  /** The names of all kinds with what is to be said of each. */
  template <typename Kind, typename Say>
  std::string
  in_words(const std::vector<Kind> &kinds, const Say &say)
  {
    std::string words;
    for (unsigned int i = 0; i < kinds.size(); ++i)
      words += (i == 0                ? "" :
                i + 1 == kinds.size() ? " or " :
                                        ", ") +
               kinds[i].name + say(kinds[i]);
    return words;
  }
} // namespace ThermoContact

#endif
