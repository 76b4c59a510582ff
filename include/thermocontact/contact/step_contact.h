// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_step_contact_h
#define thermocontact_contact_step_contact_h

#include <thermocontact/contact/contact_law.h>

namespace ThermoContact
{
  /**
   * A node on its way through a step in which it has one velocity w. It meets
   * an obstacle in front of it, and perhaps one behind it.
   */
  struct StepPath
  {
    double size; ///< $\Delta t$

    double front;      ///< $s^0$ at the obstacle in front
    double front_rate; ///< mean $g'$ of that one
    double rear;       ///< $s^0$ at the one behind; $-\infty$: there is none

    double free_velocity; ///< w without pressure
    double response;      ///< $\chi$, its loss by a unit pressure

    /** Velocity that is rounding: no obstacle is met with less. */
    double negligible_velocity;
  };



  /** Contact of such a node, doc/contact-in-time.md (C6.10). */
  struct StepContact
  {
    double velocity = 0.; ///< w
    double pressure = 0.; ///< mean $\bar p$; negative behind the node

    /**
     * Elastic pressure at the end of the step, of the same sign; the mean one
     * of a rigid obstacle.
     */
    double end_pressure = 0.;

    /** $\vartheta$: 0 where the step follows the law, 1 on a rigid one. */
    double weight = 0.;

    /** Dissipation by the damping of the obstacle per time, not negative. */
    double damping_power = 0.;
  };



  /**
   * Solves $w=w_{free}-\chi\bar p$ with the mean pressure of the law on the
   * way, (C6.10): for any laws one solution, to rounding.
   */
  StepContact
  solve_step_contact(const ContactLaw &front,
                     const ContactLaw &rear,
                     const StepPath   &path);
} // namespace ThermoContact

#endif
