// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A rod between two stops, Contact/Rear gap, doc/model.md section 4.
//
// One cell, lumped: a mass b/2 on a spring of stiffness 1, thrown with
// velocity 1, between stops at 0.1 and -0.2, m = 3/2: 1 = v^2 + 2 u^2 at the
// stops, so that it meets and leaves the front one with sqrt(0.98) and the
// rear one with sqrt(0.92), in turn; tolerance 1e-12: to 1e-8.
// Rigid stops at 0.1 and -0.05: the mass meets the front one with
// sqrt(0.98) and stops; it swings back from 0.1 and meets the rear one with
// -sqrt(2 (0.1^2 - 0.05^2)), stops and swings between -0.05 and 0.05, which
// keeps the energy 0.05^2/2. Contact ends with the velocity 0. Impulses are
// b/2 times those velocities; what is lost is numerical dissipation: to
// 1e-7. Thrown with velocity 1 from the place 0.1 against one rigid stop
// there, or from one of two, the mass stops and is drawn away at once:
// contact begins and ends at t = 0, velocities 1 and 0, and then u = 0.1
// cos(sqrt(2) t); impulse b/2, energy 0.1^2/2 of 1/4 + 0.1^2/2: to 1e-7.
// The mirror image of each run is the run, but for rounding: also of rods that
// go from one stop to the other within a step.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <string>
#include <vector>

#include "../mirror_image.h"

using namespace ThermoContact;

namespace
{
  using Run = RecordedRun;

  MirrorImages images;



  Run
  run(const Overrides &overrides)
  {
    Run           result;
    Simulation<1> simulation(read_parameters("", overrides), MPI_COMM_SELF);
    images.run(simulation, {[&](const Simulation<1> &s) {
                 result.rows.push_back(s.record());
               }});
    result.events = simulation.events();
    return result;
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
    deallog << "spring and mass: at least 8 events " << (n >= 8)
            << ", velocities " << within(error, 1e-8) << std::endl;
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
    deallog << "rigid stops: impacts, impulse, energy " << within(error, 1e-7)
            << std::endl;
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
        deallog << "start at a rigid stop: impact, impulse, energy "
                << within(error, 1e-7) << std::endl;
      }
  }

} // namespace



void
main_two_stops()
{
  initlog();
  check_spring_and_mass();
  check_rigid_stops();
  check_start_at_rigid_stop({});
  check_start_at_rigid_stop({"Contact/Rear gap=0.1"});
  for (const std::string law : {"rigid", "normal compliance"})
    run({"Model/Fields=displacement",
         "Model/Viscosity=0",
         "Contact/Condition=" + law,
         "Contact/Gap=0.001",
         "Contact/Rear gap=0.0015",
         "Initial values/Velocity=x",
         "Time/Scheme=box",
         "Mesh/Cells=40",
         "Time/End time=5"});
  deallog << images.words(1e-12) << std::endl;
}
