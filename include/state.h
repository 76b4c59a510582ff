// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_state_h
#define thermocontact_state_h

#include <utility>
#include <vector>

#include "types.h"

namespace ThermoContact
{
  /**
   * The body at one time: everything that a time integrator needs to go on.
   * A value: copied, compared, dropped.
   */
  struct State
  {
    double time = 0.;
    Vector temperature;  ///< $\theta$, including the value of the fixed end
    Vector displacement; ///< $u$
    Vector velocity;     ///< $v$

    /** Pressure $p_i\ge0$ at the contact nodes, on all ranks. */
    std::vector<double> contact_pressure;

    /** Exchanges two states without copying or allocating. */
    void
    swap(State &other)
    {
      std::swap(time, other.time);
      temperature.swap(other.temperature);
      displacement.swap(other.displacement);
      velocity.swap(other.velocity);
      contact_pressure.swap(other.contact_pressure);
    }
  };
} // namespace ThermoContact

#endif
