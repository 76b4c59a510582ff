// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_special_numbers_h
#define thermocontact_base_special_numbers_h

#include <limits>

namespace ThermoContact
{
  inline constexpr double infinity = std::numeric_limits<double>::infinity();

  /** A value that is not known, or not there. */
  inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
} // namespace ThermoContact

#endif
