// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_text_h
#define thermocontact_base_text_h

#include <sstream>
#include <string>

namespace ThermoContact
{
  /** Concatenates its arguments as a stream prints them. */
  template <typename... Arguments>
  std::string
  text(const Arguments &...arguments)
  {
    std::ostringstream stream;
    (stream << ... << arguments);
    return stream.str();
  }
} // namespace ThermoContact

#endif
