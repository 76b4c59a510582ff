// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_progress_h
#define thermocontact_report_progress_h

#include <thermocontact/base/log.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/simulation/run_history.h>

#include <chrono>

namespace ThermoContact
{
  /**
   * Tells how far a run has come. An observer of a Simulation, without
   * collective calls.
   *
   * On a terminal it is a live line, at most ten times a second: percent, time,
   * step size, gap or contact force, steps per second so far, and the remaining
   * wall time if the rest of the time goes as fast. Whenever
   * another tenth of the run is done, a line goes to log.txt and, where there
   * is no live line, to the screen, with the remaining time if that is more
   * than a minute.
   */
  class Progress
  {
  public:
    /**
     * @param scene borrowed
     * @param history before the run
     * @param log borrowed
     */
    Progress(const Scene &scene, const RunHistory &history, Log &log);

    void
    observe(const RunHistory &history);

  private:
    using Clock = std::chrono::steady_clock;

    const Scene            &scene;
    Log                    &log;
    const OutputUnits       units;
    const Clock::time_point start;
    const StepRecord        first; ///< from which the run goes on
    Clock::time_point       last_update;

    /** Wall time if the rest of the time goes as fast as that so far. */
    double
    seconds_left(const StepRecord &record) const;

    void
    report_tenth(const StepRecord &record);

    void
    update_live_line(const StepRecord &record);
  };
} // namespace ThermoContact

#endif
