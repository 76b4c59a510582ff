// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_mass_impact_h
#define thermocontact_contact_mass_impact_h

#include <vector>

namespace ThermoContact
{
  /** Two rigid masses, or one before an obstacle, in a step, (M10.6). */
  struct MassPath
  {
    double size;         ///< $\Delta t$
    double penetration;  ///< at the start, not positive
    double velocity;     ///< at the start, into the contact
    double acceleration; ///< without contact
    bool   is_closed;    ///< in lasting contact at the start
    double restitution;  ///< $e$
  };



  /** How it ends. */
  struct MassImpacts
  {
    double penetration;
    double velocity;

    /** Change of the velocity by contact, negative. */
    double change;

    /** Sum of $\frac12(1-e^2)v^2$, what impacts take of the energy per mass. */
    double loss;

    bool   is_closed;   ///< in lasting contact at the end
    double change_time; ///< since the start, where lasting contact begins or
                        ///< ends; meaningless if it does neither

    /** One that does not last: when it was, and with what velocity. */
    struct Impact
    {
      double time;
      double velocity; ///< before it
    };

    std::vector<Impact> impacts;
  };



  /**
   * The path in closed form: parabolas, after each impact $e$ times the
   * velocity back. Bounces that get shorter and end within the step, after
   * $2ev/(a(1-e))$ from the first, end in lasting contact there.
   */
  MassImpacts
  follow_masses(const MassPath &path);
} // namespace ThermoContact

#endif
