// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_refusal_h
#define thermocontact_scene_refusal_h

#include <thermocontact/base/exceptions.h>

#include <sstream>
#include <string>

namespace ThermoContact
{
  /**
   * Throws for an entry whose value a pattern accepts but the program does
   * not.
   */
  template <typename Value>
  [[noreturn]] void
  refuse(const std::string &path,
         const Value       &value,
         const std::string &allowed,
         const std::string &remedy)
  {
    std::ostringstream message;
    message << path << " = " << value << "\n  allowed: " << allowed
            << "\n  remedy:  " << remedy;
    throw InputError(message.str());
  }
} // namespace ThermoContact

#endif
