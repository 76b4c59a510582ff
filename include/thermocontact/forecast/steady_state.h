// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_forecast_steady_state_h
#define thermocontact_forecast_steady_state_h

#include <thermocontact/scene/scene.h>

#include <optional>
#include <string>

namespace ThermoContact
{
  /** The end of a body at rest, doc/model.md (M.10); NaN: no such field. */
  struct SteadyState
  {
    double displacement_end = 0.;
    double contact_force    = 0.; ///< per unit cross-section
    double temperature_end  = 0.;
    bool   in_contact       = false;
  };



  /** Where a scene comes to rest, as far as that is known in closed form. */
  struct SteadyForecast
  {
    std::optional<SteadyState> state;

    /** Why there is none, or how it is approached; may be empty. */
    std::string remark;
  };



  /**
   * The steady state (M.10) that a run tends to. It does not depend on the
   * initial values. None with sources, with free lateral faces, and for a body
   * that nothing damps.
   */
  SteadyForecast
  steady_state(const Scene &scene);



  /** $G$ of (M.10), the free expansion of the steady temperature. */
  double
  free_expansion(const Scene &scene);
} // namespace ThermoContact

#endif
