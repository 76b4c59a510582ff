// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_key_results_h
#define thermocontact_report_key_results_h

#include <thermocontact/forecast/steady_state.h>
#include <thermocontact/simulation/run_history.h>

#include <array>
#include <string>
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

  /** The energy that the audit (D4.1) up to @p record started from. */
  double
  starting_energy(const StepRecord &record);

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

  /** What is asked of a run first. */
  struct KeyResult
  {
    enum Name : unsigned int
    {
      first_contact_time, ///< of the first event
      contact_begins,
      contact_duration, ///< altogether
      max_contact_force,
      max_penetration,
      contact_impulse,
      restitution,
      final_displacement_end,
      final_temperature_end,
      reached_state_of_rest, ///< its number, from 1
      n_names
    };
  };

  /** Keys of summary.json and columns of study.csv. */
  extern const std::array<const char *, KeyResult::n_names> key_result_names;

  /**
   * Those that have error bars, for which the keys of summary.json add
   * "_time_error" and "_space_error".
   */
  constexpr std::array<KeyResult::Name, 6> results_with_error_bars = {
    {KeyResult::first_contact_time,
     KeyResult::max_contact_force,
     KeyResult::max_penetration,
     KeyResult::contact_impulse,
     KeyResult::final_displacement_end,
     KeyResult::final_temperature_end}};

  /** By KeyResult::Name, nondimensional; NaN for what there is not. */
  using KeyResults = std::array<double, KeyResult::n_names>;

  /** The key results of a run so far. */
  KeyResults
  key_results(const Scene &scene, const RunHistory &history);

  /**
   * The same, but with the largest force and penetration between step ends as
   * far as the step ends tell, (D9.2): what changes with the accuracy of a run
   * without the luck of where steps end.
   */
  KeyResults
  smooth_key_results(const Scene &scene, const RunHistory &history);

  /** Error bars of those that have some. */
  struct KeyErrors
  {
    KeyResults               time;  ///< NaN: not known
    KeyResults               space; ///< NaN: not known
    std::vector<std::string> remarks;
    unsigned int             n_repeats = 0;
  };
} // namespace ThermoContact

#endif
