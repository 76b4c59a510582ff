// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact nodes without mass and viscosity at the start, doc/contact-in-time.md
// (C4.3), with factors and with the iterative solver.
//
// A strip, 8 x 8 cells of degree 2, free sides, pressed into an obstacle with a
// shape, g = 2 (y - 0.1)^2 - 0.01, so that some of its 17 nodes are in contact
// and some not, thrown with v = x (1 + 3 y). The nodes at the end get the
// velocities that keep them in equilibrium with those of all others: at each
// node (S v)_n + w p' = 0, with p' = v_n/epsilon in contact and zero else, to
// 1e-9 of the largest entry of S v.
//
// A viscous block without inertia begins 0.01 deep in a steep damped obstacle,
// whose law alone would push with up to (0.01/1e-5)^2.5 = 3e7. The nodes yield
// until what is left of it is in equilibrium with the body: the iterative
// solver, whose residuals are compared to the forces that are left, has the
// force of the direct one to 1e-7 (measured: 4e-12; 5e-6 if they are compared
// to those of the law alone).
//
// The node at the end of a rod at rest, four cells of degree 1, of stiffness 4,
// follows a traction that rises for a moment, 0.001 min(t, 1e-6), with v =
// 0.001/4 from the start, whatever the load does later, to 1e-12.
//
// A static elastic rod touches a rigid stop, and its other end jumps to
// theta_A = 10 at t = 0: no heat has flowed, and the pressure of the first row
// is 0, whatever the degree. At t = 0.01 the heat 2 theta_A sqrt(t/pi) is in
// the rod, and the pressure is a times that, but for the part a^2 = 3e-4 of it
// that the motion takes.

#include <thermocontact/simulation/initial_state.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  using ThermoContact::Vector;

  void
  check(const std::string &solver, const double compliance)
  {
    const std::vector<std::string> overrides{
      "Dimension=2",
      "Model/Viscosity=0",
      "Contact/Compliance=" + std::to_string(compliance),
      "Contact/Gap=2*(y-0.1)^2-0.01",
      "Initial values/Velocity=x*(1+3*y)",
      "Boundary/sides/Support=free",
      "Mesh/Cells=8",
      "Mesh/Cells across=8",
      "Mesh/Degree=2",
      "Mesh/Width=0.25",
      "Time/Scheme=sdirk2",
      "Time/Step size=0.01",
      "Solver/Linear solver=" + solver};
    const Scene              scene(read_parameters("", overrides));
    Body<2>                  body(scene, MPI_COMM_SELF);
    std::vector<std::string> warnings;
    Reset<2>                 unused(body);
    const State          state = initial_state(body, unused, 0.01, warnings);
    const ContactEnd<2> &end   = body.contact_end();
    Vector               force(state.velocity);
    body.equations.stiffness.vmult(force, state.velocity);
    std::vector<double> forces, velocities;
    end.get_values(Field::displacement, force, forces);
    end.get_values(Field::displacement, state.velocity, velocities);
    double       largest   = 0.;
    unsigned int n_contact = 0;
    for (unsigned int i = 0; i < end.n_nodes(); ++i)
      {
        const bool   is_closed = state.contact.pressure[i] > 0.;
        const double spring =
          is_closed ? end.nodes()[i].weight / compliance : 0.;
        n_contact += is_closed;
        raise(largest,
              std::abs(forces[i] + spring * velocities[i]) /
                force.linfty_norm());
      }
    deallog << solver << ", epsilon = " << compliance << ": some in contact "
            << (n_contact > 3 && n_contact < 14) << ", in equilibrium "
            << within(largest, 1e-9) << std::endl;
  }



  double
  force_at_the_start(const std::vector<std::string> &solver)
  {
    std::vector<std::string> overrides{
      "Dimension=3",
      "Model/Poisson ratio=0",
      "Model/Inertia=0",
      "Model/Viscosity=0.02",
      "Initial values/Displacement=0.02*x",
      "Initial values/Temperature=theta_A*(1-x)",
      "Contact/Condition=power law",
      "Contact/Gap=0.01+0.1*(y-0.1)^2",
      "Contact/Compliance=1e-5",
      "Contact/Exponent=2.5",
      "Contact/Damping=2",
      "Boundary/sides/Support=free",
      "Mesh/Cells=2",
      "Mesh/Cells across=2",
      "Mesh/Degree=2",
      "Mesh/Width=0.3",
      "Time/Scheme=backward euler",
      "Time/Start=consistent",
      "Time/Step size=0.03"};
    overrides.insert(overrides.end(), solver.begin(), solver.end());
    const Scene              scene(read_parameters("", overrides));
    Body<3>                  body(scene, MPI_COMM_SELF);
    std::vector<std::string> warnings;
    Reset<3>                 reset(body);
    const State              state = initial_state(body, reset, 0.03, warnings);
    double                   force = 0.;
    for (unsigned int i = 0; i < state.contact.pressure.size(); ++i)
      force += state.contact.pressure[i] * body.contact_end().nodes()[i].weight;
    return force;
  }



  double
  velocity_under_short_rise()
  {
    const Simulation<1> simulation(
      read_parameters("",
                      {"Model/Fields=displacement",
                       "Model/Viscosity=0",
                       "Initial values/Displacement=0",
                       "Initial values/Velocity=0",
                       "Boundary/right/Traction=0.001*min(t,1e-6)",
                       "Contact/Massless nodes=on",
                       "Mesh/Cells=4",
                       "Mesh/Degree=1"}),
      MPI_COMM_SELF);
    return simulation.record().velocity_end;
  }



  /** Pressure at t = 0, and at 0.01 its relative error. */
  std::array<double, 2>
  pressure_of_heated_end(const unsigned int degree)
  {
    std::vector<double> forces;
    Simulation<1>       simulation(read_parameters("",
                                             {"Model/Inertia=0",
                                                    "Model/Viscosity=0",
                                                    "Contact/Condition=rigid",
                                                    "Contact/Gap=0",
                                                    "Initial values/Temperature=0",
                                                    "Initial values/Displacement=0",
                                                    "Mesh/Degree=" +
                                                      std::to_string(degree),
                                                    "Time/End time=0.01"}),
                             MPI_COMM_SELF);
    simulation.run({[&](const Simulation<1> &s) {
      forces.push_back(s.record().contact_force);
    }});
    const double exact = simulation.body().scene.material.thermal_stress * 20. *
                         std::sqrt(0.01 / numbers::PI);
    return {{forces.front(), std::abs(forces.back() / exact - 1.)}};
  }
} // namespace



void
main_initial_equilibrium()
{
  initlog();
  for (const double compliance : {1e-2, 1.})
    for (const std::string solver : {"direct", "iterative"})
      check(solver, compliance);
  const double direct = force_at_the_start({"Solver/Linear solver=direct"});
  deallog << "a steep damped obstacle: "
          << within(std::abs(
                      force_at_the_start({"Solver/Linear solver=iterative",
                                          "Solver/Linear tolerance=1e-11"}) /
                        direct -
                      1.),
                    1e-7)
          << std::endl;
  deallog << "velocity under a load that rises for a moment "
          << within(std::abs(velocity_under_short_rise() / 0.00025 - 1.), 1e-12)
          << std::endl;
  for (const unsigned int degree : {4, 8, 16})
    {
      const auto [at_first, error] = pressure_of_heated_end(degree);
      deallog << "heated end, degree " << degree << ": pressure at first "
              << within(std::abs(at_first), 1e-12) << ", later "
              << within(error, 2e-3) << std::endl;
    }
}
