// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a study compares, by hand.
//
// 1. Between steps the reference is a polynomial of degree five: t^5 at the
//    steps 0, 0.1, ..., 1 and the same in the middle between them differ by
//    rounding alone, t^6 does not.
// 2. No polynomial goes over a change of contact: with t before it, at 0.5, and
//    0.5 - 3(t - 0.5) after it, both sides are exact, which they are not if the
//    event is not known. Common times are exact in any case.
// 3. First contact: of events at 0.4 and 0.9 and of events at 0.5 and 0.6,
//    0.1; 0 if neither has any, NaN if one has none. Beyond the end of the
//    reference all is NaN.
// 4. Peaks between samples: the cubic t^3/3 - 3t^2/2 + 2t + 1 of a first step
//    from 0 to 1.5 has its largest value 11/6 at t = 1 and falls to t = 2,
//    behind its end; without rates the parabola 5 - (t - 1.2)^2 through t = 0,
//    1 and 2 has 5, of its first two samples the larger one, 4.96, counts.

#include <thermocontact/simulation/sampled_peak.h>
#include <thermocontact/study/trajectory.h>

#include <cmath>
#include <functional>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  using Function = std::function<double(double)>;



  /** Takes all quantities from @p f, the q-th one (q + 1)-fold. */
  Trajectory
  trajectory(const Function            &f,
             const std::vector<double> &times,
             const std::vector<double> &event_times = {})
  {
    Trajectory result;
    for (const double t : times)
      {
        StepRecord record;
        record.time             = t;
        record.displacement_end = f(t);
        record.velocity_end     = 2. * f(t);
        record.contact_force    = 3. * f(t);
        record.temperature_end  = 4. * f(t);
        record.energy           = 5. * f(t);
        result.add(record);
      }
    std::vector<ContactEvent> events;
    for (const double t : event_times)
      events.push_back(
        {t,
         events.size() % 2 == 0 ? ContactEvent::begin : ContactEvent::end,
         0.});
    result.set_events(events);
    return result;
  }



  /** @p n steps of size 1/n, from @p offset sizes on. */
  std::vector<double>
  steps(const unsigned int n, const double offset = 0.)
  {
    std::vector<double> times;
    for (unsigned int i = 0; i + offset <= n; ++i)
      times.push_back((i + offset) / n);
    return times;
  }



  bool
  is_exact(const Trajectory &own, const Trajectory &reference)
  {
    bool all = true;
    for (const double error : own.compare(reference).maximum)
      all &= error < 1e-12;
    return all;
  }



  void
  test_interpolation()
  {
    for (const unsigned int degree : {1, 5, 6})
      {
        const Function power = [degree](const double t) {
          return std::pow(t, degree);
        };
        deallog << "t^" << degree << " exact "
                << is_exact(trajectory(power, steps(10, 0.5)),
                            trajectory(power, steps(10)))
                << std::endl;
      }
    const Function kink = [](const double t) {
      return t < 0.5 ? t : 0.5 - 3. * (t - 0.5);
    };
    for (const std::vector<double> &events :
         {std::vector<double>{0.5}, std::vector<double>{}})
      deallog << "kink, events " << events.size() << ": exact "
              << is_exact(trajectory(kink, steps(10, 0.5)),
                          trajectory(kink, steps(10), events))
              << ", at common times "
              << is_exact(trajectory(kink, steps(5)),
                          trajectory(kink, steps(10), events))
              << std::endl;
  }



  void
  test_first_contact()
  {
    const Function   f         = [](const double t) { return t; };
    const Trajectory reference = trajectory(f, steps(10), {0.5, 0.6});
    deallog << "first contact: "
            << trajectory(f, steps(10), {0.4, 0.9})
                 .compare(reference)
                 .first_contact_time
            << ", one without is NaN "
            << std::isnan(
                 trajectory(f, steps(10)).compare(reference).first_contact_time)
            << ", both without "
            << trajectory(f, steps(10))
                 .compare(trajectory(f, steps(10)))
                 .first_contact_time
            << std::endl;
    const auto beyond = trajectory(f, {0., 0.9, 1.1}).compare(reference);
    deallog << "beyond the reference NaN " << std::isnan(beyond.maximum[0])
            << ' ' << std::isnan(beyond.final_value[0]) << std::endl;
  }



  void
  test_peaks()
  {
    SampledPeak of_cubic, of_parabola;
    of_cubic.add(0., 1., 2.);
    of_cubic.add(1.5, 1.75, -0.25);
    deallog << "peaks " << of_cubic.estimate();
    for (const double t : {0., 1., 2.})
      {
        of_parabola.add(t, 5. - (t - 1.2) * (t - 1.2));
        deallog << ' ' << of_parabola.estimate();
      }
    deallog << std::endl;
  }
} // namespace



void
main_trajectory()
{
  initlog();
  test_interpolation();
  test_first_contact();
  test_peaks();
}
