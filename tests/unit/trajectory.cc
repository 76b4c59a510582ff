// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a study compares, by hand.
//
// 1. Between steps the reference is a polynomial of degree five: t^5 at the
//    steps 0, 0.1, ..., 1 and the same in the middle between them differ by
//    rounding alone. t^6 differs by the product of the distances to the nodes
//    of the polynomial, most in the last interval, from the nodes 0.5 to 1:
//    0.05 0.05 0.15 0.25 0.35 0.45 = 1.4766e-5, fivefold for the energy.
// 2. No polynomial goes over a change of contact: with t before it, at 0.5, and
//    0.5 - 3(t - 0.5) after it, both sides are exact. If the event is not
//    known, the polynomial of max(0, t - 0.5), -4 times of which makes the
//    kink, is most wrong at 0.45, where it should be 0: its values 0.1 and 0.2
//    have the weights -25/256 and 3/256, so that it is -1.9/256, 20 times that
//    for the energy. Common times are exact in any case.
// 3. First contact: of events at 0.4 and 0.9 and of events at 0.5 and 0.6,
//    0.1; 0 if neither has any, NaN if one has none. Beyond the end of the
//    reference all is NaN.
// 4. Peaks between samples: the cubic t^3/3 - 3t^2/2 + 2t + 1 of a first step
//    from 0 to 1.5 has its largest value 11/6 at t = 1 and falls to t = 2,
//    behind its end; without rates the parabola 5 - (t - 1.2)^2 through t = 0,
//    1 and 2 has 5, of its first two samples the larger one, 4.96, counts.
//    The force 2 - |t - 1| has a kink at t = 1, whose rate is the one in front:
//    the cubic 2 + s - 4 s^2 + 2 s^3 behind it is an estimate, 2.06709 at
//    s = (4 - sqrt(10))/6, and no value: 2.

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



  /** The largest difference of all quantities. */
  double
  error(const Trajectory &own, const Trajectory &reference)
  {
    double largest = 0.;
    for (const double of_quantity : own.compare(reference).maximum)
      raise(largest, of_quantity);
    return largest;
  }



  void
  test_interpolation()
  {
    for (const unsigned int degree : {1, 5, 6})
      {
        const Function power = [degree](const double t) {
          return std::pow(t, degree);
        };
        const double off = error(trajectory(power, steps(10, 0.5)),
                                 trajectory(power, steps(10)));
        deallog << "t^" << degree << ": ";
        if (degree == 6)
          deallog << off;
        else
          deallog << within(off, 1e-12);
        deallog << std::endl;
      }
    const Function kink = [](const double t) {
      return t < 0.5 ? t : 0.5 - 3. * (t - 0.5);
    };
    const auto off = [&](const std::vector<double> &events) {
      return error(trajectory(kink, steps(10, 0.5)),
                   trajectory(kink, steps(10), events));
    };
    deallog << "kink, its event known: " << within(off({0.5}), 1e-12)
            << std::endl;
    deallog << "kink, its event unknown: " << off({}) << ", at common times "
            << within(error(trajectory(kink, steps(5)),
                            trajectory(kink, steps(10))),
                      1e-12)
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
            << ", one without "
            << trajectory(f, steps(10)).compare(reference).first_contact_time
            << ", both without "
            << trajectory(f, steps(10))
                 .compare(trajectory(f, steps(10)))
                 .first_contact_time
            << std::endl;
    const auto beyond = trajectory(f, {0., 0.9, 1.1}).compare(reference);
    deallog << "beyond the reference " << beyond.maximum[0] << ' '
            << beyond.final_value[0] << std::endl;
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
    SampledPeak of_kink;
    of_kink.add(0.5, 1.5, 1.);
    of_kink.add(1., 2., 1.);
    of_kink.add(2., 1., -1.);
    deallog << std::endl
            << "of a kink " << of_kink.top() << ", estimate "
            << of_kink.estimate() << std::endl;
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
