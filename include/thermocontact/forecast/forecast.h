// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_forecast_forecast_h
#define thermocontact_forecast_forecast_h

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/method/load_history.h>
#include <thermocontact/scene/scene.h>

#include <optional>
#include <string>
#include <utility>
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



  /** The first impact of the rod, estimated. */
  struct FirstImpact
  {
    double time     = 0.;
    double velocity = 0.; ///< $u_t(1)>0$ just before

    // largest of the contact; NaN: rigid obstacle, or the scene ends there
    double penetration = nan;
    double force       = penetration;
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



  /**
   * Error-controlled steps of an elastic rod that nothing meets, drives or
   * damps: those of the second run of its wave, each time one runs. A
   * Simulation makes two of them. How many steps a wave takes depends on how
   * smooth the initial values are, and on what the ends carry.
   *
   * @return nothing for other bodies, and where that would cost a fifth of the
   *   run or more
   */
  std::optional<double>
  steps_of_free_waves(const Scene &scene);

  /**
   * Memory of all processes of a run, bytes, in two and three dimensions within
   * a factor of about two, doc/bodies.md: of a process before it computes
   * anything, and of the body; with the direct solver mostly for the factors of
   * the step sizes that are kept. A rod takes next to nothing.
   */
  double
  expected_memory(const Scene &scene, const unsigned int n_ranks);

  /**
   * Processor time of all ranks, seconds, in two and three dimensions within a
   * factor of about two, doc/bodies.md; as measured on the processors of
   * doc/performance.md.
   *
   * @param n_steps of the run
   */
  double
  expected_cpu_seconds(const Scene &scene, const double n_steps);

  /**
   * Refuses a body that would not fit if its forecast were twice too large.
   *
   * @param available bytes, the same on all ranks: so is the decision
   * @param share of the processes that have to do with these
   * @throw InputError with the remedy
   */
  void
  check_memory(const Scene       &scene,
               const unsigned int n_ranks,
               const double       available,
               const double       share);



  /**
   * Names and values of the times that the terms of a scene act on,
   * doc/model.md (M8.1): of terms that it has.
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



  /** The expected steps, time, memory and files of a run. */
  struct ExpectedCost
  {
    double steps     = 0.;
    bool   is_exact  = false; ///< of steps, rows and snapshots
    bool   is_driven = false; ///< steps follow loads
    bool   is_least  = false; ///< contact takes more, nobody knows how many
    double rows      = 0.;    ///< of contact.csv
    double row_bytes = 0.;    ///< of contact.csv, about
    double snapshots = 0.;
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
   * @param loads the sources that error-controlled steps follow
   */
  ExpectedCost
  expected_cost(const Scene &scene, const LoadHistory &loads);



  /** All that is known of a run before it is made. */
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
