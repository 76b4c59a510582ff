// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A rod between two stops, Contact/Rear gap, doc/model.md section 4.
//
// 1. The mirrored scene, u -> -u with a -> -a, the gaps exchanged and loads of
//    the other sign, gives the mirrored result to the last bit: displacements,
//    velocity, stress, force and impulse negated, all else and the times of the
//    events the same, their sides exchanged. Backward Euler with and sdirk4
//    without fixed steps; linear, power law, with damping, rigid.
// 2. A rear stop that is out of reach changes no bit.
// 3. One cell, lumped: a mass b/2 on a spring of stiffness 1, thrown with
//    velocity 1, between stops at 0.1 and -0.2, m = 3/2: 1 = v^2 + 2 u^2 at the
//    stops, so that it meets and leaves the front one with sqrt(0.98) and the
//    rear one with sqrt(0.92), in turn; tolerance 1e-12: to 1e-8.
//    Rigid stops at 0.1 and -0.05: the mass meets the front one with
//    sqrt(0.98) and stops; it swings back from 0.1 and meets the rear one with
//    -sqrt(2 (0.1^2 - 0.05^2)), stops and swings between -0.05 and 0.05, which
//    keeps the energy 0.05^2/2. Contact ends with the velocity 0. Impulses are
//    b/2 times those velocities; what is lost is numerical dissipation: to
//    1e-7. Thrown with velocity 1 from the place 0.1 against one rigid stop
//    there, or from one of two, the mass stops and is drawn away at once:
//    contact begins and ends at t = 0, velocities 1 and 0, and then u = 0.1
//    cos(sqrt(2) t); impulse b/2, energy 0.1^2/2 of 1/4 + 0.1^2/2: to 1e-7.
// 4. Symmetric drive, traction 2 sin(3 t) and stops at 0.2 and -0.2, one cell,
//    zeta = 1, steps of P/200: u(t + P/2) = -u(t) in the last of 20 periods,
//    to 1e-10 (5e-15 measured), with contact at both stops. With zeta = 1/2
//    that motion is not stable, and the rod ends in one of a mirrored pair.
// 5. The audit of backward Euler of a rod that is thrown against both stops,
//    damped power law, and rigid: to 1e-11 of the largest term; energy never
//    increases.
// 6. At rest at the rear stop: a = 0.05, theta_A = -10, k = 1, so that G =
//    -0.375 by (M3.1), g_2 = 0.2, eps = 1/2: p = -(0.375 - 0.2)/1.5 = -7/60, to
//    1e-6, as the forecast says.
// 7. Midpoint rule, midpoint mass, a preload of 0.1 on eps = 0.1 at rest: steps
//    of 1/2 take the end from stop to stop. The energy stays 0.1^2/0.2 = 0.05,
//    to 1e-12.

#include <thermocontact/forecast/steady_state.h>
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
  using Run = RecordedRun;

  Run
  run(const Overrides &overrides)
  {
    return ThermoContact::run<1>("", overrides);
  }



  unsigned int
  n_sides(const Run &result)
  {
    unsigned int sides = 0;
    for (const ContactEvent &event : result.events)
      sides |= event.side > 0 ? 1 : 2;
    return sides == 3 ? 2 : sides > 0 ? 1 : 0;
  }



  bool
  are_mirrored(const Run &one, const Run &other)
  {
    bool is_same = one.rows.size() == other.rows.size() &&
                   one.events.size() == other.events.size();
    for (unsigned int i = 0; is_same && i < one.rows.size(); ++i)
      {
        const StepRecord &a = one.rows[i], &b = other.rows[i];
        is_same =
          a.time == b.time && a.displacement_end == -b.displacement_end &&
          a.displacement_mid == -b.displacement_mid &&
          a.velocity_end == -b.velocity_end && a.stress_end == -b.stress_end &&
          a.contact_force == -b.contact_force &&
          a.contact_impulse == -b.contact_impulse && a.gap == b.gap &&
          a.penetration == b.penetration && a.energy == b.energy &&
          a.work == b.work && a.dissipation == b.dissipation &&
          a.contact_dissipation == b.contact_dissipation &&
          a.temperature_end == b.temperature_end &&
          a.in_contact == b.in_contact;
      }
    for (unsigned int i = 0; is_same && i < one.events.size(); ++i)
      is_same = one.events[i].time == other.events[i].time &&
                one.events[i].kind == other.events[i].kind &&
                one.events[i].side == -other.events[i].side &&
                one.events[i].velocity == -other.events[i].velocity;
    return is_same;
  }



  void
  check_mirror()
  {
    const Overrides scene{"Mesh/Cells=4", "Mesh/Degree=2", "Time/End time=3"};
    const Overrides elastic{"Contact/Compliance=0.05"};
    const Overrides rigid{"Contact/Condition=rigid"};
    const Overrides thrown{"Contact/Gap=0.05",
                           "Contact/Rear gap=0.12",
                           "Model/Coupling=0.017",
                           "Initial values/Velocity=20*x*(x-1)^2",
                           "Sources/End traction=0.2*sin(5*t)"};
    const Overrides mirrored{"Contact/Gap=0.12",
                             "Contact/Rear gap=0.05",
                             "Model/Coupling=-0.017",
                             "Initial values/Velocity=-20*x*(x-1)^2",
                             "Sources/End traction=-0.2*sin(5*t)"};
    const Overrides euler{"Time/Scheme=backward euler", "Time/Step size=0.01"};
    const Overrides power{"Contact/Condition=power law"};
    const Overrides damped{"Contact/Damping=0.3"};
    unsigned int    k = 0;
    for (const Overrides &choice : {elastic,
                                    elastic + euler,
                                    elastic + power,
                                    elastic + power + damped,
                                    elastic + euler + damped,
                                    rigid,
                                    rigid + euler})
      {
        const Run one   = run(scene + choice + thrown);
        const Run other = run(scene + choice + mirrored);
        deallog << "mirrored " << ++k << ": sides " << n_sides(one)
                << ", the same to the last bit " << are_mirrored(one, other)
                << std::endl;
      }
    const Overrides one_stop = scene + elastic + Overrides{"Contact/Gap=0.05"};
    const Run       near     = run(one_stop);
    const Run       far      = run(one_stop + Overrides{"Contact/Rear gap=9"});
    bool            is_same  = near.rows.size() == far.rows.size();
    for (unsigned int i = 0; is_same && i < far.rows.size(); ++i)
      is_same = near.rows[i].displacement_end == far.rows[i].displacement_end &&
                near.rows[i].contact_force == far.rows[i].contact_force &&
                near.rows[i].energy == far.rows[i].energy;
    deallog << "out of reach: the same to the last bit " << is_same
            << ", contact " << (n_sides(near) > 0) << std::endl;
  }



  const Overrides one_cell{"Model/Fields=displacement",
                           "Mesh/Cells=1",
                           "Mesh/Degree=1"};



  void
  check_spring_and_mass()
  {
    const Run result = run(one_cell + Overrides{"Contact/Condition=power law",
                                                "Contact/Compliance=0.1",
                                                "Contact/Gap=0.1",
                                                "Contact/Rear gap=0.2",
                                                "Model/Viscosity=0",
                                                "Mesh/Mass matrix=lumped",
                                                "Initial values/Velocity=x",
                                                "Time/Tolerance=1e-12",
                                                "Time/End time=4"});
    double    error  = 0.;
    unsigned int n   = 0;
    for (const ContactEvent &event : result.events)
      {
        const int    side  = (n / 2) % 2 == 0 ? 1 : -1;
        const double speed = std::sqrt(side > 0 ? 0.98 : 0.92);
        const double sign  = event.kind == ContactEvent::begin ? side : -side;
        raise(error, event.side == side ? 0. : 1.);
        raise(error,
              (event.kind == ContactEvent::begin) == (n % 2 == 0) ? 0. : 1.);
        raise(error, std::abs(event.velocity - sign * speed));
        ++n;
      }
    deallog << "spring and mass: events " << (n >= 8) << ", velocities to 1e-8 "
            << (error < 1e-8) << std::endl;
    if (!(error < 1e-8))
      deallog << error << std::endl;
  }



  void
  check_rigid_stops()
  {
    const Run    result = run(one_cell + Overrides{"Contact/Condition=rigid",
                                                "Contact/Gap=0.1",
                                                "Contact/Rear gap=0.05",
                                                "Model/Viscosity=0",
                                                "Mesh/Mass matrix=lumped",
                                                "Initial values/Velocity=x",
                                                "Time/Tolerance=1e-12",
                                                "Time/End time=8"});
    const double first  = std::sqrt(0.98);
    const double second = -std::sqrt(0.015);
    double       error  = result.events.size() == 4 ? 0. : 1.;
    for (unsigned int i = 0; error < 1. && i < 4; ++i)
      {
        const ContactEvent &event = result.events[i];
        raise(error, event.side == (i < 2 ? 1 : -1) ? 0. : 1.);
        raise(error,
              std::abs(event.velocity - (event.kind == ContactEvent::end ? 0. :
                                         i < 2 ? first :
                                                 second)));
      }
    const StepRecord &last = result.rows.back();
    raise(error, std::abs(last.contact_impulse - 0.5 * (first + second)));
    raise(error, std::abs(last.energy - 0.5 * 0.05 * 0.05));
    raise(error, std::abs(last.numerical_dissipation - (0.25 - last.energy)));
    deallog << "rigid stops: impacts, impulse, energy to 1e-7 "
            << (error < 1e-7) << std::endl;
    if (!(error < 1e-7))
      deallog << error << std::endl;
  }



  void
  check_start_at_rigid_stop(const Overrides &other_stop)
  {
    for (const double sign : other_stop.empty() ? std::vector<double>{1.} :
                                                  std::vector<double>{1., -1.})
      {
        const std::string velocity = sign > 0. ? "x" : "-x";
        const std::string start    = sign > 0. ? "0.1*x" : "-0.1*x";
        const Run         result   = run(one_cell + other_stop +
                               Overrides{"Contact/Condition=rigid",
                                         "Contact/Gap=0.1",
                                         "Model/Viscosity=0",
                                         "Mesh/Mass matrix=lumped",
                                         "Initial values/Displacement=" + start,
                                         "Initial values/Velocity=" + velocity,
                                         "Time/Tolerance=1e-9",
                                         "Time/End time=2"});
        double            error    = result.events.size() == 2 ? 0. : 1.;
        for (unsigned int i = 0; error < 1. && i < 2; ++i)
          {
            const ContactEvent &event = result.events[i];
            raise(error, event.side == sign ? 0. : 1.);
            raise(error, event.time);
            raise(error, std::abs(event.velocity - (i == 0 ? sign : 0.)));
          }
        const StepRecord &last = result.rows.back();
        raise(error,
              std::abs(last.displacement_end -
                       0.1 * sign * std::cos(2. * std::sqrt(2.))));
        raise(error, std::abs(last.contact_impulse - 0.5 * sign));
        raise(error, std::abs(last.energy - 0.005));
        raise(error, std::abs(last.numerical_dissipation - 0.25));
        deallog << "start at a rigid stop: impact, impulse, energy to 1e-7 "
                << (error < 1e-7) << std::endl;
        if (!(error < 1e-7))
          deallog << error << std::endl;
      }
  }



  void
  check_symmetry()
  {
    const Run result =
      run(one_cell + Overrides{"Contact/Compliance=0.05",
                               "Contact/Gap=0.2",
                               "Contact/Rear gap=0.2",
                               "Model/Viscosity=1",
                               "Sources/End traction=2*sin(3*t)",
                               "Time/Step size=0.010471975511965976",
                               "Time/Locate contact events=false",
                               "Time/End time=41.887902047863905"});
    const auto n     = result.rows.size();
    double     error = 0., largest = 0., smallest = 0.;
    for (unsigned int i = n - 200; i < n; ++i)
      {
        raise(error,
              std::abs(result.rows[i].displacement_end +
                       result.rows[i - 100].displacement_end));
        largest  = std::max(largest, result.rows[i].contact_force);
        smallest = std::min(smallest, result.rows[i].contact_force);
      }
    deallog << "symmetric drive: contact at both stops "
            << (largest > 0.1 && smallest < -0.1)
            << ", half a period later the mirrored motion to 1e-10 "
            << (error < 1e-10) << std::endl;
  }



  void
  check_audit(const Overrides &stops)
  {
    const Run result =
      run(stops + Overrides{"Mesh/Cells=3",
                            "Mesh/Degree=2",
                            "Contact/Gap=0.05",
                            "Contact/Rear gap=0.05",
                            "Initial values/Temperature=theta_A*(1-x/2)",
                            "Initial values/Velocity=3*x",
                            "Model/Viscosity=0.02",
                            "Time/Scheme=backward euler",
                            "Time/Start=consistent",
                            "Time/Step size=0.005",
                            "Time/End time=3"});
    double defect = 0., largest = 0., increase = 0.;
    for (const StepRecord &r : result.rows)
      raise(largest, std::abs(r.energy));
    for (unsigned int i = 1; i < result.rows.size(); ++i)
      {
        const StepRecord &r = result.rows[i];
        raise(defect,
              std::abs(result.rows[0].energy + r.work - r.energy -
                       r.dissipation - r.contact_dissipation -
                       r.numerical_dissipation));
        raise(increase, r.energy - result.rows[i - 1].energy);
      }
    deallog << "audit: sides " << n_sides(result) << ", taken by the stops "
            << (result.rows.back().contact_dissipation > 1e-4)
            << ", closes to 1e-11 " << (defect < 1e-11 * largest)
            << ", energy never increases " << (increase < 1e-12 * largest)
            << std::endl;
  }



  void
  check_rest()
  {
    const Overrides scene{"Model/Coupling=0.05",
                          "Model/Viscosity=1",
                          "Boundary/Fixed end temperature=-10",
                          "Contact/Compliance=0.5",
                          "Contact/Rear gap=0.2",
                          "Mesh/Cells=4",
                          "Mesh/Degree=2",
                          "Time/End time=60"};
    const double    exact  = -7. / 60.;
    const Run       result = run(scene);
    const Scene     resolved(read_parameters("", scene));
    const auto      states = steady_state(resolved).states;
    deallog << "at rest at the rear stop: force to 1e-6 "
            << (std::abs(result.rows.back().contact_force / exact - 1.) < 1e-6)
            << ", forecast "
            << (states.size() == 1 &&
                std::abs(states[0].contact_force / exact - 1.) < 1e-12)
            << ", side " << result.events.back().side << std::endl;
  }



  /** From rest at a preload, a step that crosses the play. */
  void
  check_crossing()
  {
    const Run    result  = run({"Model/Fields=displacement",
                                "Model/Viscosity=0",
                                "Initial values/Displacement=0",
                                "Initial values/Velocity=0",
                                "Contact/Compliance=0.1",
                                "Contact/Gap=-0.1",
                                "Contact/Rear gap=0.1001",
                                "Mesh/Cells=20",
                                "Mesh/Degree=1",
                                "Mesh/Mass matrix=midpoint",
                                "Time/Scheme=energy conserving",
                                "Time/Step size=0.5",
                                "Time/End time=5"});
    double       defect  = 0.;
    unsigned int n_sides = 0;
    for (const StepRecord &r : result.rows)
      {
        raise(defect, std::abs(r.energy - 0.05));
        n_sides |= r.contact_force > 0. ? 1 : r.contact_force < 0. ? 2 : 0;
      }
    deallog << "crossing the play: both stops " << (n_sides == 3)
            << ", energy to 1e-12 " << (defect < 1e-12 * 0.05) << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  check_mirror();
  check_spring_and_mass();
  check_rigid_stops();
  check_start_at_rigid_stop({});
  check_start_at_rigid_stop({"Contact/Rear gap=0.1"});
  check_symmetry();
  check_audit({"Contact/Condition=power law",
               "Contact/Damping=0.3",
               "Contact/Compliance=0.05"});
  check_audit({"Contact/Condition=rigid"});
  check_rest();
  check_crossing();
}
