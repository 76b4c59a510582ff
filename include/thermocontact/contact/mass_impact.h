// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_mass_impact_h
#define thermocontact_contact_mass_impact_h

#include <thermocontact/base/special_numbers.h>

#include <vector>

namespace ThermoContact
{
  /** A rigid mass as what it can meet sees it, another mass or an obstacle;
   * what is positive leads into that. */
  struct MassMotion
  {
    double penetration  = -infinity; ///< not positive; infinite: it never meets
    double velocity     = 0.;
    double acceleration = 0.; ///< without contact
  };



  /** Two rigid masses, or one before an obstacle and perhaps with one behind
   * it, in a step, (M10.6). */
  struct MassPath
  {
    double     size; ///< $\Delta t$
    MassMotion front, rear;

    /** In lasting contact at the start: 1 in front, -1 behind; 0: in none. */
    int held_at;

    double restitution; ///< $e$
  };



  /** How it ends. */
  struct MassImpacts
  {
    double penetration; ///< in front
    double velocity;    ///< into what is in front

    /** Change of the velocity by contact; negative by what is in front. */
    double change;

    /** Sum of $\frac12(1-e^2)v^2$, what impacts take of the energy per mass. */
    double loss;

    int    held_at;     ///< in lasting contact at the end, as MassPath has it
    double change_time; ///< since the start, where lasting contact begins or
                        ///< ends; meaningless if it does neither

    /** One that does not last. */
    struct Impact
    {
      double time;
      double velocity; ///< before it, into what it meets
      int    side;     ///< 1: in front, -1: behind
    };

    std::vector<Impact> impacts;
  };



  /**
   * The path in closed form: parabolas, after each impact $e$ times the
   * velocity back. Bounces that get shorter and end within the step, after
   * $2ev/(a(1-e))$ from the first, end in lasting contact there.
   *
   * @throw ComputationError if the mass goes to and fro between two obstacles
   *   too often in the step
   */
  MassImpacts
  follow_masses(const MassPath &path);
} // namespace ThermoContact

#endif
