// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Rows of rods and masses, doc/model.md section 10, against closed forms.
// Unless something else is said b = 1, no heat, rigid contacts, scheme box;
// impedance Z = A sqrt(E rho).
//
// 1. Two free rods, Z = 1 (length 1/2, velocity 1) and Z = 2 (length 1, at
//    rest), side by side: p = 2/3 for 0 < t < 1, then they part with 1/3; the
//    same with Z = 2 made by the density alone (length 1/2, so that the waves
//    take as long) and with a soft rod (E = 1/4, Z = 1/2, length 1/4): p = 1/3.
//    Mirrored, the second one flies to the left: the same.
// 2. Cradle: four equal rods of length 1/2, the first with velocity 1: each
//    contact has force 1/2 for one transit 2 L/c = 1 from t = 0, 1/2, 1 on; the
//    last leaves with velocity 1, impulses are 1/2.
// 3. Mass M with velocity 1 on a rod that is clamped at its other end
//    (St-Venant), M = 1 and 2, m = 1/M: before t = 2 p = exp(-m t), behind
//      p = exp(-m t) + 2 exp(-m s) (1 - m s), s = t - 2,
//    until p = 0 at 1 - m s = -exp(-2 m)/2 where that is before t = 4; impulse
//      M (1 - exp(-2m)) + M exp(-2m) (1 - exp(-m s)) + 2 s exp(-m s).
//    Errors of the midpoint rule of the mass: of order 2 in the cells.
// 4. A ball that falls from height 1 with gravity 2 on the ground with e = 1/2:
//    impacts at t0 = 1 with velocity 2, then each e^n times 2 t0 later; at rest
//    at t0 (1 + e)/(1 - e) = 3 with the pressure m gamma. Two balls, m = 1 and
//    3, velocity 1 and 0, e = 1/2: velocities (1 - 3 e)/4 and (1 + e)/4 behind.
//    The energy that impacts take is booked, to rounding. The same with gravity
//    1 and an obstacle that comes with the acceleration 1.
// 5. Layers: a pressure 1 on the free left end of a rod with Z = 1 (length 1/2)
//    bonded to one with Z = 3 (length 1) at a rigid obstacle: the front
//    transmits 2 Z2/(Z1 + Z2) = 3/2, which a rigid obstacle doubles: p = 3 from
//    t = 3/2 up to the next echo at 5/2.
// 6. One rod cut in three: bonded parts are the rod, to rounding, with heat,
//    viscosity and a contact at its end, with box and sdirk4 (the same nodes).
//    Two parts in a contact that stays closed are the rod, too.
// 7. Heat alone: two rods of length 1/2, conductivity 1 and 2, k = 4 between
//    them, k = 1 to the obstacle at 0, theta_A = 10: resistances in a row
//    1/2 + 1/4 + 1/4 + 1 = 2, flux 5; temperature of the right end 5, to 1e-8.
//    An insulated rod at 0 beside a mass of heat capacity 2 at 3: both come
//    to 2. Two rods that exchange no heat rest at 2 and 5, which their ends
//    have: energy, work and dissipation are 0 on cells of any degree. Three
//    masses side by side at 1, 0 and 0, k = 2 by a law: the last one is at
//    1/3 - exp(-2 t)/2 + exp(-6 t)/6, with the order 2 of the scheme box. Two
//    masses, at 1 and 0, with k = 1 + 10 (t - 1/10) from t = 1/10 on differ by
//    exp(-0.8) at t = 3/10.
// 8. Two rods between walls that press on each other and exchange heat by
//    k(p) = 1/(1 - 12 (p - 1)), diffusivities 1 and 0.1, a = K = E = 1, no
//    inertia, no thermoelastic heating, q = 1: disturbances grow like
//    exp(0.343062 t) cos(1.116640 t), the root of the characteristic equation
//    with the largest real part, confirmed by the eigenvalues of finite
//    differences; by Prony's method from p(6), ..., p(9), to 1e-3.
// 9. All of it: rods, layers, masses, heat, k(gap, p), elastic contacts:
//    E + D + N - W is that of the start to 1e-12.
// 10. Three masses 1, 1, 3, the first with velocity 1, and an obstacle, with
// the
//    compliances 0.04, 0.01, 0.09 of their own and the gaps 0, 1, 1: one
//    contact after the other, each with the reduced mass m = 1/2, 3/4, 1/2, 3
//    and the velocity w = 1, 1, 1/2, 1/2: from 0, d1 + 1 - d1/2, ... on (masses
//    of equal weight exchange velocities, 1 and 3 part with -1/2 and 1/2) for
//    d = pi sqrt(m eps), with the force w sqrt(m/eps) and the impulse 2 m w. By
//    sdirk4 with a tolerance of 1e-8, whose steps end at each event; by box to
//    its order 2, impulses to rounding. Laws with an exponent, damping and a
//    dashpot of their own, or a compliance alone, are those of section Contact,
//    to rounding. The deepest penetration is the last, w sqrt(m eps). The
//    mirror image of three rods with such laws has the same forces, by box to
//    rounding, by sdirk4 to rounding that events multiply: a thousandth of its
//    tolerance.
// 11. Key results of a row. A mass that runs with 1 into a spring 0.1 away is
//    there from t = 0.1 on, 1 at t = 1.1, to 1e-7: the obstacle with nothing
//    behind, or a mass at rest before a far obstacle. The middle of a row is
//    that of its length, in the second of two rods of 1/4 and 3/4, which fly
//    apart with 1 and 2: displacement_mid is 2 t; mirrored it is -2 t. Two
//    masses 1 that press on each other with the overlap 0.1 of a spring 1 part
//    after a quarter of the period of their reduced mass, pi/2 (1/2)^(1/2);
//    they are the second and the third of a row. The force x per mass b = 1
//    moves a mass at x = 3/2, behind a rod of length 1 and a gap of 1/2, with
//    the acceleration 3/2.

#include <thermocontact/report/key_results.h>

#include <algorithm>
#include <functional>

#include "../tests.h"

#include "../recorded_run.h"
#include "../row_checks.h"

using namespace ThermoContact;

namespace
{
  const Overrides elastic = {"Model/Fields=displacement", "Model/Viscosity=0"};

  const Overrides free_ends = {"Boundary/left/Support=free",
                               "Boundary/right/Support=free"};

  const Overrides touching = {"Contact/Condition=rigid", "Contact/Gap=0"};



  /** Force, begin and end of the only contact, and the velocity behind. */
  void
  check_two(const std::string &name,
            const Overrides   &bodies,
            const double       force,
            const double       duration,
            const double       velocity)
  {
    const RecordedRun result = run<1>("",
                                      elastic + free_ends + touching + bodies +
                                        Overrides{"Time/End time=1.5"});
    double            error  = 0.;
    for (const StepRecord &row : result.rows)
      if (row.time > 0. && row.time < duration - row.step_size)
        raise(error, std::abs(row.contact_force - force));
    deallog << name << ": force " << within(error, 1e-12) << ", impulse "
            << within(std::abs(result.rows.back().contact_impulse -
                               force * duration),
                      1e-12)
            << ", end "
            << within(std::abs(result.events[1].time - duration), 1e-12)
            << ", velocity behind "
            << within(std::abs(result.events[1].velocity + velocity), 1e-10)
            << ", events " << result.events.size() << std::endl;
  }



  void
  check_cradle()
  {
    Overrides bodies;
    for (const std::string name : {"a", "b", "c", "d"})
      bodies =
        bodies +
        body(name, {"Length=0.5", name == "a" ? "Velocity=1" : "Velocity=0"});
    const RecordedRun result =
      run<1>("",
             elastic + free_ends + touching + bodies +
               Overrides{"Mesh/Cells=160", "Time/End time=3"});
    double force = 0., impulse = 0.;
    for (const StepRecord &row : result.rows)
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double since = row.time - 0.5 * i;
          if (since > 1.5 * row.step_size && since < 1. - 1.5 * row.step_size)
            raise(force, std::abs(row.contacts[i].contact_force - 0.5));
        }
    for (const ContactRecord &contact : result.rows.back().contacts)
      raise(impulse, std::abs(contact.contact_impulse - 0.5));
    const StepRecord &last  = result.rows.back();
    double            begin = 0.;
    unsigned int      n     = 0;
    for (const ContactEvent &event : result.events)
      if (event.kind == ContactEvent::begin && event.contact == n && n < 3)
        raise(begin, std::abs(event.time - 0.5 * n++));
    deallog << "cradle: force " << within(force, 1e-12) << ", impulses "
            << within(impulse, 1e-12) << ", begins " << within(begin, 1e-12)
            << " of " << n << ", the last one flies "
            << within(std::abs(last.displacement_end - (last.time - 1.5)),
                      1e-12)
            << std::endl;
  }



  void
  check_mass_on_rod(const double mass)
  {
    const double m = 1. / mass;
    const double s = (1. + 0.5 * std::exp(-2. * m)) / m, end = 2. + s;
    const auto   pressure = [m](const double t) {
      return std::exp(-m * t) +
             (t > 2. ? 2. * std::exp(-m * (t - 2.)) * (1. - m * (t - 2.)) : 0.);
    };
    const bool   ends_before_4 = end < 4.;
    const double impulse       = mass * (1. - std::exp(-2. * m)) +
                           mass * std::exp(-2. * m) * (1. - std::exp(-m * s)) +
                           2. * s * std::exp(-m * s);
    double errors[2], ends[2], impulses[2];
    for (const unsigned int i : {0, 1})
      {
        const RecordedRun result =
          run<1>("",
                 elastic + touching + body("bar", {"Length=1"}) +
                   body("hammer",
                        {"Kind=mass", entry("Mass", mass), "Velocity=-1"}) +
                   Overrides{"Boundary/right/Support=free",
                             entry("Mesh/Cells", 200 << i),
                             "Time/End time=3.9"});
        errors[i] = 0.;
        for (const StepRecord &row : result.rows)
          if (std::abs(row.time - 2.) > 2.5 * row.step_size &&
              row.time > 0.02 && row.time < end - 0.02)
            // rows have the force of the end of a step
            raise(errors[i], std::abs(row.contact_force - pressure(row.time)));
        ends[i] = ends_before_4 ? std::abs(result.events[1].time - end) : 0.;
        impulses[i] = ends_before_4 ?
                        std::abs(result.rows.back().contact_impulse - impulse) :
                        0.;
      }
    deallog << "mass " << mass << " on a rod: force " << within(errors[1], 1e-5)
            << ", of order 2 " << (errors[0] / errors[1] > 3.6);
    if (ends_before_4)
      deallog << ", end " << within(ends[1], 1e-5) << ", impulse "
              << within(impulses[1], 1e-5);
    deallog << std::endl;
  }



  void
  check_ball(const std::string &name,
             const Overrides   &falls,
             const double       bound)
  {
    const RecordedRun ball =
      run<1>("",
             elastic + body("ball", {"Kind=mass", "Mass=3"}) + falls +
               Overrides{"Boundary/left/Support=free",
                         "Contact/Condition=rigid",
                         "Contact/Restitution=0.5",
                         "Time/End time=3.7"});
    double time = 0., velocity = 0., hit = 1., speed = 2.;
    for (unsigned int n = 0; n < 8; ++n)
      {
        raise(time, std::abs(ball.events[2 * n].time - hit));
        raise(velocity, std::abs(ball.events[2 * n].velocity - speed));
        raise(velocity,
              std::abs(ball.events[2 * n + 1].velocity + 0.5 * speed));
        speed *= 0.5;
        hit += speed; // twice speed / gravity
      }
    const StepRecord &last = ball.rows.back();
    deallog << name << ": impacts " << within(time, 1e-12) << ", velocities "
            << within(velocity, 1e-11) << ", at rest "
            << within(std::abs(ball.events.back().time - 3.), 1e-10)
            << ", pressure " << within(std::abs(last.contact_force - 6.), 1e-10)
            << ", energy "
            << within(std::abs(last.energy + last.contact_dissipation -
                               last.work),
                      bound)
            << std::endl;
  }



  void
  check_balls()
  {
    check_ball("ball", {"Contact/Gap=1", "Sources/Body force=2"}, 1e-11);
    check_ball("ball, obstacle that gets faster",
               {"Contact/Gap=1-t^2/2", "Sources/Body force=1"},
               1e-11);
    const RecordedRun balls =
      run<1>("",
             elastic + body("a", {"Kind=mass", "Mass=1", "Velocity=1"}) +
               body("b", {"Kind=mass", "Mass=3"}) + free_ends +
               Overrides{"Contact/Condition=rigid",
                         "Contact/Gap=0.35",
                         "Contact/Restitution=0.5",
                         "Time/End time=1"});
    const StepRecord &end = balls.rows.back();
    // (1 + e)/4 of the second for what is left of the time
    deallog << "two balls: u(1) "
            << within(std::abs(end.displacement_end - 0.375 * 0.65), 1e-12)
            << ", impulse "
            << within(std::abs(end.contact_impulse - 3. * 0.375), 1e-12)
            << ", begin "
            << within(std::abs(balls.events[0].time - 0.35), 1e-12)
            << ", energy taken "
            << within(std::abs(end.contact_dissipation - 0.5 * 0.75 * 0.75),
                      1e-12)
            << std::endl;
  }



  void
  check_layers()
  {
    const RecordedRun result =
      run<1>("",
             elastic + touching + body("a", {"Length=0.5"}) +
               body("b", {"Length=1", "Section=3"}) +
               Overrides{"Contacts/a b/Condition=bonded",
                         "Boundary/left/Support=free",
                         "Boundary/left/Traction=-1",
                         "Mesh/Cells=150",
                         "Time/End time=2.4"});
    double before = 0., behind = 0.;
    for (const StepRecord &row : result.rows)
      if (row.time < 1.5 - row.step_size)
        raise(before, std::abs(row.contact_force));
      else if (row.time > 1.5 + row.step_size)
        raise(behind, std::abs(row.contact_force - 3.));
    deallog << "layers: before " << within(before, 1e-12) << ", behind "
            << within(behind, 1e-12) << std::endl;
  }



  void
  check_parts()
  {
    for (const std::string scheme : {"box", "sdirk4"})
      {
        const bool      is_box = scheme == "box";
        const Overrides common = {"Time/Scheme=" + scheme,
                                  is_box ? "Mesh/Degree=1" : "Mesh/Degree=3",
                                  "Model/Coupling=0.3",
                                  "Contact/Condition=normal compliance",
                                  "Contact/Compliance=0.02",
                                  "Contact/Gap=0.02",
                                  "Boundary/right/Heat exchange=2",
                                  "Boundary/left/Temperature=1",
                                  "Boundary/sides/Heat exchange=0.5",
                                  "Sources/Body force=0.2*sin(3*t)",
                                  "Time/End time=2"};
        const Overrides steps =
          is_box ? Overrides() : Overrides{"Time/Step size=0.01"};
        const RecordedRun whole =
          run<1>("",
                 common + steps +
                   Overrides{"Mesh/Cells=40",
                             "Initial values/Temperature=1-x",
                             "Initial values/Velocity=x"});
        const RecordedRun parts = run<1>(
          "",
          common + steps +
            body("a",
                 {"Length=0.25", "Cells=10", "Temperature=1-x", "Velocity=x"}) +
            body("b",
                 {"Length=0.5",
                  "Cells=20",
                  "Temperature=0.75-x",
                  "Velocity=0.25+x"}) +
            body("c",
                 {"Length=0.25",
                  "Cells=10",
                  "Temperature=0.25-x",
                  "Velocity=0.75+x"}) +
            Overrides{"Contacts/a b/Condition=bonded",
                      "Contacts/b c/Condition=bonded"});
        double u = 0., theta = 0., force = 0., scale = 0.;
        for (unsigned int i = 0; i < whole.rows.size(); ++i)
          {
            const StepRecord &a = whole.rows[i], &b = parts.rows[i];
            raise(u, std::abs(a.displacement_end - b.displacement_end));
            raise(theta, std::abs(a.temperature_end - b.temperature_end));
            raise(force, std::abs(a.contact_force - b.contact_force));
            raise(scale, std::abs(a.contact_force));
          }
        deallog << scheme << ", three parts: rows "
                << (whole.rows.size() == parts.rows.size()) << ", u(1) "
                << within(u, 1e-12) << ", theta(1) " << within(theta, 1e-12)
                << ", force " << within(force / scale, 1e-10) << std::endl;
      }
    // pressed from both sides, so that the cut stays closed
    const Overrides pressed =
      elastic + touching +
      Overrides{"Boundary/left/Support=free",
                "Boundary/left/Traction=-1-0.5*sin(6*t)^2",
                "Time/Scheme=box",
                "Mesh/Degree=1",
                "Time/End time=1.8"};
    const RecordedRun whole =
      run<1>("",
             pressed + Overrides{"Mesh/Cells=80", "Initial values/Velocity=0"});
    const RecordedRun cut =
      run<1>("",
             pressed + body("a", {"Length=0.5", "Cells=40"}) +
               body("b", {"Length=0.5", "Cells=40"}));
    double force = 0.;
    for (unsigned int i = 0; i < whole.rows.size(); ++i)
      raise(force,
            std::abs(whole.rows[i].contact_force -
                     cut.rows[i].contacts[1].contact_force));
    deallog << "cut: force at the obstacle " << within(force, 1e-11)
            << std::endl;
  }



  void
  check_resistances()
  {
    const Overrides heat = Overrides{"Model/Fields=temperature",
                                     "Boundary/left/Temperature=10",
                                     "Time/Tolerance=1e-10",
                                     "Time/End time=30"} +
                           body("a", {"Length=0.5"}) +
                           body("b", {"Length=0.5", "Conductivity=2"});
    const StepRecord rest =
      run<1>("",
             heat + Overrides{"Boundary/right/Heat exchange=1",
                              "Contacts/a b/Heat exchange=4"})
        .rows.back();
    deallog << "resistances: theta(1) "
            << within(std::abs(rest.temperature_end - 5.), 1e-8) << ", flux "
            << within(std::abs(rest.contacts[0].heat_flux - 5.), 1e-8) << ", "
            << within(std::abs(rest.contacts[1].heat_flux - 5.), 1e-8)
            << std::endl;
    const StepRecord mixed =
      run<1>("",
             body("rod", {"Length=1"}) +
               body("mass", {"Kind=mass", "Heat capacity=2", "Temperature=3"}) +
               Overrides{"Model/Fields=temperature",
                         "Boundary/left/Temperature=none",
                         "Boundary/right/Heat exchange=0",
                         "Contacts/rod mass/Heat exchange=5",
                         "Time/Tolerance=1e-10",
                         "Time/End time=40"})
        .rows.back();
    deallog << "mass and rod: temperatures "
            << within(std::abs(mixed.temperature_end - 2.), 1e-8) << std::endl;
    for (const double degree : {1., 2., 4.})
      {
        const StepRecord apart =
          run<1>("",
                 body("a", {"Length=0.5", "Temperature=2"}) +
                   body("b", {"Length=0.5", "Temperature=5"}) +
                   Overrides{"Model/Fields=temperature",
                             "Boundary/left/Temperature=2",
                             "Boundary/right/Temperature=5",
                             "Boundary/right/Heat exchange=0",
                             "Time/End time=0.1",
                             entry("Mesh/Degree", degree)})
            .rows.back();
        deallog << "apart, degree " << degree << ": energy "
                << within(std::abs(apart.energy), 1e-12) << ", work "
                << within(std::abs(apart.work), 1e-12) << ", dissipation "
                << within(std::abs(apart.dissipation), 1e-12) << std::endl;
      }
  }



  void
  check_masses_by_law()
  {
    double errors[2];
    for (const unsigned int i : {0, 1})
      {
        const StepRecord last =
          run<1>("",
                 body("a", {"Kind=mass", "Temperature=1"}) +
                   body("b", {"Kind=mass"}) + body("c", {"Kind=mass"}) +
                   Overrides{"Boundary/left/Temperature=none",
                             "Boundary/left/Support=free",
                             "Boundary/right/Heat exchange=if(gap>1,0,2)",
                             "Contact/Gap=100",
                             "Contacts/a b/Gap=0",
                             "Contacts/b c/Gap=0",
                             "Time/Scheme=box",
                             entry("Time/Step size", i == 0 ? 0.05 : 0.025),
                             "Time/End time=0.5"})
            .rows.back();
        errors[i] = std::abs(last.temperature_end - 1. / 3. +
                             0.5 * std::exp(-1.) - std::exp(-3.) / 6.);
      }
    deallog << "masses, k by a law: theta " << within(errors[0], 2e-5)
            << ", order at least 2 "
            << (errors[0] > 3.5 * errors[1] ? "yes" : "no") << std::endl;
    const StepRecord behind =
      run<1>("",
             body("a", {"Kind=mass", "Temperature=1"}) +
               body("b", {"Kind=mass"}) +
               Overrides{"Boundary/left/Temperature=none",
                         "Boundary/left/Support=free",
                         "Boundary/right/Heat exchange="
                         "if(gap>1,0,if(t<=0.1,0,1+10*(t-0.1)))",
                         "Contact/Gap=100",
                         "Contacts/a b/Gap=0",
                         "Time/Scheme=box",
                         "Time/Step size=0.05",
                         "Time/End time=0.3"})
        .rows.back();
    deallog << "masses, k that jumps and grows: theta "
            << within(std::abs(behind.temperature_end - 0.5 +
                               0.5 * std::exp(-0.8)),
                      1e-3)
            << std::endl;
  }



  void
  check_key_results()
  {
    const Overrides masses = free_ends + elastic +
                             Overrides{"Boundary/right/Support=contact",
                                       "Contact/Compliance=1",
                                       "Time/Scheme=sdirk4",
                                       "Time/Tolerance=1e-8",
                                       "Time/End time=1.1"};
    for (const auto &[name, overrides] :
         {std::make_pair(std::string("at the obstacle"),
                         body("a", {"Kind=mass"}) +
                           body("b", {"Kind=mass", "Velocity=1"}) +
                           Overrides{"Contacts/a b/Gap=10", "Contact/Gap=0.1"}),
          std::make_pair(std::string("at a mass"),
                         body("a", {"Kind=mass", "Velocity=1"}) +
                           body("b", {"Kind=mass", "Mass=3"}) +
                           Overrides{"Contacts/a b/Gap=0.1",
                                     "Contact/Gap=10"})})
      {
        Simulation<1> simulation(read_parameters("", masses + overrides),
                                 MPI_COMM_SELF);
        simulation.run();
        deallog << name << ": time in contact "
                << within(std::abs(key_results(simulation.scene(),
                                               simulation.history())
                                     .at("contact_duration") -
                                   1.),
                          1e-7)
                << std::endl;
      }
    for (const bool is_mirrored : {false, true})
      {
        const Overrides slow = {"Length=0.25",
                                is_mirrored ? "Velocity=-1" : "Velocity=1"},
                        fast = {"Length=0.75",
                                is_mirrored ? "Velocity=-2" : "Velocity=2"};
        double error         = 0.;
        for (const StepRecord &row :
             run<1>("",
                    free_ends + elastic + touching +
                      (is_mirrored ? body("fast", fast) + body("slow", slow) :
                                     body("slow", slow) + body("fast", fast)) +
                      Overrides{"Time/End time=0.5"})
               .rows)
          raise(error,
                std::abs(row.displacement_mid -
                         (is_mirrored ? -2. : 2.) * row.time));
        deallog << "middle of two rods" << (is_mirrored ? ", mirrored" : "")
                << ": " << within(error, 1e-11) << std::endl;
      }
  }



  /** Masses b and c that press on each other at the start, a is far. */
  void
  check_preload()
  {
    const RecordedRun result =
      run<1>("",
             free_ends + elastic + body("a", {"Kind=mass"}) +
               body("b", {"Kind=mass"}) + body("c", {"Kind=mass"}) +
               Overrides{"Contacts/a b/Gap=10",
                         "Contacts/b c/Gap=-0.1",
                         "Contact/Compliance=1",
                         "Time/Scheme=sdirk4",
                         "Time/Tolerance=1e-8",
                         "Time/End time=2"});
    unsigned int n_of_them = 0;
    for (const ContactEvent &event : result.events)
      n_of_them += event.contact == 1;
    deallog << "preload: events " << result.events.size() << ", of b and c "
            << n_of_them << ", apart at "
            << within(std::abs(result.events.back().time -
                               0.5 * dealii::numbers::PI * std::sqrt(0.5)),
                      1e-7)
            << std::endl;
  }



  /** A force x on a mass behind a gap. */
  void
  check_force_on_mass()
  {
    const RecordedRun result =
      run<1>("",
             free_ends + elastic + body("a", {"Length=1"}) +
               body("b", {"Kind=mass", "Mass=0.3"}) +
               Overrides{"Contacts/a b/Gap=0.5",
                         "Sources/Body force=x",
                         "Time/Scheme=sdirk4",
                         "Time/End time=1"});
    deallog << "force on a mass: velocity "
            << within(std::abs(result.rows.back().velocity_end - 1.5), 1e-12)
            << ", events " << result.events.size() << std::endl;
  }



  void
  check_rattling_rods()
  {
    const RecordedRun result =
      run<1>("",
             body("slow",
                  {"Heat capacity=10", "Temperature=1.5-x+1e-6*sin(pi*x/2)"}) +
               body("fast", {"Temperature=-0.5-x"}) +
               Overrides{"Model/Inertia=0",
                         "Model/Viscosity=0",
                         "Model/Coupling=1",
                         "Model/Thermoelastic heating=false",
                         "Boundary/left/Temperature=1.5",
                         "Boundary/right/Support=clamped",
                         "Boundary/right/Temperature=-1.5",
                         "Boundary/right/Heat exchange=1/(1-12*(pressure-1))",
                         "Contact/Condition=rigid",
                         "Contact/Gap=-2",
                         "Time/Step size=0.01",
                         "Time/End time=9"});
    const auto p = [&](const unsigned int time) {
      return result.rows.at(100 * time).contact_force - 1.;
    };
    // p(t + 2) = a p(t + 1) + b p(t)
    const double determinant = p(7) * p(7) - p(6) * p(8);
    const double a           = (p(8) * p(7) - p(6) * p(9)) / determinant;
    const double b           = (p(7) * p(9) - p(8) * p(8)) / determinant;
    const double factor      = std::sqrt(-b);
    deallog << "rattling rods: growth "
            << within(std::abs(std::log(factor) / 0.343062 - 1.), 1e-3)
            << ", frequency "
            << within(std::abs(std::acos(0.5 * a / factor) / 1.116640 - 1.),
                      1e-3)
            << std::endl;
  }



  Overrides
  three_masses(const std::string &scheme)
  {
    return elastic + free_ends + body("a", {"Kind=mass", "Velocity=1"}) +
           body("b", {"Kind=mass"}) + body("c", {"Kind=mass", "Mass=3"}) +
           Overrides{"Boundary/right/Support=contact",
                     "Contact/Gap=1",
                     "Contacts/a b/Gap=0",
                     "Time/Scheme=" + scheme,
                     "Time/Tolerance=1e-8",
                     "Time/End time=6"};
  }



  const Overrides own_laws = {"Contact/Compliance=0.09",
                              "Contacts/a b/Compliance=0.04",
                              "Contacts/b c/Compliance=0.01"};



  /** The largest penetration is the last. */
  void
  check_penetration()
  {
    Simulation<1> simulation(read_parameters("",
                                             three_masses("sdirk4") + own_laws),
                             MPI_COMM_SELF);
    simulation.run();
    const double last = 0.5 * std::sqrt(3. * 0.09);
    deallog << "own laws, penetration "
            << within(std::abs(simulation.history().max_penetration / last -
                               1.),
                      1e-3)
            << std::endl;
  }



  void
  check_own_laws(const std::string &scheme, const double bound)
  {
    const RecordedRun result = run<1>("", three_masses(scheme) + own_laws);
    const double      pi     = dealii::numbers::PI;
    const double      first  = pi * std::sqrt(0.5 * 0.04);
    const double      second = pi * std::sqrt(0.75 * 0.01);
    const double      third  = pi * std::sqrt(3. * 0.09);
    const double      meet   = 1. + 0.5 * first;
    // the way of the centre of b and c during their contact, and so of both
    const double x       = 0.25 * second;
    const double back    = meet + second + (1. + x - 0.5 * first) / 0.5;
    const double ahead   = meet + second + (1. - x) / 0.5;
    const double times[] = {
      0., first, meet, meet + second, back, ahead, back + first, ahead + third};
    double time = 0., impulse = 0., force = 0.;
    for (unsigned int i = 0; i < 8 && i < result.events.size(); ++i)
      raise(time, std::abs(result.events[i].time - times[i]));
    const double impulses[] = {1.5, 1.5, 3.},
                 forces[]   = {std::sqrt(0.5 / 0.04),
                               std::sqrt(0.75 / 0.01),
                               0.5 * std::sqrt(3. / 0.09)};
    for (unsigned int i = 0; i < 3; ++i)
      {
        double peak = 0.;
        for (const StepRecord &row : result.rows)
          raise(peak, row.contacts[i].contact_force);
        raise(force, std::abs(peak / forces[i] - 1.));
        raise(impulse,
              std::abs(result.rows.back().contacts[i].contact_impulse -
                       impulses[i]));
      }
    deallog << "own laws, " << scheme << ": events " << result.events.size()
            << ", times " << within(time, bound) << ", impulses "
            << within(impulse, scheme == "box" ? 1e-12 : bound) << ", forces "
            << within(force, 1e-3) << std::endl;
  }



  /** Three rods with laws of their own, and their mirror image. */
  void
  check_mirrored_laws(const std::string &scheme, const double bound)
  {
    const Overrides common = elastic + free_ends +
                             Overrides{"Contact/Condition=power law",
                                       "Contact/Gap=0.1",
                                       "Time/Scheme=" + scheme,
                                       "Time/End time=4"};
    const auto pair = [](const std::string &name, const bool is_soft) {
      Overrides result;
      for (const std::string &one :
           is_soft ? Overrides{"Compliance=0.5", "Exponent=2", "Dashpot=0.1"} :
                     Overrides{"Compliance=0.1", "Damping=0.5"})
        result.push_back("Contacts/" + name + "/" + one);
      return result;
    };
    const RecordedRun one =
      run<1>("",
             common + body("a", {"Velocity=1"}) + body("b", {"Section=2"}) +
               body("c", {"Length=1"}) + pair("a b", true) +
               pair("b c", false));
    const RecordedRun two =
      run<1>("",
             common + body("c", {"Length=1"}) + body("b", {"Section=2"}) +
               body("a", {"Velocity=-1"}) + pair("c b", false) +
               pair("b a", true));
    double difference = 0., impulse = 1.;
    for (unsigned int i = 0; i < std::min(one.rows.size(), two.rows.size());
         ++i)
      for (unsigned int c = 0; c < 2; ++c)
        raise(difference,
              std::abs(one.rows[i].contacts[c].contact_force -
                       two.rows[i].contacts[1 - c].contact_force));
    for (const ContactRecord &contact : one.rows.back().contacts)
      impulse = std::min(impulse, contact.contact_impulse);
    deallog << "mirrored laws, " << scheme << ": rows "
            << (one.rows.size() == two.rows.size() ? "as many" : "differ")
            << ", forces " << within(difference, bound) << ", all met "
            << (impulse > 0.1 ? "yes" : "no") << std::endl;
  }



  /** Laws of their own, all of them or their compliances, and the same law for
   * all. */
  void
  check_same_laws(const std::string &scheme)
  {
    const Overrides condition = {"Contact/Condition=power law"};
    const Overrides rest      = {"Contact/Exponent=1.4",
                                 "Contact/Damping=0.3",
                                 "Contact/Dashpot=0.2"};
    const Overrides all       = Overrides{"Contact/Compliance=0.02"} + rest;
    Overrides       own, in_part = rest;
    for (const std::string pair : {"a b", "b c"})
      {
        for (const std::string &one : all)
          own.push_back("Contacts/" + pair + one.substr(one.find('/')));
        in_part.push_back("Contacts/" + pair + "/Compliance=0.02");
      }
    const Overrides   apart = {"Boundary/right/Support=free"};
    const RecordedRun one =
      run<1>("", three_masses(scheme) + condition + apart + all);
    const RecordedRun two =
      run<1>("", three_masses(scheme) + condition + apart + own);
    const RecordedRun three =
      run<1>("", three_masses(scheme) + condition + apart + in_part);
    deallog << "the same laws, " << scheme << ": "
            << within(difference(table_of(one.rows), table_of(two.rows)), 1e-12)
            << ", in part "
            << within(difference(table_of(one.rows), table_of(three.rows)),
                      1e-12)
            << ", events " << one.events.size() << ' ' << two.events.size()
            << std::endl;
  }



  void
  check_audit()
  {
    const Overrides bodies =
      body("hammer", {"Kind=mass", "Mass=0.7", "Velocity=1", "Temperature=3"}) +
      body("a", {"Length=0.5", "Section=2", "Viscosity=0.5"}) +
      body("b", {"Length=0.4", "Density=2", "Stiffness=3", "Coupling=2"}) +
      body("c", {"Length=0.6", "Conductivity=3", "Temperature=2*x"});
    for (const std::string exchange :
         {"2", "if(pressure > 0, 1 + 10*pressure, 0.1/(0.1 + gap))"})
      {
        const RecordedRun result =
          run<1>("",
                 bodies + Overrides{"Model/Coupling=0.3",
                                    "Model/Viscosity=0.02",
                                    "Boundary/left/Support=free",
                                    "Boundary/left/Temperature=none",
                                    "Boundary/right/Heat exchange=" + exchange,
                                    "Contacts/a b/Condition=bonded",
                                    "Contact/Condition=normal compliance",
                                    "Contact/Compliance=0.01",
                                    "Contact/Gap=0.05",
                                    "Mesh/Cells=60",
                                    "Time/End time=4"});
        const StepRecord &first  = result.rows.front();
        double            defect = 0.;
        for (const StepRecord &row : result.rows)
          {
            raise(defect,
                  std::abs(row.energy + row.dissipation +
                           row.numerical_dissipation - row.work -
                           first.energy));
          }
        deallog << "audit, k = " << exchange << ": defect "
                << within(defect / first.energy, 1e-12) << ", contacts "
                << result.rows.back().contacts.size() << ", all met "
                << std::all_of(result.rows.back().contacts.begin(),
                               result.rows.back().contacts.end(),
                               [](const ContactRecord &c) {
                                 return c.contact_impulse > 0.;
                               })
                << std::endl;
      }
  }
} // namespace



void
main_rows()
{
  initlog();
  check_two("section",
            body("striker", {"Length=0.5", "Velocity=1"}) +
              body("bar", {"Length=1", "Section=2"}),
            2. / 3.,
            1.,
            1. / 3.);
  check_two("density",
            body("striker", {"Length=0.5", "Velocity=1"}) +
              body("bar", {"Length=0.5", "Density=4"}),
            2. / 3.,
            1.,
            1. / 3.);
  check_two("stiffness",
            body("striker", {"Length=0.5", "Velocity=1"}) +
              body("bar", {"Length=0.25", "Stiffness=0.25"}),
            1. / 3.,
            1.,
            1.);
  check_two("mirrored",
            body("bar", {"Length=1", "Section=2"}) +
              body("striker", {"Length=0.5", "Velocity=-1"}),
            2. / 3.,
            1.,
            1. / 3.);
  check_cradle();
  check_mass_on_rod(1.);
  check_mass_on_rod(2.);
  check_balls();
  check_layers();
  check_parts();
  check_resistances();
  check_masses_by_law();
  check_key_results();
  check_preload();
  check_force_on_mass();
  check_rattling_rods();
  check_own_laws("box", 2e-5);
  check_own_laws("sdirk4", 1e-7);
  check_penetration();
  check_same_laws("box");
  check_same_laws("sdirk4");
  check_mirrored_laws("box", 1e-10);
  check_mirrored_laws("sdirk4", 1e-8);
  check_audit();
}
