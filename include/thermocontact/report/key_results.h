// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_key_results_h
#define thermocontact_report_key_results_h

#include <thermocontact/forecast/forecast.h>
#include <thermocontact/simulation/run_history.h>

#include <map>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** The energy that the audit (D4.1) up to @p record started from. */
  double
  starting_energy(const StepRecord &record);

  /** Displacement of the end to look at, nondimensional: 0 where it is rounding
   * of the strain that the force makes, as between walls. */
  double
  shown_displacement(const StepRecord &record);

  /** Gap to look at, likewise, and 0 where it is rounding of the displacement.
   */
  double
  shown_gap(const StepRecord &record);

  /** The end of the body as it is now, as a steady state has it, with
   * shown_displacement(). */
  SteadyState
  final_state(const StepRecord &record);

  /**
   * The results that users ask for first, each by its key in summary.json;
   * nondimensional, NaN for a result that there is not.
   */
  using KeyResults = std::map<std::string, double>;

  /** Their names, in the order of study.csv, which has all of them. */
  const std::vector<std::string> &
  key_result_names();

  /**
   * Key results with error bars, for which the keys of summary.json add
   * "_time_error" and "_space_error".
   */
  const std::vector<std::string> &
  results_with_error_bars();

  /** The key results of a run so far. */
  KeyResults
  key_results(const Scene &scene, const RunHistory &history);

  /**
   * The same, but with the largest force and penetration between step ends as
   * far as the step ends tell, (D9.2): results that change with the accuracy of
   * a run, but not with the places where steps end.
   */
  KeyResults
  smooth_key_results(const Scene &scene, const RunHistory &history);

  /** Error bars of the key results that have some. */
  struct KeyErrors
  {
    KeyResults               time;  ///< NaN: not known
    KeyResults               space; ///< NaN: not known
    std::vector<std::string> remarks;
    unsigned int             n_repeats = 0;
  };
} // namespace ThermoContact

#endif
