// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_forecast_forecast_h
#define thermocontact_forecast_forecast_h

#include <thermocontact/forecast/first_impact.h>
#include <thermocontact/forecast/steady_state.h>
#include <thermocontact/method/load_history.h>
#include <thermocontact/scene/scene.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /**
   * Names and values of the times that the terms of a scene act on,
   * doc/model.md (M8.1): only those that it has.
   */
  std::vector<std::pair<std::string, double>>
  time_scales(const Scene &scene);



  /**
   * The step size above which the iteration of the paper fails while the rod is
   * in contact: $\rho(\Delta t)=1$ in (D7.2).
   *
   * @return nothing if there is none between 1e-100 and 1e100: obstacles with
   *   $\varepsilon\ge1$ yield more than the rod; and where (D7.2) does not
   *   apply: no inertia, no elastic obstacle, a law that is not linear, more
   *   than one dimension
   */
  std::optional<double>
  critical_step_size(const Scene &scene);



  /** What a run is expected to take and to write. */
  struct ExpectedCost
  {
    double steps          = 0.;
    bool   is_exact       = false; ///< of steps, rows and snapshots
    bool   is_driven      = false; ///< steps follow loads
    double rows           = 0.;    ///< of contact.csv
    double row_bytes      = 0.;    ///< of contact.csv, about
    double snapshots      = 0.;
    double snapshot_bytes = 0.; ///< of all of them, about
    double face_bytes     = 0.; ///< of the contact face, if there is one
    double cpu_seconds    = 0.; ///< of all processes; 0: a rod
  };



  /**
   * Number of steps, exact if they are fixed and nothing shortens them, for
   * error-controlled ones within a factor of about two (doc/accuracy.md), of
   * about three if they follow sources; size of the files that grow with time;
   * processor time of a body.
   *
   * @param loads what error-controlled steps follow of sources
   */
  ExpectedCost
  expected_cost(const Scene &scene, const LoadHistory &loads);



  /** What is known of a run before it is made. */
  struct Forecast
  {
    Forecast(const Scene &scene, const LoadHistory &loads)
      : rest(steady_state(scene))
      , impact(first_impact(scene))
      , critical_step(critical_step_size(scene))
      , cost(expected_cost(scene, loads))
    {}

    SteadyForecast             rest;
    std::optional<FirstImpact> impact;
    std::optional<double>      critical_step;
    ExpectedCost               cost;
  };
} // namespace ThermoContact

#endif
