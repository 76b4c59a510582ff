// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Obstacles with p = (s/eps)^m, doc/model.md section 4.
//
// 1. m = 1 is normal compliance: all columns of experiment 1 to T = 2, bit for
//    bit.
// 2. b = zeta = a = 0, one cell of degree 1: u(1) + p(u(1) - g) = t(t), here
//    t = 2 sin(3 t), g = 0.1, eps = 0.3, m = 3/2, 2, 3: the equation holds at
//    all rows to 1e-11.
// 3. The same cell with zeta = 0.5: zeta u' + u + p(u - g) = t, against the
//    Runge-Kutta method of order 4 with steps of 1e-4, tolerance 1e-9: 1e-7.
// 4. One cell, lumped mass: a mass b/2 on a spring of stiffness 1, thrown with
//    velocity 1 at an obstacle at g = 0.1. Contact begins at asin(w g)/w, w^2 =
//    2; the energy E = v^2/4 + u^2/2 + eps/(m+1) (s/eps)^(m+1) = 1/4 says v(u),
//    so that the mass comes back with the velocity with which it came, after 2
//    times the integral of du/v from g to the largest u: u = u_max - (u_max -
//    g) y^2 and Gauss's rule. Both times and the velocity to 1e-8, tolerance
//    1e-11; eps = 0.1, m = 3/2, 2, 3.
// 5. The audit of backward Euler, each line by its own formula, of experiment 1
//    with m = 3/2, in 1-D, and of a strip before a curved obstacle: to 1e-11 of
//    the largest term; without loads the energy never increases, and no step
//    creates any (numerical dissipation to -1e-12).
// 6. A strip on rollers equals the rod: all columns to 1e-9 of the largest.
// 7. Orders: a preload in equilibrium, u = -x/10, g = -0.2, eps = 0.1^(1/3), so
//    that p = 1/10, and the traction t^4/2: u(1) at t = 1 in contact, one cell
//    of degree 2 (many have viscous modes too fast for these steps), steps of
//    1/80 and 1/160 against sdirk4 with 1/1280: order of the scheme to 0.15.
// 8. Massless nodes in equilibrium (zeta = 0), error-controlled: the run is
//    complete, contact begins and ends in turn, the audit closes to 1e-11.

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



  void
  check_linear()
  {
    const std::string file = "paper/experiment-1.prm";
    const Overrides   end{"Time/End time=2"};
    const RecordedRun linear = run<1>(file, end);
    const RecordedRun one =
      run<1>(file, end + power + Overrides{"Contact/Exponent=1"});
    bool is_same = linear.rows.size() == one.rows.size();
    for (unsigned int i = 0; is_same && i < one.rows.size(); ++i)
      is_same = all_columns(linear.rows[i]) == all_columns(one.rows[i]);
    deallog << "m = 1: the same to the last bit " << is_same << ", contact "
            << (one.events.size() > 0) << std::endl;
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



  void
  check_audit(const std::string &title,
              const RecordedRun &result,
              const bool         is_backward_euler)
  {
    const std::vector<StepRecord> &rows = result.rows;
    double largest = 0., defect = 0., increase = 0., created = 0.;
    bool   has_contact = false;
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        const StepRecord &r = rows[i];
        for (const double term :
             {r.energy, r.work, r.dissipation, r.numerical_dissipation})
          raise(largest, std::abs(term));
        raise(defect,
              std::abs(rows[0].energy + r.work - r.energy - r.dissipation -
                       r.numerical_dissipation));
        if (i > 0)
          {
            raise(increase, r.energy - rows[i - 1].energy);
            raise(created,
                  rows[i - 1].numerical_dissipation - r.numerical_dissipation);
          }
        has_contact |= r.in_contact;
      }
    deallog << title << ": contact " << has_contact << ", audit "
            << within(defect / largest, 1e-11);
    if (is_backward_euler)
      deallog << ", energy never increases "
              << within(increase / largest, 1e-12) << ", none created "
              << within(created / largest, 1e-12);
    deallog << std::endl;
  }



  const Overrides euler{"Time/Scheme=backward euler",
                        "Time/Start=consistent",
                        "Time/Step size=0.01",
                        "Time/End time=2"};

  const Overrides strip{"Dimension=2",
                        "Mesh/Cells=4",
                        "Mesh/Degree=2",
                        "Mesh/Cells across=2"};



  void
  check_strip()
  {
    const Overrides scene =
      law(0.05, 1.5, 0.1) + euler +
      Overrides{"Mesh/Cells=4", "Mesh/Degree=2", "Time/End time=1"};
    const RecordedRun rod   = run<1>("", scene);
    const RecordedRun body  = run<2>("", scene + strip);
    double            error = rod.rows.size() == body.rows.size() ? 0. : 1.;
    for (unsigned int column = 0; column < 18; ++column)
      {
        double change = 0., largest = 1e-3;
        for (unsigned int i = 0; i < rod.rows.size(); ++i)
          {
            const double x = all_columns(rod.rows[i])[column];
            raise(change, std::abs(x - all_columns(body.rows[i])[column]));
            raise(largest, std::abs(x));
          }
        raise(error, change / largest);
      }
    deallog << "strip equals rod " << within(error, 1e-9) << ", contact "
            << (rod.rows.back().contact_impulse > 0.) << std::endl;
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
  check_linear();
  for (const double m : {1.5, 2., 3.})
    check_scalar_equations(m);
  for (const double m : {1.5, 2., 3.})
    check_spring_and_mass(m);
  check_audit("backward euler", run<1>("", law(0.05, 1.5, 0.1) + euler), true);
  check_audit("strip, curved obstacle",
              run<2>("",
                     power + strip + euler +
                       Overrides{"Contact/Compliance=0.02",
                                 "Contact/Gap=0.05+5*(y-0.03)^2",
                                 "Boundary/Lateral support=free"}),
              true);
  check_strip();
  check_orders();
  const RecordedRun elastic =
    run<1>("",
           law(0.05, 1.5, 0.1) + Overrides{"Model/Fields=displacement",
                                           "Model/Viscosity=0",
                                           "Initial values/Velocity=x",
                                           "Time/End time=4"});
  check_audit("massless nodes", elastic, false);
  bool are_in_turn = elastic.events.size() >= 2;
  for (unsigned int i = 0; i < elastic.events.size(); ++i)
    are_in_turn &=
      (elastic.events[i].kind == ContactEvent::begin) == (i % 2 == 0);
  deallog << "events in turn " << are_in_turn << std::endl;
}
