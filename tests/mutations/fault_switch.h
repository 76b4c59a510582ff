// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Included by force in the copy that scripts/mutate builds, and nowhere else.

#ifndef thermocontact_fault_switch_h
#define thermocontact_fault_switch_h

#include <cstdlib>
#include <cstring>

namespace ThermoContactFaults
{
  inline bool
  is_switched_on(const char *const name)
  {
    static const char *const chosen = std::getenv("THERMOCONTACT_FAULT");
    return chosen != nullptr && std::strcmp(chosen, name) == 0;
  }



  /** In place of a member that is not saved: something else of its type. */
  template <typename Value>
  Value &
  lost(const bool is_lost, Value &member)
  {
    static Value other{};
    return is_lost ? other : member;
  }
} // namespace ThermoContactFaults

/** Compares names once, not at every call. */
#define THERMOCONTACT_FAULT(name)                                        \
  ([]() {                                                                \
    static const bool is_on = ThermoContactFaults::is_switched_on(name); \
    return is_on;                                                        \
  }())

#endif
