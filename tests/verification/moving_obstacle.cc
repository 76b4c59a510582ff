// SPDX-License-Identifier: LGPL-2.1-or-later
//
// An obstacle that moves, Contact/Gap in t, doc/contact-in-time.md section 8.
//
// 1. u = x w(t), w = -(2 + sin 3t)/10, has the stress w + zeta w' everywhere,
//    so that it solves the equations of a rod with the body force b x w'' whose
//    obstacle is at g = w - s(p), p = -(w + zeta w') > 0: s = eps p, eps
//    p^(2/3) for m = 3/2, 0 for a rigid one. b = 1/2, zeta = 1/20, eps = 1/10.
//    Its displacement and velocity at fixed steps have at least the orders 1 to
//    4, less 0.15 (orders 3 and 4 of the velocity and 4 of the pressure on an
//    elastic obstacle, whose errors change sign there, are not asked); so has
//    the pressure of an elastic obstacle, and the impulse of a rigid one, int p
//    dt = 0.4 + (1 - cos 6)/30 + sin(6)/200 over [0, 2]; so has the work of
//    the obstacle, -int p g' dt by Simpson's rule. With sdirk4 the rigid one is
//    asked for 1e-10 of the displacement, which is rounding, and 1e-7 of the
//    work, whose pressures are of lower order; so where the end is held by it
//    until an event, to 1e-9 (measured: 1e-10).
// 2. A spring and a mass, one cell, lumped, zeta = 0: k = 1, M = b/2. A rigid
//    obstacle touches it, rests until t = 1, comes with V = 1/5 until t = 2
//    and rests again. At t = 1 the impulse M V, then the force V (t - 1): the
//    impulse M V + V/2, the work M V^2 + V^2/2, the loss M V^2/2 up to t = 2.
//    There the mass leaves with V and swings, V^2 (1 + M) = A^2, until it is
//    back at -V: it meets the obstacle with the velocity V at
//    t = 2 + 2 atan(sqrt M) sqrt M. Fixed steps, which end at
//    the turns by themselves, and error control: times,
//    velocities, impulse, work and loss to 1e-7.
// 3. Without inertia u = x w(t), w + zeta w' = -p, before a damped obstacle,
//    p = s [1 + c (w' - g')]_+/eps, s = w - g, that comes with 3/10 and turns
//    at t = 1/2 to leave with 3/10. There w goes on, and the viscous rod gets
//    w' = -(w + s (1 - c g')/eps)/(zeta + c s/eps) with g' behind the turn.
//    Without viscosity p = -w goes on, and the row has the velocity w' in front
//    of the turn, that of p with g' there. eps = 1/10, c = 2, zeta = 1/20 or 0:
//    velocity and force of that row by its displacement and gap, and the rate
//    of the gap that its state has, to 1e-12.
// 4. A rod at rest, b = 1, zeta = 0, meets a rigid obstacle that comes with V =
//    1/100 from g = 1/200, at t = 1/2 with the velocity V, and is pressed with
//    V until the obstacle turns at t = 1 and leaves with 3 V: the end, without
//    force, stands still, so that contact ends there with -3 V. The scheme
//    energy conserving, which does not locate events, has the times to a step,
//    dt = 1/100, and no velocity at the end of contact, whose nodes have no
//    mass; box has all to rounding.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const std::string w = "-0.1*(2+sin(3*t))";
  const std::string p = "(0.2+0.1*sin(3*t)+0.015*cos(3*t))";
  constexpr double  T = 2.;



  /** The obstacle of a law: its gap and the rate of it. */
  struct Obstacle
  {
    std::string name;
    Overrides   law;
    std::string gap;
    double      power; ///< s = 0.1 p^power; 0: rigid
  };



  double
  exact_pressure(const double t)
  {
    return 0.2 + 0.1 * std::sin(3. * t) + 0.015 * std::cos(3. * t);
  }



  double
  power_of_obstacle(const Obstacle &obstacle, const double t)
  {
    const double pressure = exact_pressure(t);
    const double rate     = 0.3 * std::cos(3. * t) - 0.045 * std::sin(3. * t);
    double       g_rate   = -0.3 * std::cos(3. * t);
    if (obstacle.power > 0.)
      g_rate -=
        0.1 * obstacle.power * std::pow(pressure, obstacle.power - 1.) * rate;
    return -pressure * g_rate;
  }



  double
  work_of_obstacle(const Obstacle &obstacle)
  {
    constexpr unsigned int n   = 2000;
    double                 sum = 0.;
    for (unsigned int i = 0; i <= n; ++i)
      sum += (i == 0 || i == n ? 1. :
              i % 2 == 1       ? 4. :
                                 2.) *
             power_of_obstacle(obstacle, T * i / n);
    return sum * T / n / 3.;
  }



  void
  check_orders(const Obstacle    &obstacle,
               const std::string &scheme,
               const unsigned int order,
               const unsigned int n_steps)
  {
    double error[2][5];
    double force_work = 0.; // of the body force, int int 0.45 x sin 3t x w'
    force_work        = -0.45 * 0.3 / 3. * (std::sin(6.) * std::sin(6.)) / 6.;
    for (unsigned int k = 0; k < 2; ++k)
      {
        const StepRecord r =
          run<1>("",
                 obstacle.law +
                   Overrides{"Contact/Gap=" + obstacle.gap,
                             "Model/Fields=displacement",
                             "Model/Inertia=0.5",
                             "Model/Viscosity=0.05",
                             "Sources/Body force=0.45*x*sin(3*t)",
                             "Contact/Massless nodes=off",
                             "Initial values/Displacement=-0.2*x",
                             "Initial values/Velocity=-0.3*x",
                             "Mesh/Cells=3",
                             "Mesh/Degree=2",
                             "Time/Scheme=" + scheme,
                             "Time/Start=consistent",
                             "Time/End time=2",
                             "Time/Step size=" + number(T / (n_steps << k))})
            .rows.back();
        error[k][0] = std::abs(r.displacement_mid + 0.05 * (2. + std::sin(6.)));
        error[k][1] = std::abs(r.velocity_end + 0.3 * std::cos(6.));
        error[k][2] = std::abs(r.contact_force - exact_pressure(T));
        error[k][3] = std::abs(r.contact_impulse - 0.4 -
                               (1. - std::cos(6.)) / 30. - std::sin(6.) / 200.);
        error[k][4] =
          std::abs(r.work - force_work - work_of_obstacle(obstacle));
      }
    // the order that is asked for, if there is that or more
    const auto order_of = [&](const unsigned int i) {
      return number(std::min(std::log2(error[0][i] / error[1][i]) + 0.15,
                             static_cast<double>(order)));
    };
    const bool   is_rigid = obstacle.power == 0.;
    const bool   is_exact = is_rigid && order == 4; // but for rounding
    const double bound    = obstacle.name == "rigid" ? 1e-10 : 1e-9;
    deallog << obstacle.name << ", " << scheme << ": displacement "
            << (is_exact ? within(error[1][0], bound) : order_of(0))
            << ", velocity " << (!is_rigid && order > 2 ? "-" : order_of(1))
            << (is_rigid ? ", impulse " : ", pressure ")
            << (!is_rigid && order > 3 ? "-" : order_of(is_rigid ? 3 : 2))
            << ", work " << (is_exact ? within(error[1][4], 1e-7) : order_of(4))
            << std::endl;
  }



  const Overrides spring_and_mass{"Model/Fields=displacement",
                                  "Model/Inertia=0.5",
                                  "Model/Viscosity=0",
                                  "Mesh/Degree=1",
                                  "Initial values/Displacement=0",
                                  "Initial values/Velocity=0"};



  void
  check_turns(const std::string &name, const Overrides &time)
  {
    const RecordedRun result =
      run<1>("",
             spring_and_mass + time +
               Overrides{"Contact/Condition=rigid",
                         "Contact/Gap=-if(t<1,0,if(t<2,0.2*(t-1),0.2))",
                         "Mesh/Cells=1",
                         "Mesh/Mass matrix=lumped",
                         "Time/End time=3.5"});
    const double M = 0.25, V = 0.2;
    double       error = 1.;
    for (const StepRecord &r : result.rows)
      if (std::abs(r.time - 2.) < 1e-9)
        {
          error = 0.;
          raise(error, std::abs(r.contact_impulse - M * V - 0.5 * V));
          raise(error, std::abs(r.work - (M + 0.5) * V * V));
          raise(error, std::abs(r.numerical_dissipation - 0.5 * M * V * V));
          raise(error, std::abs(r.energy - 0.5 * (M + 1.) * V * V));
        }
    const double back = 2. + 2. * std::atan(std::sqrt(M)) * std::sqrt(M);
    unsigned int n    = 0;
    for (const ContactEvent &event : result.events)
      {
        if (std::abs(event.time - 2.) < 1e-9)
          {
            raise(error, event.kind == ContactEvent::end ? 0. : 1.);
            raise(error, std::abs(event.velocity + V));
            ++n;
          }
        if (event.time > 2.1 && n == 1)
          {
            raise(error, event.kind == ContactEvent::begin ? 0. : 1.);
            raise(error, std::abs(event.time - back));
            raise(error, std::abs(event.velocity - V));
            ++n;
          }
      }
    deallog << "obstacle turns, " << name << ": leaves and meets " << (n == 2)
            << ", impulse, work, loss, times, velocities to 1e-7 "
            << within(error, 1e-7) << std::endl;
    if (!(error < 1e-7) || n != 2)
      {
        deallog << error << std::endl;
        for (const ContactEvent &event : result.events)
          deallog << event.time << ' ' << event.kind << ' ' << event.velocity
                  << std::endl;
      }
  }



  void
  check_damped_turn(const double zeta, const Overrides &time)
  {
    double        error = 1.;
    Simulation<1> rod(
      read_parameters("",
                      time + Overrides{"Model/Fields=displacement",
                                       "Model/Inertia=0",
                                       "Model/Viscosity=" + number(zeta),
                                       "Initial values/Displacement=0",
                                       "Contact/Compliance=0.1",
                                       "Contact/Damping=2",
                                       "Contact/Gap=-0.2+0.3*abs(t-0.5)",
                                       "Mesh/Cells=2",
                                       "Mesh/Degree=1",
                                       "Time/Scheme=sdirk4",
                                       "Time/End time=0.6"}),
      MPI_COMM_SELF);
    rod.run({[&](const Simulation<1> &simulation) {
      const StepRecord &r = simulation.record();
      if (std::abs(r.time - 0.5) > 1e-12)
        return;
      const double w = r.displacement_end, spring = -r.gap / 0.1;
      const double rate = zeta > 0. ? 0.3 : -0.3;
      const double velocity =
        zeta > 0. ? -(w + spring * (1. - 2. * rate)) / (zeta + 2. * spring) :
                    rate + 0.5 * (-w / spring - 1.);
      error = std::abs(simulation.state().gap_rate[0] - rate);
      raise(error, std::abs(r.velocity_end - velocity));
      raise(error, std::abs(r.contact_force + w + zeta * velocity));
    }});
    deallog << "damped obstacle turns, zeta = " << zeta << ", " << time[0]
            << ": rates and force to 1e-12 " << within(error, 1e-12)
            << std::endl;
    if (!(error < 1e-12))
      deallog << error << std::endl;
  }



  /** Part 4. */
  void
  check_retreat()
  {
    Simulation<1> simulation(
      read_parameters("",
                      {"Model/Fields=displacement",
                       "Model/Viscosity=0",
                       "Initial values/Velocity=0",
                       "Contact/Condition=rigid",
                       "Contact/Gap=0.005-0.01*min(t,1)+0.03*max(t-1,0)",
                       "Mesh/Cells=100",
                       "Mesh/Degree=1",
                       "Time/Scheme=energy conserving",
                       "Time/Step size=0.01",
                       "Time/End time=1.5"}),
      MPI_COMM_SELF);
    simulation.run();
    deallog << "obstacle leaves a rod at rest:";
    for (const ContactEvent &event : simulation.events())
      {
        const bool begins = event.kind == ContactEvent::begin;
        deallog << (begins ? " begins " : " ends ")
                << noise_within(std::abs(event.time - (begins ? 0.5 : 1.)),
                                0.0101)
                << " with " << event.velocity;
      }
    deallog << ", force "
            << within(std::abs(simulation.history().max_contact_force - 0.01),
                      5e-3)
            << std::endl;
  }
} // namespace



void
main_moving_obstacle()
{
  initlog();
  const std::string           compliance = "Contact/Compliance=0.1";
  const std::vector<Obstacle> obstacles{
    {"normal compliance", {compliance}, w + "-0.1*" + p, 1.},
    {"power law",
     {compliance, "Contact/Condition=power law"},
     w + "-0.1*" + p + "^(2/3)",
     2. / 3.},
    {"rigid", {"Contact/Condition=rigid"}, w, 0.},
    {"holding",
     {"Contact/Condition=rigid", "Time/Locate contact events=true"},
     w,
     0.}};
  for (const Obstacle &obstacle : obstacles)
    {
      check_orders(obstacle, "backward euler", 1, 1280);
      check_orders(obstacle, "sdirk2", 2, 80);
      check_orders(obstacle, "sdirk3", 3, 80);
      check_orders(obstacle, "sdirk4", 4, 80);
    }
  check_turns("error control", {"Time/Tolerance=1e-11"});
  check_turns("fixed steps",
              {"Time/Step size=0.0025",
               "Time/Break points=1; 2",
               "Time/Locate contact events=true"});
  check_turns("fixed steps beside the bends",
              {"Time/Step size=0.0037", "Time/Locate contact events=true"});
  for (const double zeta : {0.05, 0.})
    for (const Overrides &time :
         {Overrides{"Time/Tolerance=1e-6"}, Overrides{"Time/Step size=0.04"}})
      check_damped_turn(zeta, time);
  check_retreat();
}
