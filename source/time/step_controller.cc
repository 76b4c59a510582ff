// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/multiples.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/time/step_controller.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ThermoContact
{
  const char *
  name_of(const TimeStep::Target target)
  {
    switch (target)
      {
        case TimeStep::load:
          return "load";
        case TimeStep::event:
          return "event";
        case TimeStep::output:
          return "output";
        case TimeStep::finish:
          return "end";
        default:
          return "ok";
      }
  }



  namespace
  {
    /**
     * Of those since the last step that was accepted the one with the smallest
     * error, if that has grown much since then while steps became much smaller.
     */
    std::optional<StepAttempt>
    attempt_before_rounding(const std::vector<StepAttempt> &attempts)
    {
      constexpr double   much = 100.;
      const StepAttempt &last = attempts.back();
      const StepAttempt *best = &last;
      for (auto a = attempts.rbegin(); a != attempts.rend() && !a->is_accepted;
           ++a)
        if (a->reason == rejected_by_tolerance && a->error < best->error)
          best = &*a;
      if (best->error * much <= last.error && last.size * much <= best->size)
        return *best;
      return {};
    }
  } // namespace



  std::string
  describe_exhaustion(const std::vector<StepAttempt> &attempts,
                      const std::string              &failure,
                      const Parameters               &parameters)
  {
    const StepAttempt &last = attempts.back();
    const auto         time = [&](const double value) {
      return QuantityUnits(parameters).text("time", value);
    };
    std::ostringstream message;
    message << "no step is accepted, the last one tried had size "
            << time(last.size) << ": ";
    if (!failure.empty())
      {
        message << failure;
        return message.str();
      }
    message << "its error is " << last.error
            << " times the tolerance (1 is allowed, 0.2 after an event)";
    if (const auto best = attempt_before_rounding(attempts))
      message << ", of size " << time(best->size) << " it was " << best->error
              << ": rounding makes smaller steps worse";
    else if (last.size < Tolerances::same_time * last.time)
      message << ", and times that are closer cannot be told apart";
    message
      << "\n  remedy:  a larger Time/Tolerance, Time/Break points where "
         "loads jump, or a smaller Time/Minimum step size if one is given";
    return message.str();
  }



  StepController::StepController(const TimeParameters   &time,
                                 const OutputParameters &output,
                                 const unsigned int      order,
                                 const StepLadder       &ladder)
    : has_error_control(time.has_error_control())
    , chooses_first_step(has_error_control && !time.first_step_size)
    , fixed_size(time.step_size.value_or(0.))
    , end_time(time.end_time)
    , minimum_size(time.minimum_step_size)
    , maximum_size(time.maximum_step_size)
    , order(order)
    , ladder(ladder)
    , landing_intervals(output.landing_intervals())
    , size(fixed_size)
    , chosen_size(size)
    , last_error(1.)
    , was_rejected(false)
    , is_restarting(false)
  {
    if (!has_error_control)
      return;
    // A guess in the time unit of the heat equation; the error estimate of
    // the first step corrects it.
    const double guess = 0.05 * std::pow(time.tolerance, 1. / order);
    size =
      std::min(time.first_step_size.value_or(rung_below(guess)), maximum_size);
    chosen_size = size;
  }



  double
  StepController::rung_below(const double value) const
  {
    if (!(value > 0.) || value == infinity)
      return value;
    int                exponent = 0;
    const double       mantissa = std::frexp(value, &exponent); // in [1/2, 1)
    double             rung     = 0.5;
    const unsigned int n        = ladder.rungs_per_octave;
    for (unsigned int i = 1; i < n; ++i)
      if (const double next = 0.5 * std::pow(2., double(i) / n);
          next <= mantissa)
        rung = next;
    return std::ldexp(rung, exponent);
  }



  void
  StepController::set_size(const double value)
  {
    // closer to the nearest than to the next one below: sizes that settle stay
    size =
      std::max(std::min(rung_below(1.1 * value), maximum_size), minimum_size);
  }



  TimeStep
  StepController::propose(const double time) const
  {
    TimeStep step{size, time + size, TimeStep::none};
    if (!has_error_control)
      {
        // between multiples the size, and with it the factorisation, is kept
        const double number = whole_intervals(fixed_size, time);
        step.end            = (number + 1.) * fixed_size;
        if (time != number * fixed_size)
          step.size = step.end - time;
      }
    else if (const double largest = loads.largest_step(time, size);
             largest < size)
      {
        step.size = std::max(rung_below(largest), std::min(minimum_size, size));
        step.end  = time + step.size;
        step.target = TimeStep::load;
      }
    const double margin = Tolerances::multiple_slack * step.size;
    const auto   end_at = [&](const double end, const TimeStep::Target target) {
      const double remainder = end - time;
      if (has_error_control || std::abs(end - step.end) > margin)
        step.size = remainder;
      step.end    = end;
      step.target = target;
    };

    if (step.end >= end_time - margin)
      end_at(end_time, TimeStep::finish);
    if (const LoadBreak *next = loads.next_break(time);
        next != nullptr && next->time < end_time - margin &&
        next->time <= step.end + margin)
      end_at(next->time, TimeStep::load);
    for (const double interval : landing_intervals)
      if (const double end = next_multiple(interval, time);
          end < step.end - margin)
        end_at(end, TimeStep::output);
    if (event_time && *event_time < step.end)
      end_at(*event_time, TimeStep::event);
    set_load_times(time, step);
    return step;
  }



  void
  StepController::set_load_times(const double time, TimeStep &step) const
  {
    const LoadBreak *begin = loads.break_at(time);
    const LoadBreak *end   = loads.break_at(step.end);
    step.begins_at_break   = begin != nullptr;
    step.first_loads       = begin == nullptr ? time : begin->new_time;
    step.last_loads        = end == nullptr ? step.end : end->old_time;
    step.breaks            = loads.breaks_within(time, step.end);
  }



  void
  StepController::limit_first_step(const double largest)
  {
    if (chooses_first_step && largest < size)
      chosen_size = size = std::max(rung_below(largest), minimum_size);
  }



  void
  StepController::aim_at(const double time)
  {
    event_time = time;
  }



  void
  StepController::reject(const TimeStep                   &step,
                         const double                      error,
                         const std::optional<unsigned int> of_step)
  {
    was_rejected = true;
    const double factor =
      std::isfinite(error) ?
        0.9 * std::pow(error / largest_error(), -1. / of_step.value_or(order)) :
        0.;
    set_size(step.size *
             std::min(std::max(factor, is_restarting ? 0.05 : 0.2), 0.8));
  }



  double
  StepController::keeping_factor(const double       error,
                                 const unsigned int of_step) const
  {
    const double factor = 0.75 * std::pow(error, -1. / of_step);
    return error <= 0.8 ? std::max(factor, 1.) : factor;
  }



  void
  StepController::accept(const TimeStep                   &step,
                         const double                      error,
                         const std::optional<unsigned int> of_step)
  {
    event_time.reset();
    if (!has_error_control)
      return;
    const double e      = std::max(error, Tolerances::smallest_error);
    const double p      = of_step.value_or(order);
    double       factor = ladder.keeps_sizes ? keeping_factor(e, p) :
                                               0.9 * std::pow(e, -0.8 / p) *
                                           std::pow(last_error, 0.3 / p);
    factor = std::min(std::max(factor, 0.2), was_rejected ? 1. : 4.);
    // A shortened step says that the next may be longer or must be shorter
    // than itself; it does not make a size smaller that it did not try.
    if (step.target == TimeStep::none || factor < 1. ||
        factor * step.size > size)
      set_size(factor * step.size);
    chosen_size   = size;
    last_error    = e;
    was_rejected  = false;
    is_restarting = false;
  }



  bool
  StepController::retry_smaller(const TimeStep &step)
  {
    was_rejected = true;
    if (has_error_control)
      set_size(0.25 * step.size);
    return has_error_control;
  }



  void
  StepController::restart(const double factor)
  {
    event_time.reset();
    is_restarting = true;
    if (has_error_control)
      set_size(std::min(size, factor * chosen_size));
  }



  bool
  StepController::is_exhausted(const TimeStep &step, const double time) const
  {
    return has_error_control &&
           (step.size <= (1. + Tolerances::multiple_slack) * minimum_size ||
            size < 4. * std::numeric_limits<double>::epsilon() * time ||
            size < std::numeric_limits<double>::min());
  }
} // namespace ThermoContact
