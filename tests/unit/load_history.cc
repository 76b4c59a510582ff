// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What is seen of a load before a run, and what steps make of it.
//
// 1. Jumps, each at the last double with the old value, to the last bit: of
//    t > 0.3 it is 0.3, of t >= 0.3 the double before it; those of a pulse of
//    1e-7 if its times are named, and none of it else, since times are T/2^15 =
//    3e-5 apart; the signs of sin(40 t) change at k pi/40, k = 1, ..., 12 for T
//    = 1, each between two neighbouring doubles of different signs. A jump at t
//    = 0. Steep fronts are no jumps: tanh(t/1e-6).
// 2. Bends: of |sin(7 t)|, T = 3, at k pi/7, k = 1, ..., 6, to 1e-10: parabolas
//    through times that are h = T/2^15 apart miss the load by up to (7 h)^3 =
//    3e-10, and the slope changes by 14; none of
//    sin(7 t)^2, t^3, exp(-t).
// 3. Smooth pulses exp(-((t - 1/2)/w)^2), w = 1e-4, and w = 1e-9 if 1/2 is
//    named: steps of any size that end where largest_step() ends them are
//    shorter than w where the pulse is above 1/e, and fewer than 100. The same
//    on a background of 1000, and beside a pulse that is 1000 times higher.
// 4. A constant, a + b t, and 2e4 + 3e-10 t^2, whose doubles are 3.6e-12 apart,
//    stairs of 1e-16 of the value: no break, any step. Of a load that jumps at
//    0.3 and by 1e7 behind the end the one at 0.3; none of one that begins to
//    grow two doubles before the end. sin(1e6 t) is not resolved;
//    1/(t - 1/2) is not finite at 1/2, which is i/2^15.
// 5. Together: breaks of both in order, the smaller widths; a listed time is a
//    jump, but not where there is one already: 3 of the listed 0.3, 0.4, 0.2
//    and the 0.3 of t > 0.3.
// 6. Jumps that are 1 and 5 doubles apart, in one load and in two, are one:
// from
//    the double before the first to the one after the last, between which the
//    loads are not looked at: no step near them is held below 0.1. Those that
//    are 1e-9 apart are two. One that is 5 doubles before T is at T, with its
//    old loads from before it, those of T behind it.
// 7. StepController: steps of at most 1/4 to T = 1 with breaks at 0.3 and 0.55:
//    ends 0.25, 0.3, 0.55, 0.8, 1. Loads of a step that ends or begins there
//    are those of the doubles before and after it; of one jump of several
//    doubles those before and after all of them.

#include <thermocontact/method/load_history.h>
#include <thermocontact/time/step_controller.h>

#include <cmath>
#include <string>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  using Function = double (*)(double);

  ScannedLoad
  scan(const std::function<double(double)> &load,
       const double                         end_time = 1.,
       const std::vector<double>           &named    = {})
  {
    return scan_load([&](const double         t,
                         std::vector<double> &values) { values = {load(t)}; },
                     end_time,
                     named);
  }



  unsigned int
  n_jumps(const LoadHistory &history)
  {
    unsigned int n = 0;
    for (const LoadBreak &b : history.breaks)
      n += b.is_jump;
    return n;
  }



  void
  test_jumps()
  {
    const auto after = scan([](const double t) { return t > 0.3 ? 1. : 0.; });
    const auto from  = scan([](const double t) { return t >= 0.3 ? 1. : 0.; });
    deallog << "t > 0.3: " << n_jumps(after.history) << ' '
            << (after.history.breaks.at(0).time == 0.3)
            << ", t >= 0.3: " << n_jumps(from.history) << ' '
            << (from.history.breaks.at(0).time == std::nextafter(0.3, 0.))
            << std::endl;

    const auto pulse = [](const double t) {
      return t > 0.4 && t < 0.4000001 ? 1. : 0.;
    };
    const auto named = scan(pulse, 1., {0.4, 0.4000001}).history;
    deallog << "pulse: named " << n_jumps(named) << ' '
            << (named.breaks.at(0).time == 0.4) << ' '
            << (named.breaks.at(1).time == std::nextafter(0.4000001, 0.))
            << ", not named " << scan(pulse).history.breaks.size() << std::endl;

    const auto sign = [](const double t) {
      return std::sin(40. * t) > 0. ? 1. : -1.;
    };
    const auto signs     = scan(sign).history;
    bool       are_found = true;
    for (const LoadBreak &b : signs.breaks)
      if (b.time > 0.)
        are_found &= sign(b.time) != sign(std::nextafter(b.time, 2.));
    deallog << "signs: " << n_jumps(signs) << ", at 0 "
            << (signs.breaks.at(0).time == 0.) << ", between doubles "
            << are_found << std::endl;
    deallog << "front: " << scan([](const double t) {
                              return std::tanh((t - 0.3) / 1e-6);
                            }).history.breaks.size()
            << std::endl;
  }



  void
  test_bends()
  {
    const auto bends =
      scan([](const double t) { return std::abs(std::sin(7. * t)); }, 3.)
        .history.breaks;
    double error = bends.size() == 6 ? 0. : 1.;
    for (unsigned int k = 0; k < bends.size(); ++k)
      raise(error, std::abs(bends[k].time - (k + 1) * numbers::PI / 7.));
    deallog << "bends: " << bends.size() << ", jumps " << bends[0].is_jump
            << ", to 1e-10 " << (error < 1e-10) << ", of smooth loads";
    for (const Function load :
         {Function(
            [](double t) { return std::sin(7. * t) * std::sin(7. * t); }),
          Function([](double t) { return t * t * t; }),
          Function([](double t) { return std::exp(-t); })})
      deallog << ' ' << scan(load).history.breaks.size();
    deallog << std::endl;
  }



  void
  test_pulse(const std::string                   &title,
             const std::function<double(double)> &load,
             const double                         width,
             const std::vector<double>           &named = {})
  {
    const LoadHistory history = scan(load, 1., named).history;
    double            longest = 0., time = 0.;
    unsigned int      n = 0;
    for (; time < 1. && n < 1000; ++n)
      {
        const double end = time + history.largest_step(time, 1.);
        if (end > 0.5 - width && time < 0.5 + width)
          raise(longest, end - time);
        time = end;
      }
    deallog << title << ": breaks " << history.breaks.size()
            << ", fewer than 100 steps " << (n < 100) << ", below the width "
            << (longest > 0. && longest < width) << std::endl;
  }



  void
  test_others()
  {
    for (const Function load :
         {Function([](double) { return 3.; }),
          Function([](double t) { return 3. - 2. * t; }),
          Function([](double t) { return 2e4 + 3e-10 * t * t; })})
      {
        const auto scanned = scan(load);
        deallog << "straight: " << scanned.history.breaks.size() << ' '
                << scanned.history.largest_step(0.1, 0.9) << std::endl;
      }
    const auto behind = scan([](double t) {
      return t < 0.3 ? 0. : t <= 1. ? 1. : 1e7;
    });
    const auto at_end =
      scan([](double t) { return 1e-8 + std::max(0., t - (1. - 2e-16)); });
    deallog << "behind the end: " << behind.history.breaks.size()
            << ", bends there: " << at_end.history.breaks.size() << std::endl;
    const auto fast = scan([](const double t) { return std::sin(1e6 * t); });
    const auto pole = scan([](const double t) { return 1. / (t - 0.5); });
    deallog << "fast: " << fast.is_resolved << fast.is_infinite
            << ", pole: " << pole.is_resolved << pole.is_infinite << ' '
            << pole.time << std::endl;

    LoadHistory both =
      scan([](const double t) { return t > 0.3 ? 1. : 0.; }).history;
    both.add(scan([](const double t) { return std::abs(t - 0.1); }).history);
    both.add_breaks({0.3, 0.4, 0.2});
    for (const LoadBreak &b : both.breaks)
      deallog << (b.is_jump ? "jump " : "bend ") << b.time << ' ';
    deallog << std::endl;
  }



  void
  test_close_jumps()
  {
    const auto advanced = [](double t, const unsigned int n) {
      for (unsigned int i = 0; i < n; ++i)
        t = std::nextafter(t, 1.);
      return t;
    };
    for (const unsigned int n : {1, 5})
      {
        const double last  = advanced(0.3, n - 1);
        const auto   first = [](const double t) { return t >= 0.3 ? 1. : 0.; };
        const auto second  = [&](const double t) { return t > last ? 2. : 0.; };
        const LoadHistory one =
          scan([&](const double t) { return first(t) + second(t); }).history;
        LoadHistory two = scan(second).history;
        two.add(scan(first).history);
        for (const LoadHistory &history : {one, two})
          deallog << "close jumps: " << history.breaks.size() << ' '
                  << (history.breaks.at(0).time == std::nextafter(0.3, 0.))
                  << (history.breaks.at(0).new_time == advanced(0.3, n)) << ' '
                  << (history.largest_step(history.breaks[0].time, 0.1) == 0.1)
                  << (history.largest_step(0.25, 0.1) == 0.1) << std::endl;
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
    deallog << "two jumps: "
            << scan(
                 [](const double t) {
                   return (t > 0.3 ? 1. : 0.) + (t > 0.3 + 1e-9 ? 1. : 0.);
                 },
                 1.,
                 {0.3, 0.3 + 1e-9})
                 .history.breaks.size()
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

    loads.breaks = merged({{0.3, true}, {std::nextafter(0.3, 1.), true}});
    controller.follow(loads);
    const double after = std::nextafter(std::nextafter(0.3, 1.), 1.);
    deallog << "loads around two doubles: "
            << (controller.propose(0.2).last_loads == std::nextafter(0.3, 0.))
            << (controller.propose(0.3).first_loads == after) << std::endl;
  }
} // namespace



int
main()
{
  initlog();
  test_jumps();
  test_bends();
  const auto pulse = [](const double width) {
    return [width](const double t) {
      const double x = (t - 0.5) / width;
      return std::exp(-x * x);
    };
  };
  test_pulse("wide pulse", pulse(0.1), 0.1);
  test_pulse("pulse", pulse(1e-4), 1e-4);
  test_pulse("narrow pulse", pulse(1e-9), 1e-9, {0.5});
  test_pulse(
    "on a background",
    [&](const double t) { return 1000. + pulse(1e-4)(t); },
    1e-4);
  test_pulse(
    "beside a higher one",
    [&](const double t) {
      return 1000. * pulse(1e-3)(t + 0.3) + pulse(1e-4)(t);
    },
    1e-4);
  test_others();
  test_close_jumps();
  test_steps();
}
