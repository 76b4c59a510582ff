// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Ends that are free, or carry springs, dashpots and masses, and heat at the
// end x = 0: doc/model.md (M1.7), (M1.8).
//
// 1. Modes of an elastic rod with s_A, m_A on the left and s, m on the right:
//      u = (cos(q x) + r sin(q x)) cos(w t), q = w sqrt(b),
//      q r = s_A - m_A w^2,  q (r cos q - sin q) = (m w^2 - s)(cos q + r sin
//      q),
//    or u = sin(q x) cos(w t) of a clamped one with q cos q = (m w^2 - s) sin
//    q; w by bisection between the bounds in the code, in which one sign
//    changes. u(1) to 1e-8 for t up to 5.
// 2. Without inertia, zeta = 0.2, traction 0.3 on the right, s_A = 2, d_A =
// 0.5:
//      u(0) = 0.3/s_A (1 - exp(-s_A t/d_A)), u(1) - u(0) = 0.3 (1 -
//      exp(-t/zeta))
//    to 1e-7 at T = 1. Without viscosity the spring alone, u(1) = 0.3 t 1.5; in
//    contact, g = 0.1, eps = 0.1: p = (0.45 t - 0.1)/(eps + 1.5), to 1e-10.
// 3. A dashpot d_A = sqrt(b) takes all waves: of a smooth pulse, whose parts
// have
//    passed the end at t = 2 sqrt(b), nothing is left: 1e-10 of the energy with
//    box, which has no dispersion, and 1e-7 with sdirk4.
// 4. A free rod that flies at a wall with velocity 1 (b = 1, gap 0.1), box:
// force
//    1 for 0.1 < t < 2.1, impulse 2, velocity -1 behind, to 1e-12; a strip and
//    a block, free at all sides, direct and iterative, that fly with velocity
//    0.5: u(1) = 0.5 t to 1e-10.
// 5. Equal tractions on both free ends: the middle rests, 1e-12; and the energy
// is
//    their work, to 1e-10 of it.
// 6. Heat: k_A = 2, theta_sA = 5, k = 1, theta_obs = 1: at rest the flux is
//    4/(1/k_A + 1 + 1/k) = 1.6 and theta(1) = 2.6, to 1e-8, and its energy
//    0. Insulated ends and h_A = 0.3 t: the mean rises by 0.15 t^2, to 1e-10.
//    The mode cos(mu x) exp(-mu^2 t) of an insulated end, mu tan mu = k:
//    theta(1) to 1e-8.
// 7. All of it with backward Euler, a = 0.3: E + D + N - W is that of the start
// to
//    1e-12.

#include <algorithm>
#include <functional>

#include "../tests.h"

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  double
  root(double low, double high, const std::function<double(double)> &f)
  {
    const bool is_rising = f(low) < 0.;
    for (unsigned int i = 0; i < 80; ++i)
      {
        const double middle                          = 0.5 * (low + high);
        ((f(middle) < 0.) == is_rising ? low : high) = middle;
      }
    return low;
  }



  std::vector<std::string>
  joined(std::vector<std::string> a, const std::vector<std::string> &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }



  const std::vector<std::string> elastic = {"Model/Fields=displacement",
                                            "Model/Viscosity=0",
                                            "Contact/Condition=none",
                                            "Initial values/Velocity=0"};

  const std::vector<std::string> accurate = {"Time/Scheme=sdirk4",
                                             "Time/Tolerance=1e-11",
                                             "Mesh/Cells=4",
                                             "Mesh/Degree=10"};



  struct End
  {
    double spring, mass;
  };

  void
  check_mode(const bool   is_free,
             const End   &left,
             const End   &right,
             const double b,
             const double low,
             const double high)
  {
    const auto wave = [&](const double w) { return w * std::sqrt(b); };
    const auto r    = [&](const double w) {
      return (left.spring - left.mass * w * w) / wave(w);
    };
    const auto shape = [&](const double w, const double x) {
      return is_free ? std::cos(wave(w) * x) + r(w) * std::sin(wave(w) * x) :
                       std::sin(wave(w) * x);
    };
    const auto slope = [&](const double w, const double x) {
      return wave(w) * (is_free ?
                          r(w) * std::cos(wave(w) * x) - std::sin(wave(w) * x) :
                          std::cos(wave(w) * x));
    };
    const double       w = root(low, high, [&](const double w) {
      return slope(w, 1.) - (right.mass * w * w - right.spring) * shape(w, 1.);
    });
    std::ostringstream initial;
    initial << std::setprecision(17);
    if (is_free)
      initial << "cos(" << wave(w) << "*x)+" << r(w) << "*";
    initial << "sin(" << wave(w) << "*x)";
    std::vector<std::string> entries =
      joined(joined(elastic, accurate),
             {entry("Model/Inertia", b),
              "Initial values/Displacement=" + initial.str(),
              entry("Boundary/right/Spring", right.spring),
              entry("Boundary/right/Mass", right.mass),
              "Time/End time=5"});
    if (is_free)
      entries = joined(entries,
                       {"Boundary/left/Support=free",
                        entry("Boundary/left/Spring", left.spring),
                        entry("Boundary/left/Mass", left.mass)});
    double error = 0.;
    for (const StepRecord &row : run<1>("", entries).rows)
      raise(error,
            std::abs(row.displacement_end -
                     shape(w, 1.) * std::cos(w * row.time)));
    deallog << (is_free ? "free" : "clamped") << ", s_A = " << left.spring
            << ", m_A = " << left.mass << ", s = " << right.spring
            << ", m = " << right.mass << ", b = " << b << ": u(1) "
            << within(error, 1e-8) << std::endl;
  }



  void
  check_without_inertia()
  {
    const std::vector<std::string> common =
      joined(accurate,
             {"Model/Fields=displacement",
              "Model/Inertia=0",
              "Contact/Condition=none",
              "Boundary/left/Support=free",
              "Boundary/left/Spring=2",
              "Time/End time=1"});
    const double viscous = run<1>("",
                                  joined(common,
                                         {"Model/Viscosity=0.2",
                                          "Boundary/left/Dashpot=0.5",
                                          "Boundary/right/Traction=0.3"}))
                             .rows.back()
                             .displacement_end;
    deallog << "viscous: u(1) "
            << within(std::abs(viscous - 0.15 * (1. - std::exp(-4.)) -
                               0.3 * (1. - std::exp(-5.))),
                      1e-7)
            << std::endl;
    const StepRecord open =
      run<1>("",
             joined(common,
                    {"Model/Viscosity=0", "Boundary/right/Traction=0.3*t"}))
        .rows.back();
    const StepRecord closed =
      run<1>("",
             joined(common,
                    {"Model/Viscosity=0",
                     "Boundary/right/Traction=0.3*t",
                     "Contact/Condition=normal compliance",
                     "Contact/Compliance=0.1",
                     "Contact/Gap=0.1"}))
        .rows.back();
    deallog << "static: u(1) "
            << within(std::abs(open.displacement_end - 0.45), 1e-10)
            << ", in contact p "
            << within(std::abs(closed.contact_force - 0.35 / 1.6), 1e-10)
            << std::endl;
  }



  void
  check_dashpot()
  {
    const std::vector<std::string> pulse =
      joined(elastic,
             {"Boundary/left/Support=free",
              "Boundary/left/Dashpot=2",
              "Model/Inertia=4",
              "Initial values/Velocity=(4*x*(1-x))^6",
              "Time/End time=4"});
    for (const bool is_box : {true, false})
      {
        const RecordedRun result =
          run<1>("",
                 joined(pulse,
                        is_box ? std::vector<std::string>{"Time/Scheme=box",
                                                          "Mesh/Cells=200"} :
                                 accurate));
        deallog << (is_box ? "box" : "sdirk4") << ": energy "
                << within(result.rows.back().energy / result.rows[0].energy,
                          is_box ? 1e-10 : 1e-7)
                << std::endl;
      }
  }



  void
  check_flight()
  {
    const RecordedRun wall  = run<1>("",
                                    {"Model/Fields=displacement",
                                      "Model/Viscosity=0",
                                      "Boundary/left/Support=free",
                                      "Initial values/Velocity=1",
                                      "Contact/Condition=rigid",
                                      "Contact/Gap=0.1",
                                      "Mesh/Cells=100",
                                      "Time/End time=3"});
    double            force = 0.;
    for (const StepRecord &row : wall.rows)
      if (row.time > 0.105 && row.time < 2.095)
        raise(force, std::abs(row.contact_force - 1.));
    const StepRecord &last = wall.rows.back();
    deallog << "wall: force " << within(force, 1e-12) << ", impulse "
            << within(std::abs(last.contact_impulse - 2.), 1e-12)
            << ", velocity " << within(std::abs(last.velocity_end + 1.), 1e-12)
            << ", begin " << within(std::abs(wall.events[0].time - 0.1), 1e-12)
            << ", end " << within(std::abs(wall.events[1].time - 2.1), 1e-12)
            << std::endl;
    const auto fly = [](const auto dim, const std::string &solver) {
      const RecordedRun result =
        run<dim.value>("",
                       {"Dimension=" + std::to_string(dim.value),
                        "Model/Fields=displacement",
                        "Model/Poisson ratio=0.3",
                        "Boundary/left/Support=free",
                        "Boundary/sides/Support=free",
                        "Initial values/Velocity=0.5",
                        "Contact/Condition=none",
                        "Mesh/Cells=4",
                        "Mesh/Cells across=2",
                        "Mesh/Degree=2",
                        "Mesh/Width=0.5",
                        "Solver/Linear solver=" + solver,
                        "Time/Scheme=sdirk4",
                        "Time/End time=1"});
      double error = 0.;
      for (const StepRecord &row : result.rows)
        raise(error, std::abs(row.displacement_end - 0.5 * row.time));
      deallog << dim.value << "-D, " << solver << ": u(1) "
              << within(error, 1e-10) << std::endl;
    };
    for (const std::string solver : {"direct", "iterative"})
      {
        fly(std::integral_constant<int, 2>(), solver);
        fly(std::integral_constant<int, 3>(), solver);
      }
  }



  void
  check_tractions()
  {
    const RecordedRun result =
      run<1>("",
             joined(joined(elastic, accurate),
                    {"Boundary/left/Support=free",
                     "Boundary/left/Traction=0.1*sin(3*t)",
                     "Boundary/right/Traction=0.1*sin(3*t)",
                     "Time/End time=4"}));
    double middle = 0., balance = 0., work = 0.;
    for (const StepRecord &row : result.rows)
      {
        raise(middle, std::abs(row.displacement_mid));
        raise(work, std::abs(row.work));
      }
    const StepRecord &last = result.rows.back();
    raise(balance, std::abs(last.energy - last.work) / work);
    deallog << "both ends pulled: middle " << within(middle, 1e-12)
            << ", energy " << within(balance, 1e-10) << std::endl;
  }



  void
  check_heat()
  {
    const std::vector<std::string> heat =
      joined(accurate,
             {"Model/Fields=temperature", "Boundary/left/Temperature=none"});
    const StepRecord rest = run<1>("",
                                   joined(heat,
                                          {"Boundary/left/Heat exchange=2",
                                           "Boundary/left/Surroundings=5",
                                           "Boundary/right/Heat exchange=1",
                                           "Boundary/right/Surroundings=1",
                                           "Time/End time=20"}))
                              .rows.back();
    deallog << "at rest: flux "
            << within(std::abs(rest.heat_flux_end - 1.6), 1e-8) << ", theta(1) "
            << within(std::abs(rest.temperature_end - 2.6), 1e-8) << ", energy "
            << within(rest.energy, 1e-12) << std::endl;
    const RecordedRun heated = run<1>("",
                                      joined(heat,
                                             {"Boundary/right/Heat exchange=0",
                                              "Boundary/left/Heat flux=0.3*t",
                                              "Initial values/Temperature=x^2",
                                              "Time/End time=2"}));
    double            mean   = 0.;
    for (const StepRecord &row : heated.rows)
      raise(mean,
            std::abs(row.temperature_mean - 1. / 3. -
                     0.15 * row.time * row.time));
    const double mu =
      root(0.5, 1.5, [](const double m) { return m * std::tan(m) - 1.; });
    double end = 0.;
    for (const StepRecord &row :
         run<1>("",
                joined(heat,
                       {entry("Constants/mu", mu),
                        "Initial values/Temperature=cos(mu*x)",
                        "Time/End time=2"}))
           .rows)
      raise(end,
            std::abs(row.temperature_end -
                     std::cos(mu) * std::exp(-mu * mu * row.time)));
    deallog << "insulated: mean " << within(mean, 1e-10) << ", mode "
            << within(end, 1e-8) << std::endl;
  }



  void
  check_audit()
  {
    const RecordedRun result  = run<1>("",
                                      {"Model/Coupling=0.3",
                                        "Boundary/left/Support=free",
                                        "Boundary/left/Spring=3",
                                        "Boundary/left/Dashpot=0.2",
                                        "Boundary/left/Mass=0.5",
                                        "Boundary/left/Traction=0.1*sin(5*t)",
                                        "Boundary/left/Temperature=none",
                                        "Boundary/left/Heat exchange=2",
                                        "Boundary/left/Surroundings=3",
                                        "Boundary/left/Heat flux=0.2*cos(t)",
                                        "Boundary/right/Spring=1",
                                        "Boundary/right/Dashpot=0.1",
                                        "Boundary/right/Mass=0.2",
                                        "Time/Scheme=backward euler",
                                        "Time/Start=consistent",
                                        "Time/Step size=0.01",
                                        "Time/End time=2",
                                        "Mesh/Cells=10",
                                        "Mesh/Degree=2"});
    double            balance = 0., size = 0.;
    const StepRecord &first = result.rows[0];
    for (const StepRecord &row : result.rows)
      {
        raise(size, row.energy + row.dissipation + std::abs(row.work));
        raise(balance,
              std::abs(row.energy + row.dissipation +
                       row.numerical_dissipation - row.work - first.energy));
      }
    deallog << "audit: balance " << within(balance / size, 1e-12)
            << (result.events.empty() ? ", no contact" : ", with contact")
            << std::endl;
  }
} // namespace



void
main_ends()
{
  initlog();
  check_mode(false, {0., 0.}, {0., 0.5}, 1., 0.5, 1.5);
  check_mode(false, {0., 0.}, {2., 0.5}, 0.25, 1., 3.);
  check_mode(true, {2., 0.}, {0., 0.}, 1., 0.5, 1.5);
  check_mode(true, {2., 0.3}, {1., 0.4}, 0.7, 1., 2.);
  check_mode(true, {0., 0.3}, {0., 0.4}, 1., 1., 3.);
  check_without_inertia();
  check_dashpot();
  check_flight();
  check_tractions();
  check_heat();
  check_audit();
}
