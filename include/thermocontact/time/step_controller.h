// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_step_controller_h
#define thermocontact_time_step_controller_h

#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/method/load_history.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** One attempt at a step: a row of steps.csv. */
  struct StepAttempt
  {
    double      time         = 0.; ///< where it starts
    double      size         = 0.;
    double      error        = 0.; ///< relative to the tolerance
    bool        is_accepted  = false;
    std::string reason       = ""; ///< why it ends there or was rejected
    double      wall_seconds = 0.;
  };



  /** The reason of an attempt that is not accurate enough. */
  inline const char *const rejected_by_tolerance = "tolerance";



  /**
   * Why error-controlled steps end, and what to try.
   *
   * @param attempts those so far, the last one at the end
   * @param failure why that could not be computed, or empty
   */
  std::string
  describe_exhaustion(const std::vector<StepAttempt> &attempts,
                      const std::string              &failure,
                      const Parameters               &parameters);



  /** One step of the time loop: from the present time to @p end. */
  struct TimeStep
  {
    /** The reason of the end of the step. */
    enum Target
    {
      none,   ///< nothing: its size is the controller's
      load,   ///< a break of the loads, or the largest step that they allow
      event,  ///< the instant where contact was seen to change
      output, ///< an output time
      finish  ///< $T$
    };

    double size   = 0.; ///< $\Delta t$
    double end    = 0.; ///< time at its end
    Target target = none;

    /** Times whose loads are those within the step at its begin and end. */
    double first_loads = 0., last_loads = 0.;

    bool begins_at_break = false; ///< of a load

    /** Breaks of loads within the step, where it does not have to end. */
    std::vector<LoadBreak> breaks = {};
  };



  /** "ok", "load", "event", "output" or "end", as steps.csv has it. */
  const char *
  name_of(const TimeStep::Target target);



  /** The sizes that error-controlled steps may have, and how they change. */
  struct StepLadder
  {
    /** n of the powers of $2^{1/n}$: more than 1 if factors are cheap. */
    unsigned int rungs_per_octave = 4;

    /**
     * A size stays for many steps, as on a ladder of powers of two: the last
     * error but one says nothing then.
     */
    bool keeps_sizes = false;
  };



  /**
   * Chooses the time steps. Arithmetic only.
   *
   * Fixed steps end at the multiples of $\Delta t$, so that rounding does not
   * accumulate. Error-controlled steps are accepted if their error is not
   * above the tolerance; the next size follows from the last two errors
   * (Gustafsson's PI controller), or from the last one where sizes are to be
   * kept, rounded down to a rung of the ladder so that sizes, and their
   * factorisations, come back. Steps of both kinds are shortened to end at $T$,
   * at a contact event, where loads are not smooth, at output times if these
   * are to be hit; error-controlled ones also to what the loads allow and,
   * behind a jump of prescribed nodal values, to a length of its own. The size
   * from which the next step is derived is not affected.
   */
  class StepController
  {
  public:
    /**
     * @param output whose intervals steps may have to end on
     * @param order of the scheme, for error-controlled steps
     * @param ladder of error-controlled steps
     */
    StepController(const TimeParameters   &time,
                   const OutputParameters &output,
                   const unsigned int      order,
                   const StepLadder       &ladder = {});

    /** Steps are to follow these loads. */
    void
    follow(const LoadHistory &history)
    {
      loads = history;
    }

    /** The loads that steps follow. */
    const LoadHistory &
    followed_loads() const
    {
      return loads;
    }

    /** The step to be tried from @p time on; @p time < $T$. */
    TimeStep
    propose(const double time) const;

    bool
    is_finished(const double time) const
    {
      return time >= end_time;
    }

    /** The first step, if it is to be chosen, is no longer than @p size. */
    void
    limit_first_step(const double size);

    /** The next step ends at @p event_time, which lies within the last one. */
    void
    aim_at(const double event_time);

    /**
     * True if a step with this error, relative to the tolerance, is accurate
     * enough; NaN is not. Fixed steps always are. The first step after contact
     * changed must be more accurate: the solution is not smooth there, and the
     * estimate is less than the error; unless the rounding of times leaves no
     * shorter one.
     */
    bool
    is_accurate(const TimeStep &step, const double error) const
    {
      return !has_error_control || error <= largest_error() ||
             (error <= 1. && is_shortest_step(step));
    }

    /**
     * The step is not accurate enough.
     *
     * @param of_step order of the step; nothing: as the scheme
     */
    void
    reject(const TimeStep                   &step,
           const double                      error,
           const std::optional<unsigned int> of_step = {});

    /** The step is accepted; arguments as there. */
    void
    accept(const TimeStep                   &step,
           const double                      error,
           const std::optional<unsigned int> of_step = {});

    /**
     * The step could not be computed: the next one will be smaller.
     *
     * @return false if steps are fixed, and there is nothing to try
     */
    bool
    retry_smaller(const TimeStep &step);

    /** Factors of restart(): where contact begins, and at all else. */
    static constexpr double at_touch = 0.25, at_change = 0.5;

    /**
     * Contact has changed or a load has jumped: the next motion may be faster.
     * A step is at most @p factor times the size that was chosen for the last
     * one; attempts that were rejected since then may have made it small
     * enough.
     */
    void
    restart(const double factor);

    /**
     * True if there is nothing left to try after @p step, which was not
     * accurate enough or could not be computed: it was not above the smallest
     * size that is allowed, or the next would be below what @p time resolves.
     */
    bool
    is_exhausted(const TimeStep &step, const double time) const;

    /**
     * The memory of an accepted step for the next, for checkpoints: rejections
     * and events that are aimed at are forgotten with accept().
     */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &size &chosen_size &last_error &is_restarting;
    }

  private:
    const bool                has_error_control;
    const bool                chooses_first_step;
    const double              fixed_size;
    const double              end_time;
    const double              minimum_size;
    const double              maximum_size;
    const unsigned int        order;
    const StepLadder          ladder;
    const std::vector<double> landing_intervals;
    LoadHistory               loads;

    double                size; ///< of the next step if nothing shortens it
    double                chosen_size; ///< the same when a step was accepted
    double                last_error;
    bool                  was_rejected;
    bool                  is_restarting; ///< after contact or a load changed
    std::optional<double> event_time;

    /** No shorter one is worth an attempt. */
    static bool
    is_shortest_step(const TimeStep &step)
    {
      return step.size < Tolerances::same_time * step.end;
    }

    double
    largest_error() const
    {
      return is_restarting ? 0.2 : 1.;
    }

    /** The times whose loads a step has at its begin and end. */
    void
    set_load_times(const double time, TimeStep &step) const;

    /** The largest power of $2^{1/n}$ that is not above @p value. */
    double
    rung_below(const double value) const;

    /**
     * Ratio of sizes after a step with this error where sizes are to be kept:
     * a size is doubled if the error leaves room for it, kept as long as steps
     * are accepted with some margin.
     */
    double
    keeping_factor(const double error, const unsigned int of_step) const;

    void
    set_size(const double value);
  };
} // namespace ThermoContact

#endif
