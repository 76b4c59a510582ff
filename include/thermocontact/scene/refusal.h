// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_refusal_h
#define thermocontact_scene_refusal_h

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>

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
    throw InputError(text(
      path, " = ", value, "\n  allowed: ", allowed, "\n  remedy:  ", remedy));
  }
} // namespace ThermoContact

#endif
