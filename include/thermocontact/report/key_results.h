// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_key_results_h
#define thermocontact_report_key_results_h

#include <thermocontact/forecast/steady_state.h>
#include <thermocontact/simulation/simulation.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /** How often contact began. */
  unsigned int
  n_contact_begins(const std::vector<ContactEvent> &events);

  /**
   * Total time in contact up to @p time, nondimensional. Begins and ends
   * alternate; contact at t = 0 is a begin.
   */
  double
  contact_duration(const std::vector<ContactEvent> &events,
                   const bool                       is_in_contact,
                   const double                     time);

  /**
   * The velocity of the last release over that of the first impact, with the
   * sign that makes it positive for a body that comes back; NaN without one of
   * the two.
   */
  double
  restitution(const std::vector<ContactEvent> &events);

  /** The end of the body as it is now, as a state of rest has it. */
  SteadyState
  final_state(const StepRecord &record);

  /**
   * The number, from 1, of the state of rest that @p end has reached: the
   * nearest one, if the temperature of the contact end differs from its by at
   * most 1e-3 of the difference of the outer temperatures, and the displacement
   * by at most 1e-3 of the gap or of the largest one at rest; else 0.
   */
  unsigned int
  reached_state_of_rest(const std::vector<SteadyState> &states,
                        const SteadyState              &end,
                        const Scene                    &scene);

  /** Number of key results. */
  constexpr unsigned int n_key_results = 10;

  /**
   * Names of what is asked of a run first, in the order of key_results(): keys
   * of summary.json and columns of study.csv.
   */
  extern const std::array<const char *, n_key_results> key_result_names;

  /**
   * The key results of a run so far, nondimensional: time of the first event;
   * begins of contact; total time in contact; largest force, largest
   * penetration, impulse and restitution; displacement and temperature of the
   * end now; number of the state of rest that is reached. NaN for what there is
   * not.
   */
  template <int dim>
  std::array<double, n_key_results>
  key_results(const Simulation<dim> &simulation);
} // namespace ThermoContact

#endif
