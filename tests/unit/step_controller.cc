// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step sizes. StepController of order 4: sizes as 4 log2, integers on the
// ladder. With error e the next size is 0.9 e^(-1/5) e_old^(3/40) times the
// last, within (0.2, 4), e_old = 1 at the start, 0.9 e^(-1/4) within (0.2, 0.8)
// after a rejection, times 1.1, rounded down. From 2^-8 = 2^(-32/4):
//   e = 1:     0.99: -33;            e = 0.9:  1.011: -32;
//   e = 0:     4 (clipped): -24;     rejected, e = 16: 0.495 < 1/2: -37,
//   then e = 0: not larger: -37;     rejected, e = 1.0001: 0.88: -33;
//   rejected, not a number: 0.22: -41;
//   e = 0.01: 2.487: -27, then e = 0.5: 0.9 1.1487 0.7079 1.1 = 0.805: -29;
//   e = 0, then 1: 0.2 (clipped): -33.
// Where contact begins or ends -40 or -36, where 0.2 is allowed: then rejected
// with e = 3.2, 16 times as much, 0.495; a NaN 0.055: -57 or -53.
// A step of order 3, with e = 0.01: 0.9 e^(-0.8/3) 1.1 = 3.38: -25; rejected
// with e = 16: 0.9 16^(-1/3) 1.1 = 0.393: -38. Where contact begins after a
// step that was rejected with e = 16, -37, a quarter of the size before is -40;
// that it ends at once again asks for half of it, which the step already is;
// rejected with a NaN, -41, it is small enough for both. Steps of at most 0.25
// to T = 0.7, landing on multiples of 0.4, 0.5 and 0.6; of 0.1 to 1, where
// rounding makes no eleventh, to 0.05 and to 0. Smallest step 0.001: a quarter
// of 2^-8 is below it, so that 0.001 is tried, and nothing after it. First step
// 0.05 tol^(1/4) = 0.005 with tolerance 1e-4: -31. On a ladder of powers of two
// the next size is 0.75 e^(-1/4) times the last, but not less than it for e <=
// 0.8, times 1.1, rounded down; from -32:
//   e = 0.03: 1.98: -32;             e = 0.025: 2.07: -28;
//   e = 0.8: 1.1: -32;               e = 0.9: 0.85: -36;
//   e = 0: 4 (clipped): -24;         rejected, e = 16: 0.495: -40.
// Nodes that follow a jump, in steps of 1e-11: error 5 is too large, and in a
// shorter step after it 4.4 and 5.6, but not 4.6 and 5.4, which are 5 within a
// tenth; 5 is too large if contact changes in between, after the jump, in the
// step that follows, in which nothing jumps, and in the same step again. What
// was rejected is forgotten behind the jump: error 0 makes that step 4 times as
// long.
// At most the largest size, whether it is chosen or given: 0.001, 0.1.
// A time is on a multiple of an interval if it is less than 1e-6 intervals
// away: 1 - 1e-7 is on 1 (of intervals of 1), 1 - 1e-5 is not, and 1 + 1e-5 has
// begun the second; 0.3/0.1 < 3 in doubles. Steps of 0.25 (1 - 1e-7) to T = 1,
// landing on multiples of 0.25: step n ends n/4 1e-7 early and has landed on
// multiple n; were it not, a step of n/4 1e-7 would follow. Four steps. As
// steps that are counted: T/dt = 4 (1 + 1e-7), 4; with dt = 0.25 (1 - 1e-5): 5.
// No step is accepted: with error 2 of size 0.015 after one that is accepted,
// and 200, a hundred times as much, of 1e-4, rounding, but not with 1.5 of
// 0.007, less than a hundred times as long; 1e-14 is rounding of 0.5.

#include <thermocontact/base/multiples.h>
#include <thermocontact/time/step_controller.h>

#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  /** Error-controlled from 2^-8, order 4. */
  Parameters
  from_rung()
  {
    Parameters parameters           = read_parameters("");
    parameters.time.end_time        = 1.;
    parameters.time.first_step_size = 1. / 256.;
    return parameters;
  }



  StepController
  make_controller(const Parameters &parameters)
  {
    return StepController(parameters.time, parameters.output, 4);
  }



  /** The step from 0 on with this error. */
  bool
  accurate(const StepController &controller, const double error)
  {
    return controller.is_accurate(controller.propose(0.), error);
  }



  double
  rung(const StepController &controller)
  {
    return 4. * std::log2(controller.propose(0.).size);
  }



  void
  test_ladder()
  {
    for (const std::vector<double> &errors :
         {std::vector<double>{1.}, {0.9}, {0.}, {0.01, 0.5}, {0., 1.}})
      {
        StepController controller = make_controller(from_rung());
        for (const double error : errors)
          {
            controller.accept(controller.propose(0.), error);
            deallog << "accepted, error " << error << ": " << rung(controller)
                    << ' ';
          }
        deallog << std::endl;
      }
    for (const double error :
         {16., 1.0001, std::numeric_limits<double>::quiet_NaN()})
      {
        StepController controller  = make_controller(from_rung());
        const bool     is_accurate = accurate(controller, error);
        controller.reject(controller.propose(0.), error);
        deallog << "accurate " << is_accurate
                << ", rejected: " << rung(controller);
        controller.accept(controller.propose(0.), 0.);
        deallog << ", then accepted: " << rung(controller) << std::endl;
      }
    for (const double error : {0.03, 0.025, 0.8, 0.9, 0., 16.})
      {
        const Parameters parameters = from_rung();
        StepController   controller(parameters.time,
                                  parameters.output,
                                  4,
                                  {1, true});
        if (accurate(controller, error))
          controller.accept(controller.propose(0.), error);
        else
          controller.reject(controller.propose(0.), error);
        deallog << "powers of two, error " << error << ": " << rung(controller)
                << std::endl;
      }
    Parameters parameters     = read_parameters("");
    parameters.time.tolerance = 1e-4;
    deallog << "first step: " << rung(make_controller(parameters));
    parameters.time.maximum_step_size = 0.001;
    deallog << ", at most " << make_controller(parameters).propose(0.).size;
    parameters.time.first_step_size   = 0.25;
    parameters.time.maximum_step_size = 0.1;
    deallog << ", given " << make_controller(parameters).propose(0.).size
            << std::endl;
    for (const bool begins : {true, false})
      {
        StepController controller = make_controller(from_rung());
        controller.aim_at(1e-4); // no longer
        controller.restart(begins ? StepController::at_touch :
                                    StepController::at_change);
        deallog << (begins ? "after begin: " : "after end: ")
                << rung(controller) << ", accurate with error 0.2 "
                << accurate(controller, 0.2) << ", 0.3 "
                << accurate(controller, 0.3) << ", rejected:";
        for (const double error :
             {3.2, std::numeric_limits<double>::quiet_NaN()})
          {
            StepController other(controller);
            other.reject(other.propose(0.), error);
            deallog << ' ' << rung(other);
          }
        controller.accept(controller.propose(0.), 0.1);
        deallog << ", one step later " << accurate(controller, 0.3)
                << std::endl;
      }
    parameters                        = from_rung();
    parameters.time.minimum_step_size = 1e-3;
    StepController controller         = make_controller(parameters);
    deallog << "exhausted "
            << controller.is_exhausted(controller.propose(0.), 0.);
    controller.retry_smaller(controller.propose(0.));
    deallog << ", then " << controller.propose(0.).size << ": exhausted "
            << controller.is_exhausted(controller.propose(0.), 0.) << std::endl;
    // below 4 roundings of the time, or the smallest number with all digits
    const double epsilon  = std::numeric_limits<double>::epsilon();
    const double smallest = std::numeric_limits<double>::min();
    for (const auto &[size, time] : {std::make_pair(2. * epsilon, 0.4),
                                     {2. * epsilon, 0.6},
                                     {1.5 * smallest, 0.},
                                     {0.75 * smallest, 0.}})
      {
        parameters                      = from_rung();
        parameters.time.first_step_size = size;
        deallog << make_controller(parameters).is_exhausted({size}, time)
                << ' ';
      }
    deallog << std::endl;
  }



  /** The ends of all steps. */
  void
  print_steps(const std::string &name, const Parameters &parameters)
  {
    StepController controller = make_controller(parameters);
    double         time       = 0.;
    deallog << name << ':';
    while (!controller.is_finished(time))
      {
        const TimeStep step = controller.propose(time);
        controller.accept(step, 0.);
        time = step.end;
        deallog << ' ' << time
                << (step.target == TimeStep::output ? " output" :
                    step.target == TimeStep::finish ? " end" :
                                                      "");
      }
    deallog << ", misses T by "
            << within(std::abs(time - parameters.time.end_time), 0.)
            << std::endl;
  }



  void
  test_targets()
  {
    Parameters parameters             = read_parameters("");
    parameters.time.end_time          = 0.7;
    parameters.time.first_step_size   = 0.25;
    parameters.time.maximum_step_size = 0.25;
    print_steps("error-controlled", parameters);
    parameters.output.land_on_times       = true;
    parameters.output.fields_interval     = 0.6;
    parameters.output.contact_interval    = 0.4;
    parameters.output.space_time_interval = 0.5;
    print_steps("landing", parameters);
    parameters.output.land_on_times = false;
    parameters.time.step_size       = 0.3;
    print_steps("fixed", parameters);
    parameters.time.step_size = 0.1;
    for (const double end_time : {1., 0.05, 0.})
      {
        parameters.time.end_time = end_time;
        print_steps("fixed", parameters);
      }
    StepController fixed = make_controller(parameters);
    deallog << "a fixed step is "
            << (fixed.retry_smaller({0.3, 0.3}) ? "retried" : "not retried")
            << std::endl;

    for (const double error : {0.5, 1.}) // allow 1.03 and 0.9 times 0.001
      {
        StepController controller = make_controller(from_rung());
        controller.aim_at(0.001);
        const TimeStep step = controller.propose(0.);
        deallog << "aimed: " << step.end << ", at an event "
                << (step.target == TimeStep::event);
        controller.accept(step, error);
        deallog << ", then " << rung(controller) << std::endl;
      }
  }



  void
  test_multiples()
  {
    for (const double time : {0., 1. - 1e-5, 1. - 1e-7, 1. + 1e-7, 1. + 1e-5})
      deallog << "whole " << whole_intervals(1., time) << ", until "
              << intervals_until(1., time) << ", next "
              << next_multiple(1., time) << std::endl;
    deallog << "rounding: " << whole_intervals(0.1, 0.3) << ' '
            << intervals_until(0.1, 0.3)
            << "; before the first: " << intervals_until(1e9, 1.) << std::endl;

    Parameters parameters              = read_parameters("");
    parameters.time.end_time           = 1.;
    parameters.time.step_size          = 0.25 * (1. - 1e-7);
    parameters.output.land_on_times    = true;
    parameters.output.fields_interval  = 0.;
    parameters.output.contact_interval = 0.25;
    StepController controller          = make_controller(parameters);
    deallog << "expected " << parameters.time.n_steps() << ", multiples";
    for (double time = 0.; !controller.is_finished(time);)
      {
        const TimeStep step = controller.propose(time);
        controller.accept(step, 0.);
        time = step.end;
        deallog << ' ' << whole_intervals(0.25, time);
      }
    parameters.time.step_size = 0.25 * (1. - 1e-5);
    deallog << "; expected " << parameters.time.n_steps() << std::endl;
  }



  void
  test_orders()
  {
    StepController accepted = make_controller(from_rung());
    accepted.accept(accepted.propose(0.), 0.01, 3);
    StepController rejected = make_controller(from_rung());
    rejected.reject(rejected.propose(0.), 16., 3);
    deallog << "order 3: accepted " << rung(accepted) << ", rejected "
            << rung(rejected) << std::endl;
  }



  void
  test_rejected_switches()
  {
    for (const double error : {16., std::numeric_limits<double>::quiet_NaN()})
      {
        StepController controller = make_controller(from_rung());
        controller.reject(controller.propose(0.), error);
        deallog << "rejected " << rung(controller);
        for (const double factor :
             {StepController::at_touch, StepController::at_change})
          {
            controller.restart(factor);
            deallog << ", switched " << rung(controller);
          }
        deallog << std::endl;
      }
  }



  void
  test_exhaustion()
  {
    const StepAttempt before{0.4, 0.1, 0.01, true, "ok"},
      near{0.5, 0.007, 1.5, false, rejected_by_tolerance},
      coarse{0.5, 0.015, 2., false, rejected_by_tolerance},
      fine{0.5, 1e-4, 200., false, rejected_by_tolerance},
      finest{0.5, 1e-14, 100., false, rejected_by_tolerance};
    for (const auto &attempts : {std::vector<StepAttempt>{before, fine},
                                 {before, near, fine},
                                 {before, coarse, fine},
                                 {before, coarse, finest}})
      deallog << describe_exhaustion(attempts, "", Parameters()) << std::endl;
    deallog << describe_exhaustion({fine}, "no pressures", Parameters())
            << std::endl;
  }
} // namespace



void
main_step_controller()
{
  initlog();
  test_exhaustion();
  test_ladder();
  test_orders();
  test_rejected_switches();
  test_targets();
  test_multiples();
}
