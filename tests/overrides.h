// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_overrides_h
#define thermocontact_tests_overrides_h

#include <string>
#include <vector>

namespace ThermoContact
{
  /** 'Section/Entry=value' each, as read_parameters() takes them. */
  using Overrides = std::vector<std::string>;

  /** Both; of two for one entry the second one's wins. */
  inline Overrides
  operator+(Overrides first, const Overrides &second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }
} // namespace ThermoContact

#endif
