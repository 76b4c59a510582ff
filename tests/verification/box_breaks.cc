// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Inputs that jump or bend at the end of a step of the scheme box, written as
// if(t < 1, old, new) and as if(t <= 1, old, new): both are the same, and the
// row of t = 1 is in front of the break. No viscosity, Z = sqrt(b), steps h
// sqrt(b), rigid obstacle, the end beside it unless something else is said; by
// d'Alembert a wave R = v - sigma/Z that arrives makes F = Z (R - g') + T.
//
// 1. The obstacle moves to the rod from t = 1 on, g' = -1/100: F = Z/100, until
//    the wave is back at 1 + 2 Z. With g' = -1/100 before, and -3/100 behind:
//    F = Z/100, then 3 Z/100. With g' = -3/100, then 5/100: the end stays
//    behind with velocity 0, at -3/100; contact ends at t = 1 with -5/100.
// 2. The fixed end has the velocity V = 1/100, from t = 1 on 1/20: R = 2 V
//    arrives Z later, F = 2 Z V (b = 1, until t = 3). Rows of the instants 1
//    and 2 at which its fronts arrive are left out.
// 3. A traction T from t = 1 on, b = 1: T = 1/100 presses at once, F = T, and
//    T = -1/100 pulls the end away with v = T, F = 0. T = (t - 1)/100: F = T,
//    of which rows have the mean over the step, off by half a step, 2.5e-4.
// 4. A body force f = 1/100 from t = 1 on, b = 1: F = f (t - 1) until t = 2,
//    then f (3 - t); rows as in 3.
// 5. A free rod with v = 1 presses with 1 until the front of its other end is
//    back at t = 2 and takes it away with v = -1. The obstacle starts with r at
//    t_r = 19/10, 39/20 and 2, r = -3/10 and 3/10: contact ends at t = 2 with
//    -1 - r, the impulse is 2 - r (2 - t_r). A traction T in its place: ends
//    with -1 + T, impulse 2 + T (2 - t_r).
// 6. 1 to 4 with heat, a = 0, whose stages see the ends of steps.
// 7. The end begins to exchange heat at t = 1, k = 1, theta = 1 before; a half
//    space has theta = exp(s) erfc(sqrt(s)), s = t - 1: at s = 1/5 to 2e-3
//    (measured 3e-4 with 100 cells; 3e-3 if k came evenly in a step).

#include <cmath>
#include <functional>

#include "../tests.h"

#include "../row_checks.h"
#include "../two_spellings.h"

using namespace ThermoContact;

namespace
{
  using OfTime = std::function<double(double)>;

  const Overrides touching = {"Contact/Condition=rigid", "Contact/Gap=0"};



  /** The runs of both spellings, @ in the entries. */
  std::array<RecordedRun, 2>
  both(const Overrides &entries, const bool has_heat)
  {
    return run_both_spellings(
      Overrides{"Time/Scheme=box", "Model/Viscosity=0", "Mesh/Cells=20"} +
      (has_heat ? Overrides{"Model/Coupling=0"} :
                  Overrides{"Model/Fields=displacement"}) +
      entries);
  }



  /** Rows of both spellings against a force and the displacement at the end. */
  void
  check(const std::string &name,
        const Overrides   &entries,
        const OfTime      &force,
        const double       displacement,
        const double       bound = 1e-12)
  {
    for (const bool has_heat : {false, true})
      {
        double     error = 0., u = 0.;
        const auto runs =
          both(Overrides{"Initial values/Velocity=0"} + entries, has_heat);
        for (const RecordedRun &result : runs)
          {
            for (const StepRecord &row : result.rows)
              if (const double exact = force(row.time); !std::isnan(exact))
                raise(error, std::abs(row.contact_force - exact));
            raise(u,
                  std::abs(result.rows.back().displacement_end - displacement));
          }
        deallog << name << (has_heat ? ", with heat" : "") << ": force "
                << within(error, bound) << ", u(1) " << within(u, 1e-12)
                << ", apart "
                << within(difference(table_of(runs[0].rows),
                                     table_of(runs[1].rows)),
                          1e-12)
                << std::endl;
        if (name == "obstacle that goes away")
          for (const RecordedRun &result : runs)
            deallog << "  ends at "
                    << within(std::abs(result.events.back().time - 1.), 1e-12)
                    << " with "
                    << within(std::abs(result.events.back().velocity + 0.05),
                              1e-12)
                    << std::endl;
      }
  }



  /** From t = 1 on, a row at 1 is in front of it. */
  bool
  is_behind(const double time)
  {
    return time > 1. + 1e-9;
  }



  void
  check_release(const std::string &path, const double start, const double value)
  {
    const bool        is_gap  = path == "Contact/Gap";
    const std::string begin   = "if(t@" + std::to_string(start) + ",0,";
    const std::string number  = std::to_string(value);
    Overrides         entries = {"Boundary/left/Support=free",
                                 "Initial values/Velocity=1",
                                 "Time/End time=2.5",
                                 "Contact/Condition=rigid"};
    if (is_gap)
      entries.push_back(path + "=" + begin + number + "*(t-" +
                        std::to_string(start) + "))");
    else
      entries =
        entries + Overrides{"Contact/Gap=0", path + "=" + begin + number + ")"};
    const double sign = is_gap ? -1. : 1.;
    double       time = 0., velocity = 0., impulse = 0.;
    for (const RecordedRun &result : both(entries, false))
      {
        raise(time, std::abs(result.events.back().time - 2.));
        raise(velocity,
              std::abs(result.events.back().velocity + 1. - sign * value));
        raise(impulse,
              std::abs(result.rows.back().contact_impulse - 2. -
                       sign * value * (2. - start)));
      }
    deallog << path << ' ' << value << " from " << start << ": ends at "
            << within(time, 1e-12) << " with " << within(velocity, 1e-12)
            << ", impulse " << within(impulse, 1e-12) << std::endl;
  }



  void
  check_exchange()
  {
    const auto runs  = both({"Initial values/Velocity=0",
                             "Initial values/Temperature=1",
                             "Boundary/left/Temperature=1",
                             "Boundary/right/Heat exchange=if(t@1,0,1)",
                             "Mesh/Cells=100",
                             "Contact/Gap=1",
                             "Time/End time=1.2"},
                           true);
    double     error = 0.;
    for (const RecordedRun &result : runs)
      raise(error,
            std::abs(result.rows.back().temperature_end -
                     std::exp(0.2) * std::erfc(std::sqrt(0.2))));
    deallog << "exchange that begins: theta(1) " << within(error, 2e-3)
            << ", apart "
            << within(difference(table_of(runs[0].rows),
                                 table_of(runs[1].rows)),
                      1e-12)
            << std::endl;
  }
} // namespace



void
main_box_breaks()
{
  initlog();
  for (const double b : {1., 0.25})
    {
      const double    Z       = std::sqrt(b);
      const Overrides inertia = {entry("Model/Inertia", b)};
      const Overrides moving =
        inertia + Overrides{"Contact/Condition=rigid",
                            entry("Time/End time", 1. + 1.8 * Z)};
      check(
        "obstacle that comes",
        moving + Overrides{"Contact/Gap=if(t@1,0,-0.01*(t-1))"},
        [Z](const double t) { return is_behind(t) ? 0.01 * Z : 0.; },
        -0.018 * Z);
    }
  const Overrides moving = {"Contact/Condition=rigid", "Time/End time=1.8"};
  check(
    "obstacle that comes faster",
    moving + Overrides{"Contact/Gap=if(t@1,-0.01*t,-0.01-0.03*(t-1))"},
    [](const double t) { return t == 0.      ? 0. :
                                is_behind(t) ? 0.03 :
                                               0.01; },
    -0.034);
  check(
    "obstacle that goes away",
    moving + Overrides{"Contact/Gap=if(t@1,-0.03*t,-0.03+0.05*(t-1))"},
    [](const double t) { return t == 0. || is_behind(t) ? 0. : 0.03; },
    -0.03);
  check(
    "fixed end",
    touching +
      Overrides{"Boundary/left/Displacement=if(t@1,0.01*t,0.01+0.05*(t-1))",
                "Time/End time=2.9"},
    [](const double t) {
      const double since = t - std::round(t); // a front arrives at 0
      return std::abs(since) < 0.01 ? NAN : t > 2. ? 0.1 : t > 1. ? 0.02 : 0.;
    },
    0.);
  check(
    "traction that presses",
    touching +
      Overrides{"Boundary/right/Traction=if(t@1,0,0.01)", "Time/End time=2.9"},
    [](const double t) { return is_behind(t) ? 0.01 : 0.; },
    0.);
  check(
    "traction that pulls",
    touching +
      Overrides{"Boundary/right/Traction=if(t@1,0,-0.01)", "Time/End time=2.9"},
    [](const double) { return 0.; },
    -0.019);
  check(
    "traction that grows",
    touching + Overrides{"Boundary/right/Traction=if(t@1,0,0.01*(t-1))",
                         "Time/End time=2.9"},
    [](const double t) { return is_behind(t) ? 0.01 * (t - 1.) : 0.; },
    0.,
    2.6e-4);
  check(
    "body force",
    touching +
      Overrides{"Sources/Body force=if(t@1,0,0.01)", "Time/End time=2.9"},
    [](const double t) {
      return is_behind(t) ? 0.01 * std::min(t - 1., 3. - t) : 0.;
    },
    0.,
    2.6e-4);
  for (const std::string path : {"Contact/Gap", "Boundary/right/Traction"})
    for (const double start : {1.9, 1.95, 2.})
      for (const double value : {-0.3, 0.3})
        check_release(path, start, value);
  check_exchange();
}
