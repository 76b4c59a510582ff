// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_stop_watch_h
#define thermocontact_base_stop_watch_h

#include <chrono>

namespace ThermoContact
{
  /**
   * Adds the wall time of its life, in seconds, to a sum: two readings of the
   * clock, about 0.1 us, where a section of dealii::TimerOutput takes 1 us and
   * more.
   */
  class StopWatch
  {
  public:
    /** @p sum is borrowed. */
    explicit StopWatch(double &sum)
      : sum(sum)
      , start(Clock::now())
    {}

    ~StopWatch()
    {
      sum += std::chrono::duration<double>(Clock::now() - start).count();
    }

    StopWatch(const StopWatch &) = delete;

    StopWatch &
    operator=(const StopWatch &) = delete;

  private:
    using Clock = std::chrono::steady_clock;

    double                 &sum;
    const Clock::time_point start;
  };



  /** Where the wall time of a run went, in seconds. */
  struct RunTimes
  {
    double set_up  = 0.;
    double loop    = 0.; ///< steps and CSV rows
    double steps   = 0.; ///< part of loop: all attempts at steps
    double output  = 0.; ///< snapshots
    double repeats = 0.; ///< for error bars
    double wall    = 0.; ///< from the start of the program
  };
} // namespace ThermoContact

#endif
