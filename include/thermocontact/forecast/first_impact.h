// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_forecast_first_impact_h
#define thermocontact_forecast_first_impact_h

#include <thermocontact/scene/scene.h>

#include <optional>

namespace ThermoContact
{
  /** What the rod does at its first impact, estimated. */
  struct FirstImpact
  {
    double time        = 0.;
    double velocity    = 0.; ///< $u_t(1)>0$ just before
    double penetration = 0.; ///< largest of the contact; 0: rigid obstacle
    double force       = 0.; ///< largest of the contact; none if rigid
  };



  /**
   * Estimates the first impact of a rod that its initial values throw against
   * the obstacle, or its temperatures move there, within the time of a few
   * waves, by a Simulation on a few cells, doc/model.md (M8.4).
   *
   * @return nothing where that would not be honest: no inertia or no obstacle,
   *   a damped one or one behind, more than one dimension, sources, initial
   *   contact, no impact before the end time or within these waves
   */
  std::optional<FirstImpact>
  first_impact(const Scene &scene);

} // namespace ThermoContact

#endif
