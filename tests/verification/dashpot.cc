// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Obstacles with a dashpot, p = [s/eps + d s']_+ for s >= 0, doc/model.md
// (M4.2).
//
// 1. A mass of 1 with velocity 1 on eps = 1/4, d = 2: beta = 1/2, damped
//    frequency sqrt(3), decay 1. Contact ends at the first zero of s'',
//    t = 2 pi/(3 sqrt(3)), with the velocity -exp(-t); the force is 2 at the
//    first touch and falls; the dashpot takes (1 - exp(-2 t))/2. By sdirk4 with
//    a tolerance of 1e-10 to 1e-8; by box with 2000 steps to 1e-5, with nothing
//    left for the scheme but rounding.
// 2. A free rod with velocity 1 and Z = sqrt(b) = 1 on eps = 1e9 and d = 1, 3,
//    1/3: the force is d/(1 + d) until the wave is back from the free end at 2,
//    to 1e-8. With d = 1 nothing moves then.
// 3. Orders of the schemes, with located events, of one cell of degree 1
// against
//    closed forms, gap 1/10, eps = 3/10, d = 7/10: position behind contact, and
//    the times of touch and end (p = 0).
//    creep   b = 0, zeta = 1/2: zeta u' + u + p = 2 sin 3 t, that is y' + k y =
//            A sin 3 t + B, in contact with k = (1 + 1/eps)/(zeta + d).
//    impact  lumped: a mass 1/2 on a spring 1, with velocity 1.
// 4. Creep and impact have their mirror images, to rounding.
// 5. A strip on rollers, by both linear solvers and without located events, is
//    the rod that does so, to 1e-8.

#include <thermocontact/method/bracketed_root.h>

#include <cmath>
#include <tuple>

#include "../mirror_image.h"
#include "../oscillator.h"
#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const Overrides elastic = {"Model/Fields=displacement", "Model/Viscosity=0"};

  MirrorImages images;



  void
  check_bounce(const std::string &name,
               const Overrides   &time,
               const double       bound)
  {
    const RecordedRun result = run<1>("",
                                      elastic +
                                        Overrides{"Boundary/left/Support=free",
                                                  "Bodies/ball/Kind=mass",
                                                  "Bodies/ball/Mass=1",
                                                  "Bodies/ball/Velocity=1",
                                                  "Contact/Gap=0.1",
                                                  "Contact/Compliance=0.25",
                                                  "Contact/Dashpot=2",
                                                  "Time/End time=2"} +
                                        time);
    const double duration    = 2. * dealii::numbers::PI / (3. * std::sqrt(3.));
    const double e           = std::exp(-duration);
    double       peak        = 0.;
    for (const StepRecord &r : result.rows)
      raise(peak, r.contact_force);
    const StepRecord  &last = result.rows.back();
    const ContactEvent none{-1.};
    const ContactEvent begin =
      result.events.empty() ? none : result.events.front();
    const ContactEvent end =
      result.events.empty() ? none : result.events.back();
    deallog
      << name << ": events " << result.events.size() << ", touch "
      << within(std::abs(begin.time - 0.1), bound) << ", end "
      << within(std::abs(end.time - 0.1 - duration), bound) << ", velocity "
      << within(std::abs(end.velocity + e), bound) << ", impulse "
      << within(std::abs(last.contact_impulse - 1. - e), bound) << ", peak "
      << within(std::abs(peak - 2.), bound) << ", dissipation "
      << within(std::abs(last.contact_dissipation - 0.5 * (1. - e * e)), bound)
      << ", of the scheme "
      << within(std::abs(last.numerical_dissipation), std::min(1e-7, bound))
      << std::endl;
  }



  void
  check_impedance()
  {
    for (const double d : {1., 3., 1. / 3.})
      {
        const RecordedRun result =
          run<1>("",
                 elastic + Overrides{"Boundary/left/Support=free",
                                     "Initial values/Velocity=1",
                                     "Contact/Gap=0",
                                     "Contact/Compliance=1e9",
                                     entry("Contact/Dashpot", d),
                                     "Time/Scheme=box",
                                     "Mesh/Degree=1",
                                     "Mesh/Cells=50",
                                     "Time/Step size=0.02",
                                     "Time/End time=3"});
        double force = 0., rest = 0.;
        for (const StepRecord &r : result.rows)
          if (r.time > 0. && r.time < 2. - r.step_size)
            raise(force, std::abs(r.contact_force - d / (1. + d)));
          else if (r.time > 2. + r.step_size)
            raise(rest, std::abs(r.velocity_end));
        const StepRecord &last = result.rows.back();
        deallog << "impedance " << d << ": force " << within(force, 1e-8);
        if (d == 1.)
          deallog << ", velocity behind " << within(rest, 1e-8)
                  << ", energy left " << within(last.energy, 1e-8);
        deallog << std::endl;
      }
  }



  const double gap = 0.1, compliance = 0.3, dashpot = 0.7;

  /** Touch, end of contact, position at a time behind it. */
  struct Values
  {
    double touch, end, position;
  };



  /** y' + k y = a sin 3 t + b from y at t_0 on. */
  double
  creep(const double k,
        const double a,
        const double b,
        const double t_0,
        const double y,
        const double t)
  {
    const auto steady = [&](const double at) {
      return a * (k * std::sin(3. * at) - 3. * std::cos(3. * at)) /
               (k * k + 9.) +
             b / k;
    };
    return steady(t) + (y - steady(t_0)) * std::exp(-k * (t - t_0));
  }



  Values
  exact_creep(const double t)
  {
    const double zeta = 0.5;
    const auto free = [&](const double from, const double y, const double at) {
      return creep(1. / zeta, 2. / zeta, 0., from, y, at);
    };
    const double touch =
      bracketed_root([&](const double at) { return free(0., 0., at) - gap; },
                     0.,
                     0.5)
        .first;
    const double both   = zeta + dashpot;
    const double k      = (1. + 1. / compliance) / both;
    const auto   closed = [&](const double at) {
      return creep(k, 2. / both, gap / compliance / both, touch, gap, at);
    };
    const auto pressure = [&](const double at) {
      const double u = closed(at);
      const double rate =
        (2. * std::sin(3. * at) + gap / compliance) / both - k * u;
      return (u - gap) / compliance + dashpot * rate;
    };
    const double end =
      bracketed_root([&](const double at) { return -pressure(at); },
                     touch + 0.3,
                     1.3)
        .first;
    return {touch, end, free(end, closed(end), t)};
  }



  Values
  exact_impact(const double t)
  {
    const auto in = [](const double at) {
      return oscillation(0., 1., 0., {0., 1.}, at);
    };
    const double touch =
      bracketed_root([&](const double at) { return in(at).u - gap; }, 0., 0.5)
        .first;
    const double k      = 1. + 1. / compliance;
    const auto   closed = [&](const double at) {
      return oscillation(
        dashpot, k, gap / compliance / k, {gap, in(touch).v}, at - touch);
    };
    const double end = bracketed_root(
                         [&](const double at) {
                           const Motion m = closed(at);
                           return 0. - (m.u - gap) / compliance - dashpot * m.v;
                         },
                         touch + 0.2,
                         touch + 1.5)
                         .first;
    return {touch, end, oscillation(0., 1., 0., closed(end), t - end).u};
  }



  void
  check_orders(const std::string &name,
               const Overrides   &scene,
               const double       time,
               const Values      &exact)
  {
    const Overrides cell =
      elastic + Overrides{"Mesh/Cells=1",
                          "Mesh/Degree=1",
                          entry("Contact/Gap", gap),
                          entry("Contact/Compliance", compliance),
                          entry("Contact/Dashpot", dashpot),
                          entry("Time/End time", time)};
    deallog << name << ": orders of touch, end, position";
    for (const auto &[scheme, order] : {std::pair("backward euler", 1.),
                                        std::pair("sdirk2", 2.),
                                        std::pair("sdirk3", 3.),
                                        std::pair("sdirk4", 4.)})
      {
        std::vector<Values> errors;
        for (const unsigned int n : {100, 200})
          {
            const RecordedRun result =
              run<1>("",
                     cell + scene +
                       Overrides{std::string("Time/Scheme=") + scheme,
                                 "Time/Start=consistent",
                                 "Time/Locate contact events=true",
                                 entry("Time/Step size", time / n)});
            if (result.events.size() != 2)
              {
                deallog << result.events.size() << " events" << std::endl;
                return;
              }
            errors.push_back(
              {std::abs(result.events[0].time - exact.touch),
               std::abs(result.events[1].time - exact.end),
               std::abs(result.rows.back().displacement_end - exact.position)});
          }
        deallog << ", " << scheme;
        for (double Values::*const value :
             {&Values::touch, &Values::end, &Values::position})
          {
            const double rate = std::log2(errors[0].*value / errors[1].*value);
            deallog << ' ' << (rate > order - 0.3 ? order : rate);
          }
      }
    deallog << std::endl;
    Simulation<1> simulation(
      read_parameters("", cell + scene + Overrides{"Time/Tolerance=1e-6"}),
      MPI_COMM_SELF);
    images.run(simulation);
  }



  void
  check_strip()
  {
    const Overrides scene =
      elastic + Overrides{"Model/Viscosity=0.1",
                          "Mesh/Cells=4",
                          "Mesh/Degree=2",
                          "Initial values/Velocity=x",
                          "Contact/Compliance=0.1",
                          "Contact/Dashpot=0.7",
                          "Time/Scheme=sdirk3",
                          "Time/Locate contact events=false",
                          "Time/Step size=0.005",
                          "Time/End time=1.5"};
    const RecordedRun rod = run<1>("", scene);
    for (const Overrides &solver : {Overrides{"Solver/Linear solver=direct"},
                                    Overrides{"Solver/Linear solver=iterative",
                                              "Solver/Linear tolerance=1e-12"}})
      {
        const RecordedRun strip =
          run<2>("",
                 scene +
                   Overrides{"Dimension=2",
                             "Boundary/sides/Support=rollers",
                             "Mesh/Cells across=2"} +
                   solver);
        double force = 0., energy = 0.;
        for (unsigned int i = 0; i < rod.rows.size(); ++i)
          {
            const StepRecord &a = rod.rows[i], &b = strip.rows[i];
            raise(force, std::abs(a.contact_force - b.contact_force));
            raise(energy,
                  std::abs(b.energy + b.dissipation + b.contact_dissipation +
                           b.numerical_dissipation - strip.rows[0].energy));
          }
        deallog << "strip, " << solver[0] << ": force " << within(force, 1e-8)
                << ", balance " << within(energy, 1e-9) << std::endl;
      }
  }
} // namespace



void
main_dashpot()
{
  initlog();
  check_bounce("mass, sdirk4",
               {"Time/Scheme=sdirk4", "Time/Tolerance=1e-10"},
               1e-8);
  check_bounce("mass, box", {"Time/Scheme=box", "Time/Step size=0.001"}, 1e-5);
  check_impedance();
  check_orders("creep",
               {"Model/Inertia=0",
                "Model/Viscosity=0.5",
                "Boundary/right/Traction=2*sin(3*t)"},
               1.5,
               exact_creep(1.5));
  check_orders("impact",
               {"Mesh/Mass matrix=lumped", "Initial values/Velocity=x"},
               1.4,
               exact_impact(1.4));
  deallog << images.words(1e-12) << std::endl;
  check_strip();
}
