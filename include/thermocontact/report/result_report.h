// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_result_report_h
#define thermocontact_report_result_report_h

#include <thermocontact/base/log.h>
#include <thermocontact/base/stop_watch.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/report/key_results.h>
#include <thermocontact/time/stage_solver.h>

#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * A warning of fixed steps that took more than a twentieth of the
   * energy that was there at first or came by work, or missed the forecast of
   * the first impact by more than a step.
   *
   * @param impact as forecast; asked for with fixed steps alone
   */
  std::vector<std::string>
  step_warnings(const Scene                      &scene,
                const std::optional<FirstImpact> &impact,
                const RunHistory                 &history);

  /** All warnings of a run that has ended; warnings of its steps come last. */
  std::vector<std::string>
  run_warnings(const Scene                      &scene,
               const std::optional<FirstImpact> &impact,
               const RunHistory                 &history);

  /**
   * Prints contacts, the final state beside the steady state that the scene
   * tends to, the energy audit, and what the run cost.
   *
   * @param initial_energy starting_energy() of the state that this process
   *   began with
   */
  void
  report_result(const Scene          &scene,
                const Forecast       &forecast,
                const RunHistory     &history,
                const SolverCounters &counters,
                const RunTimes       &times,
                const double          initial_energy,
                Log                  &log);

  /** Prints each key result as value, error in time, error in space. */
  void
  report_errors(const Scene      &scene,
                const RunHistory &history,
                const KeyErrors  &errors,
                Log              &log);
} // namespace ThermoContact

#endif
