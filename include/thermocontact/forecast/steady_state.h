// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_forecast_steady_state_h
#define thermocontact_forecast_steady_state_h

#include <thermocontact/scene/scene.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The end of a body at rest, doc/model.md (M3.1), (M5.2); NaN: no such field.
   */
  struct SteadyState
  {
    double displacement_end = 0.;
    double contact_force    = 0.; ///< per unit cross-section
    double temperature_end  = 0.;
    bool   in_contact       = false;

    /** Small disturbances do not grow without oscillating, (M5.3). */
    bool is_stable = true;
  };



  /** Where a scene comes to rest, as far as that is known in closed form. */
  struct SteadyForecast
  {
    /**
     * By falling temperature of the end, if that of the obstacle is below. One,
     * but for a heat exchange that depends on the contact.
     */
    std::vector<SteadyState> states;

    /** Why there is none, or how it is approached; may be empty. */
    std::string remark;
  };



  /**
   * The steady state (M3.1) that a run tends to, which does not depend on the
   * initial values, or, with a heat exchange that depends on the contact, all
   * of them, (M5.2). None with sources, with free lateral faces, and for a body
   * that nothing damps.
   */
  SteadyForecast
  steady_state(const Scene &scene);



  /** The one with the nearest temperature of the end, or displacement. */
  unsigned int
  nearest_state(const std::vector<SteadyState> &states,
                const SteadyState              &state);
} // namespace ThermoContact

#endif
