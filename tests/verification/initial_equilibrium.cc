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

#include <thermocontact/simulation/initial_state.h>

#include <deal.II/base/mpi.h>

#include <cmath>

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
      "Boundary/Lateral support=free",
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
        const bool   is_closed = state.contact_pressure[i] > 0.;
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
} // namespace



void
main_initial_equilibrium()
{
  initlog();
  for (const double compliance : {1e-2, 1.})
    for (const std::string solver : {"direct", "iterative"})
      check(solver, compliance);
}
