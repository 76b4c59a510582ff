// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What steps make of breaks and stretches of loads.
//
// 1. Together: breaks in order, those of a listed time are jumps, but not where
//    there is one already; a jump and a bend at one time are a jump; a break
//    over which steps go ends them as soon as its time is listed; of
//    stretches that overlap the smaller width: [0.1, 0.5] with 0.2, [0.3, 0.8]
//    with 0.1 and [0.6, 0.7] with 0.3. Steps of at most 1 have 0.2 from 0 and
//    from 0.1, 0.1 from 0.3, 0.08 from 0.82 to [0.9, 0.95] with 0.05, and 1
//    from 0.95.
// 2. Jumps that are 1 and 5 doubles apart are one: from the double before the
//    first to the one after the last. One that is 5 doubles before T is at T,
//    with its old loads from before it, those of T behind it; one before the
//    first time that can be told from 0 is at 0.
// 3. StepController: steps of at most 1/4 to T = 1 with breaks at 0.3 and 0.55:
//    ends 0.25, 0.3, 0.55, 0.8, and, of at most 0.03 in [0.81, 0.85], 2^(-21/4)
//    = 0.026278 twice, 1. Loads of a step that ends or begins there
//    are those of the doubles before and after it.

#include <thermocontact/method/load_history.h>
#include <thermocontact/time/step_controller.h>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  double
  advanced(double time, const unsigned int n)
  {
    for (unsigned int i = 0; i < n; ++i)
      time = std::nextafter(time, 1.);
    return time;
  }



  void
  test_together()
  {
    LoadHistory one, two;
    one.breaks    = {{0.3, true}, {0.6, false}};
    one.stretches = {{0.1, 0.5, 0.2}, {0.9, 0.95, 0.05}};
    two.breaks    = {{0.1, false}, {0.3, false}, {0.6, true}};
    two.stretches = {{0.3, 0.8, 0.1}, {0.6, 0.7, 0.3}};
    one.add(two);
    one.add_breaks({0.3, 0.4, 0.2});
    for (const LoadBreak &b : one.breaks)
      deallog << (b.is_jump ? "jump " : "bend ") << b.time << ' ';
    deallog << std::endl;
    LoadHistory passed;
    passed.breaks                    = {{0.5, true}, {0.7, true}};
    passed.breaks.front().ends_steps = false;
    deallog << "steps go on to " << passed.next_break(0.)->time;
    passed.add_breaks({0.5});
    deallog << ", listed to " << passed.next_break(0.)->time << ", breaks "
            << passed.breaks.size() << std::endl;
    for (const LoadStretch &s : one.stretches)
      deallog << s.begin << " to " << s.end << ": " << s.width << ' ';
    for (const double time : {0., 0.1, 0.3, 0.82, 0.95})
      deallog << ", " << one.largest_step(time, 1.);
    deallog << std::endl;
  }



  void
  test_close_jumps()
  {
    for (const unsigned int n : {1, 5})
      {
        LoadHistory first, second;
        first.breaks  = {{std::nextafter(0.3, 0.), true}};
        second.breaks = {{advanced(0.3, n - 1), true}};
        second.add(first);
        deallog << "close jumps: " << second.breaks.size() << ' '
                << (second.breaks.at(0).time == std::nextafter(0.3, 0.))
                << (second.breaks.at(0).new_time == advanced(0.3, n))
                << std::endl;
      }
    const double end = advanced(0.3, 5);
    LoadHistory  at_end;
    at_end.add_breaks({0.3});
    at_end.end_at(end);
    const LoadBreak &last = at_end.breaks.at(0);
    deallog << "at the end: " << (last.time == end)
            << (last.old_time == std::nextafter(0.3, 0.))
            << (last.new_time == end) << std::endl;
    LoadHistory at_start;
    at_start.add_breaks({1e-322, 1e-9});
    at_start.end_at(end);
    const LoadBreak &first = at_start.breaks.at(0);
    deallog << "at the start: " << (first.time == 0. && first.old_time == 0.)
            << (first.new_time > 1e-322) << (at_start.breaks[1].time == 1e-9)
            << std::endl;
  }



  void
  test_steps()
  {
    Parameters parameters             = read_parameters("");
    parameters.time.end_time          = 1.;
    parameters.time.first_step_size   = 0.25;
    parameters.time.maximum_step_size = 0.25;
    StepController controller(parameters.time, parameters.output, 4);
    LoadHistory    loads;
    loads.add_breaks({0.3, 0.55});
    loads.stretches = {{0.81, 0.85, 0.03}};
    controller.follow(loads);
    bool are_inside = true;
    for (double time = 0.; !controller.is_finished(time);)
      {
        const TimeStep step = controller.propose(time);
        deallog << step.end << ' ' << name_of(step.target) << ' ';
        const bool at_begin = time == 0.3 || time == 0.55;
        const bool at_end   = step.end == 0.3 || step.end == 0.55;
        are_inside &=
          step.first_loads == (at_begin ? std::nextafter(time, 1.) : time) &&
          step.last_loads == (at_end ? std::nextafter(step.end, 0.) : step.end);
        controller.accept(step, 0.);
        time = step.end;
      }
    deallog << ", loads from inside " << are_inside << std::endl;
  }
} // namespace



void
main_load_history()
{
  initlog();
  test_together();
  test_close_jumps();
  test_steps();
}
