// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What jumps of the loads do to what is in equilibrium, and leave alone.
//
// 1. A viscous strip without inertia, b = 0, zeta = 1, nu = 0, on rollers,
//    pressed on a rigid obstacle, g = 0.013, by a traction of 0.8 up to t =
//    0.5, 0.5 up to 1, 0.8 then: at rest u = g x and the force is the traction
//    less g, in the rows of the jumps that of the new one: 0.8 - g, 0.5 - g.
//    Contact begins once. With both solvers; errors to 1e-7, the tolerance of
//    the iterative one being 1e-9 (measured: 4e-10). From rest at u = 0, zeta
//    u' + u = 0.8 up to contact, at t = -zeta log(1 - g/0.8).
// 2. The same obstacle under a strip with coupling whose obstacle changes its
//    temperature from 0 to 5 and back: heat alone jumps, nothing moves at once,
//    so that contact begins once and the force changes by less than 1e-3 of it
//    in the step after a jump that is shorter than 1e-3.
// 3. A strip with inertia whose contact nodes have no mass and no viscosity,
//    epsilon = 0.01, pushed on the obstacle, or drawn off it, by a traction
//    of 0.3 (1-y) at once: both solvers end the jump in the same state, work
//    and energy, in contact and in front of it, with and without heating (a =
//    0.8, whose adiabatic stiffness is 1.64 times that at constant
//    temperature), to 1e-6 of the largest value; the direct one by a short
//    stage, the iterative one by the nodes alone.
// 4. 0.1*(t>=1)+0.2*(t>1), and the two as loads of their own, b = zeta = 0: the
//    doubles before and after 1 are those of one jump, from u(1) = 0 to 0.3,
//    and no step is shorter than 1e-6.
// 5. b = zeta = 0, fixed steps, traction t/2, epsilon = g = 0.1, and a listed
//    time 0.3 at which nothing jumps: from t = 0.2 on u(1) = g + (t/2 - g)/11,
//    so that u_t(1) = 1/22 in all rows from 0.3 on, to 1e-9.
// 6. At the initial state, and at a jump, u_t(1) of a body with b = zeta = 0 is
//    no number; in all other rows it is.
// 7. A scene as in 1, fixed steps: one factorisation for the stages, one for
//    those of steps within which the node closes, and one for all that is
//    completed without a stage, the initial state and 5 jumps.
// 8. Three dimensions, all 25 nodes of an elastic obstacle at once, iterative
//    solver, events located: the sets of all stages settle, so that no more
//    steps are rejected than with the direct solver (18 instead of 2 if they do
//    not), and the largest force is the same to 1e-6.
// 9. The fixed end of one linear cell without heat exchange is 1 hotter at
//    once: M (1, theta) = (., 0) with M = (2 1; 1 2)/6, so that behind the jump
//    theta(1) = -1/2 and E = W = (1/2) int (1 - 3x/2)^2 = 1/8. The row of the
//    jump has none of it, one 1e-8 later, in which theta(1) rises by 4.5e-8,
//    all.
// 10. A body with b = zeta = 0, or b = 0 and zeta = 0.5, at rest between its
//    fixed end and a rigid obstacle, theta = 0 and theta_A = 10 from t = 0 or
//    from t = 0.1 on: no heat has flowed in the row of that time, in which
//    pressure, velocity and mean temperature are 0, and the energy of the
//    first is that of theta = 0, (1/2) int (10 (1 - x/2))^2 = 175/6; a
//    hundredth later the force is a int theta = 20 a (t/pi)^(1/2), a = 0.017,
//    to 1 %.
// 11. The mirror image of each run is the run, but for rounding.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../matched_spaces.h"
#include "../mirror_image.h"

using namespace ThermoContact;

namespace
{
  MirrorImages images;



  template <int dim, typename Look>
  void
  run(const Overrides &overrides, const Look &look)
  {
    Simulation<dim> simulation(read_parameters("", overrides), MPI_COMM_SELF);
    images.run(simulation, {look});
  }



  Overrides
  strip(const std::string &solver)
  {
    return {"Dimension=2",
            "Mesh/Cells across=2",
            "Mesh/Width=0.3",
            "Solver/Linear solver=" + solver};
  }



  const Overrides creep{"Model/Fields=displacement",
                        "Model/Inertia=0",
                        "Model/Viscosity=1",
                        "Contact/Condition=rigid",
                        "Contact/Gap=0.013",
                        "Initial values/Displacement=0"};



  void
  check_rigid_contact()
  {
    for (const std::string solver : {"direct", "iterative"})
      {
        double       error = 0., begin = 0.;
        unsigned int n_events = 0;
        run<2>(
          strip(solver) + creep +
            Overrides{"Mesh/Cells=4",
                      "Boundary/right/Traction=if(t<=0.5,0.8,if(t<=1,0.5,0.8))",
                      "Time/End time=1.5"},
          [&](const Simulation<2> &s) {
            const StepRecord &r = s.record();
            n_events            = s.events().size();
            if (n_events == 0)
              return;
            begin = s.events()[0].time;
            if (r.time < begin + 1e-9)
              return;
            const double traction = r.time < 0.5 ? 0.8 :
                                    r.time < 1.  ? 0.5 :
                                                   0.8;
            raise(error, std::abs(r.contact_force - (traction - 0.013)));
            raise(error, std::abs(r.velocity_end));
            raise(error, std::abs(r.gap));
          });
        deallog << "rigid, " << solver << ": force and rest "
                << within(error, 1e-7) << ", begins once " << (n_events == 1)
                << ", in time "
                << within(std::abs(begin + std::log(1. - 0.013 / 0.8)) / begin,
                          1e-4)
                << std::endl;
      }
  }



  void
  check_heat_alone()
  {
    unsigned int n_events = 0, n_jumps = 0;
    double       force = 0., change = 0.;
    bool         has_jumped = false;
    run<2>(strip("direct") +
             Overrides{"Model/Inertia=0",
                       "Model/Viscosity=0.1",
                       "Model/Coupling=0.1",
                       "Contact/Condition=rigid",
                       "Contact/Gap=0.05",
                       "Boundary/right/Surroundings=5*(sin(3*pi*t)>0)",
                       "Mesh/Cells=8",
                       "Time/End time=1.2"},
           [&](const Simulation<2> &s) {
             const StepRecord &r = s.record();
             n_events            = s.events().size();
             if (has_jumped && force > 0. && r.step_size < 1e-3)
               {
                 raise(change, std::abs(r.contact_force - force) / force);
                 ++n_jumps;
               }
             has_jumped = s.loads().break_at(r.time) != nullptr;
             force      = r.contact_force;
           });
    deallog << "heat: begins once " << (n_events == 1) << ", force goes on "
            << within(change, 1e-3) << ", jumps seen " << (n_jumps > 0)
            << std::endl;
  }



  void
  check_massless_nodes()
  {
    const Overrides mechanical{"Model/Fields=displacement"};
    const Overrides heated{"Model/Coupling=0.8",
                           "Boundary/left/Temperature=0",
                           "Boundary/right/Heat exchange=0",
                           "Initial values/Temperature=0"};
    const Overrides scene{"Model/Viscosity=0",
                          "Contact/Compliance=0.01",
                          "Contact/Gap=0.01",
                          "Initial values/Displacement=0",
                          "Initial values/Velocity=0.1*x*(1+y)",
                          "Boundary/sides/Support=free",
                          "Mesh/Cells=8",
                          "Mesh/Degree=2",
                          "Time/Step size=0.01"};
    for (const bool has_heat : {false, true})
      for (const std::string time : {"0.05", "0.25"})
        {
          const Overrides overrides =
            scene + (has_heat ? heated : mechanical) +
            Overrides{"Time/Break points=" + time,
                      "Time/End time=" + time,
                      "Boundary/right/Traction=if(t<=" + time + ",0," +
                        (time == "0.05" ? "" : "-") + "0.3*(1-y))"};
          const auto simulate = [&](const std::string &solver) {
            auto simulation = std::make_unique<Simulation<2>>(
              read_parameters("", strip(solver) + overrides), MPI_COMM_SELF);
            simulation->run();
            return simulation;
          };
          const auto             a = simulate("direct");
          const auto             b = simulate("iterative");
          const MatchedSpaces<2> spaces(a->discretization(),
                                        b->discretization());
          double                 error   = spaces.is_complete ? 0. : 1.;
          const auto             compare = [&](const Field::Block          field,
                                   const ThermoContact::Vector State::*values) {
            const auto  &first   = a->state().*values;
            const double largest = first.linfty_norm();
            if (largest > 0.)
              raise(
                error,
                spaces.difference(field, first, b->state().*values, largest));
          };
          compare(Field::displacement, &State::displacement);
          compare(Field::displacement, &State::velocity);
          if (has_heat)
            compare(Field::temperature, &State::temperature);
          for (const auto value : {&StepRecord::contact_force,
                                   &StepRecord::energy,
                                   &StepRecord::work})
            raise(error,
                  std::abs(a->record().*value - b->record().*value) /
                    std::max(std::abs(a->record().*value), 1e-9));
          deallog << "massless nodes" << (has_heat ? ", heated" : "")
                  << ": contact " << (a->record().contact_force > 0.) << " "
                  << within(error, 1e-6) << std::endl;
          if (error >= 1e-6)
            deallog << error << std::endl;
        }
  }



  const Overrides equilibrium{"Model/Fields=displacement",
                              "Model/Inertia=0",
                              "Model/Viscosity=0"};



  void
  check_close_jumps()
  {
    for (const bool are_two : {false, true})
      {
        double smallest = 1., before = 0., after = 0.;
        run<1>(equilibrium +
                 Overrides{"Contact/Condition=none",
                           are_two ?
                             "Boundary/right/Traction=0.1*(t>=1)" :
                             "Boundary/right/Traction=0.1*(t>=1)+0.2*(t>1)",
                           are_two ? "Sources/Body force=0.2*(t>1)" :
                                     "Sources/Body force=0",
                           "Time/End time=2"},
               [&](const Simulation<1> &s) {
                 const StepRecord &r = s.record();
                 if (r.step > 0)
                   smallest = std::min(smallest, r.step_size);
                 raise(r.time < 1. - 1e-9 ? before : after,
                       std::abs(r.displacement_end - (r.time < 1. - 1e-9 ? 0. :
                                                      are_two            ? 0.2 :
                                                                           0.3)));
               });
        deallog << (are_two ? "two loads" : "one load") << ", one jump: u(1) "
                << within(std::max(before, after), 1e-9)
                << ", 1e-6 over the smallest step "
                << within(1e-6 / smallest, 0.9) << std::endl;
      }
  }



  void
  check_listed_time()
  {
    double error     = 0.;
    bool   ends_here = false;
    run<1>(equilibrium + Overrides{"Contact/Compliance=0.1",
                                   "Contact/Gap=0.1",
                                   "Boundary/right/Traction=0.5*t",
                                   "Time/Step size=0.1",
                                   "Time/Break points=0.3;0.73",
                                   "Time/End time=1"},
           [&](const Simulation<1> &s) {
             const StepRecord &r = s.record();
             if (r.time > 0.3 - 1e-9)
               raise(error, std::abs(r.velocity_end - 1. / 22.));
             ends_here = ends_here || r.time == 0.73;
           });
    deallog << "listed times without a jump: u_t(1) " << within(error, 1e-9)
            << ", a step ends there " << ends_here << std::endl;
  }



  void
  check_heated_end()
  {
    double       error  = 0.;
    unsigned int n_rows = 0;
    run<1>({"Model/Fields=temperature",
            "Mesh/Cells=1",
            "Mesh/Degree=1",
            "Initial values/Temperature=0",
            "Boundary/right/Heat exchange=0",
            "Boundary/left/Temperature=if(t<0.1,0,1)",
            "Time/Break points=0.10000001",
            "Time/End time=0.2"},
           [&](const Simulation<1> &s) {
             const StepRecord &r = s.record();
             n_rows += std::abs(r.time - 0.1) < 1e-7;
             if (std::abs(r.time - 0.10000001) < 1e-13)
               {
                 raise(error, std::abs(r.temperature_end + 0.5));
                 raise(error, std::abs(r.energy - 0.125));
                 raise(error, std::abs(r.work - 0.125));
               }
             else if (std::abs(r.time - 0.1) < 1e-13)
               raise(error,
                     std::abs(r.temperature_end) + std::abs(r.energy) +
                       std::abs(r.work));
           });
    deallog << "heated end: " << within(error, 1e-7) << ", rows " << n_rows
            << std::endl;
  }



  void
  check_heated_body()
  {
    for (const bool is_viscous : {false, true})
      for (const bool at_start : {true, false})
        {
          const double start = at_start ? 0. : 0.1;
          double       error = 0., later = 1.;
          run<1>({"Model/Inertia=0",
                  is_viscous ? "Model/Viscosity=0.5" : "Model/Viscosity=0",
                  "Model/Coupling=0.017",
                  "Contact/Condition=rigid",
                  "Contact/Gap=0",
                  "Initial values/Temperature=0",
                  is_viscous ? "Initial values/Displacement=0" :
                               "Model/Inertia=0",
                  at_start ? "Boundary/left/Temperature=10" :
                             "Boundary/left/Temperature=if(t<0.1,0,10)",
                  at_start ? "Time/End time=0.01" : "Time/End time=0.11"},
                 [&](const Simulation<1> &s) {
                   const StepRecord &r = s.record();
                   if (std::abs(r.time - start) < 1e-13)
                     {
                       raise(error,
                             std::abs(r.contact_force) +
                               std::abs(r.temperature_mean));
                       if (is_viscous)
                         raise(error, std::abs(r.velocity_end));
                       if (at_start)
                         raise(error, std::abs(r.energy - 175. / 6.));
                     }
                   later =
                     std::abs(r.contact_force /
                                (0.34 * std::sqrt(0.01 / dealii::numbers::PI)) -
                              1.);
                 });
          deallog << "heated body: " << noise_within(error, 1e-12)
                  << ", heat comes in to " << within(later, 0.01) << std::endl;
        }
  }



  void
  check_velocity()
  {
    bool         is_right = true;
    unsigned int n_none   = 0;
    run<1>(equilibrium + Overrides{"Contact/Condition=none",
                                   "Boundary/right/Traction=t+if(t<=0.5,0,0.2)",
                                   "Time/End time=1"},
           [&](const Simulation<1> &s) {
             const StepRecord &r       = s.record();
             const bool        is_none = std::isnan(r.velocity_end);
             n_none += is_none;
             is_right &= is_none == (r.time == 0. || r.time == 0.5);
           });
    deallog << "velocity: none at 0 and at the jump " << is_right << ' '
            << n_none << std::endl;
  }



  void
  check_factors()
  {
    Simulation<1> simulation(
      read_parameters(
        "",
        creep + Overrides{"Boundary/right/Traction=0.5+0.3*(sin(4*pi*t)<0)",
                          "Time/Step size=0.125",
                          "Time/Break points=0.25;0.5;0.75;1;1.25",
                          "Time/End time=1.5"}),
      MPI_COMM_SELF);
    simulation.run();
    deallog << "factorisations: " << simulation.counters().factorizations
            << std::endl;
  }



  /** Of a run, and how many steps of it were rejected. */
  std::pair<double, unsigned int>
  largest_force(const std::string &solver)
  {
    double       largest    = 0.;
    unsigned int n_rejected = 0;
    run<3>({"Dimension=3",
            "Model/Fields=displacement",
            "Model/Viscosity=0",
            "Boundary/sides/Support=free",
            "Contact/Compliance=0.01",
            "Contact/Gap=0.01",
            "Initial values/Displacement=0",
            "Initial values/Velocity=0.1*x",
            "Mesh/Width=0.25",
            "Mesh/Cells=8",
            "Mesh/Cells across=2",
            "Mesh/Degree=2",
            "Time/End time=0.2",
            "Time/Tolerance=1e-4",
            "Solver/Linear solver=" + solver},
           [&](const Simulation<3> &s) {
             raise(largest, s.record().contact_force);
             n_rejected = s.history().n_rejected_steps;
           });
    return {largest, n_rejected};
  }
} // namespace



void
main_load_jumps()
{
  initlog();
  check_rigid_contact();
  check_heat_alone();
  check_massless_nodes();
  check_close_jumps();
  check_listed_time();
  check_heated_end();
  check_heated_body();
  check_velocity();
  check_factors();
  const auto [direct, n_direct]       = largest_force("direct");
  const auto [iterative, n_iterative] = largest_force("iterative");
  deallog << "25 nodes at once: force "
          << within(std::abs(iterative / direct - 1.), 1e-6)
          << ", more steps rejected by the iterative solver "
          << static_cast<int>(n_iterative) - static_cast<int>(n_direct)
          << std::endl;
  deallog << images.words(1e-12) << std::endl;
}
