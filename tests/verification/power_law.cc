// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Obstacles with p = (s/eps)^m, doc/model.md section 4.
//
// 1. b = zeta = a = 0, one cell of degree 1: u(1) + p(u(1) - g) = t(t), here
//    t = 2 sin(3 t), g = 0.1, eps = 0.3, m = 3/2, 2, 3: the equation holds at
//    all rows to 1e-11.
// 2. The same cell with zeta = 0.5: zeta u' + u + p(u - g) = t, against the
//    Runge-Kutta method of order 4 with steps of 1e-4, tolerance 1e-9: 1e-7.
// 3. One cell, lumped mass: a mass b/2 on a spring of stiffness 1, thrown with
//    velocity 1 at an obstacle at g = 0.1. Contact begins at asin(w g)/w, w^2 =
//    2; the energy E = v^2/4 + u^2/2 + eps/(m+1) (s/eps)^(m+1) = 1/4 says v(u),
//    so that the mass comes back with the velocity with which it came, after 2
//    times the integral of du/v from g to the largest u: u = u_max - (u_max -
//    g) y^2 and Gauss's rule. Both times and the velocity to 1e-8, tolerance
//    1e-11; eps = 0.1, m = 3/2, 2, 3.
// 4. Orders: a preload in equilibrium, u = -x/10, g = -0.2, eps = 0.1^(1/3), so
//    that p = 1/10, and the traction t^4/2: u(1) at t = 1 in contact, one cell
//    of degree 2 (many have viscous modes too fast for these steps), steps of
//    1/80 and 1/160 against sdirk4 with 1/1280: order of the scheme to 0.15.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const Overrides power{"Contact/Condition=power law"};



  Overrides
  law(const double eps, const double m, const double gap)
  {
    return power + Overrides{"Contact/Compliance=" + number(eps),
                             "Contact/Exponent=" + number(m),
                             "Contact/Gap=" + number(gap)};
  }



  double
  pressure(const double s, const double eps, const double m)
  {
    return s > 0. ? std::pow(s / eps, m) : 0.;
  }



  const Overrides one_cell{"Model/Fields=displacement",
                           "Mesh/Cells=1",
                           "Mesh/Degree=1"};



  void
  check_scalar_equations(const double m)
  {
    const double    eps = 0.3, g = 0.1, zeta = 0.5;
    const Overrides scene = one_cell + law(eps, m, g) +
                            Overrides{"Model/Inertia=0",
                                      "Sources/End traction=2*sin(3*t)",
                                      "Time/End time=2"};
    double error = 0., largest = 0.;
    for (const StepRecord &r :
         run<1>("", scene + Overrides{"Model/Viscosity=0"}).rows)
      {
        const double p = pressure(r.displacement_end - g, eps, m);
        raise(error,
              std::abs(r.displacement_end + p - 2. * std::sin(3. * r.time)));
        raise(error, std::abs(p - r.contact_force));
        raise(largest, p);
      }

    const auto rate = [&](const double t, const double u) {
      return (2. * std::sin(3. * t) - u - pressure(u - g, eps, m)) / zeta;
    };
    double creep_error = 0., t = 0., u = 0.;
    for (const StepRecord &r :
         run<1>("",
                scene + Overrides{"Model/Viscosity=0.5", "Time/Tolerance=1e-9"})
           .rows)
      {
        const unsigned int n =
          std::max(1u, static_cast<unsigned int>((r.time - t) / 1e-4) + 1);
        const double h = (r.time - t) / n;
        for (unsigned int i = 0; i < n; ++i, t += h)
          {
            const double k1 = rate(t, u);
            const double k2 = rate(t + h / 2., u + h / 2. * k1);
            const double k3 = rate(t + h / 2., u + h / 2. * k2);
            const double k4 = rate(t + h, u + h * k3);
            u += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
          }
        t = r.time;
        raise(creep_error, std::abs(r.displacement_end - u));
      }
    deallog << "m = " << m << ": in contact " << (largest > 0.5)
            << ", equilibrium " << within(error, 1e-11) << ", creep "
            << within(creep_error, 1e-7) << std::endl;
  }



  void
  check_spring_and_mass(const double m)
  {
    const double eps = 0.1, g = 0.1, w = std::sqrt(2.);
    const auto   square_of_velocity = [&](const double u) {
      const double s = u - g;
      return 1. - 2. * u * u -
             4. * eps / (m + 1.) * std::pow(std::max(s, 0.) / eps, m + 1.);
    };
    double low = g, high = 1.;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const double middle                            = 0.5 * (low + high);
        (square_of_velocity(middle) > 0. ? low : high) = middle;
      }
    const QIterated<1> rule(QGauss<1>(8), 200);
    double             duration = 0.;
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const double y = rule.point(q)[0];
        const double u = low - (low - g) * y * y;
        duration += 4. * rule.weight(q) * (low - g) * y /
                    std::sqrt(square_of_velocity(u));
      }
    const double begin    = std::asin(w * g) / w;
    const double velocity = std::sqrt(square_of_velocity(g));

    const auto events = run<1>("",
                               one_cell + law(eps, m, g) +
                                 Overrides{"Model/Viscosity=0",
                                           "Mesh/Mass matrix=lumped",
                                           "Initial values/Velocity=x",
                                           "Time/Tolerance=1e-11",
                                           "Time/End time=2"})
                          .events;
    const bool has_two = events.size() >= 2;
    deallog << "m = " << m << ", spring and mass: begin, end, velocity to 1e-8 "
            << (has_two && std::abs(events[0].time - begin) < 1e-8) << ' '
            << (has_two && std::abs(events[1].time - begin - duration) < 1e-8)
            << ' '
            << (has_two && std::abs(events[0].velocity - velocity) < 1e-8 &&
                std::abs(events[1].velocity + velocity) < 1e-8)
            << std::endl;
  }



  double
  end_of_preload(const std::string &scheme, const double step)
  {
    const RecordedRun result =
      run<1>("",
             law(std::cbrt(0.1), 1.5, -0.2) +
               Overrides{"Model/Fields=displacement",
                         "Initial values/Displacement=-x/10",
                         "Initial values/Velocity=0",
                         "Sources/End traction=t^4/2",
                         "Time/Scheme=" + scheme,
                         "Time/Step size=" + number(step),
                         "Time/Start=consistent",
                         "Mesh/Cells=1",
                         "Mesh/Degree=2",
                         "Time/End time=1"});
    return result.rows.back().displacement_end;
  }



  void
  check_orders()
  {
    const double exact = end_of_preload("sdirk4", 1. / 1280.);
    for (const auto &[scheme, order] : {std::pair("backward euler", 1.),
                                        std::pair("sdirk2", 2.),
                                        std::pair("sdirk3", 3.),
                                        std::pair("sdirk4", 4.)})
      {
        const double coarse = end_of_preload(scheme, 1. / 80.) - exact;
        const double fine   = end_of_preload(scheme, 1. / 160.) - exact;
        const double rate   = std::log2(std::abs(coarse / fine));
        deallog << scheme << ": order " << order << ' '
                << within(std::abs(rate - order), 0.15) << std::endl;
        if (!(std::abs(rate - order) < 0.15))
          deallog << rate << std::endl;
      }
  }
} // namespace



void
main_power_law()
{
  initlog();
  for (const double m : {1.5, 2., 3.})
    check_scalar_equations(m);
  for (const double m : {1.5, 2., 3.})
    check_spring_and_mass(m);
  check_orders();
}
