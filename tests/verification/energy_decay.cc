// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Remark 4.4 of the paper, for every step size: the energy of backward Euler
// never increases from the second step on (the first is prescribed). 50 steps
// each of the 108 scenes dt x eps x zeta x a below, data of experiment 1. The
// allowance 1e-12 of the sum of the absolute terms of the energy is rounding.
//
// Scenes with contact: none for dt = 1e-4, since the end needs t = 0.1 to cover
// the gap; all 18 with a > 0 for dt = 100, since they reach the steady state
// G = a theta_A (1 - c/2) > g. The other counts follow from the motion; an
// independent dense code, tests/reference/energy_decay_contacts.py, gives the
// same ones.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  struct SceneResult
  {
    unsigned int n_steps     = 0; ///< from the second on
    unsigned int n_increases = 0; ///< of the energy, beyond rounding
    bool         has_contact = false;
  };



  SceneResult
  run_scene(const double dt,
            const double epsilon,
            const double zeta,
            const double a)
  {
    Parameters parameters         = read_parameters("");
    parameters.mesh.cells         = 32;
    parameters.mesh.degree        = 1;
    parameters.time.scheme        = "backward euler";
    parameters.time.step_size     = dt;
    parameters.time.end_time      = 50. * dt;
    parameters.contact.compliance = epsilon;
    parameters.model.viscosity    = zeta;
    parameters.model.coupling     = a;

    SceneResult   result;
    double        last_energy = 0., last_magnitude = 0.;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    const auto    observe = [&](const Simulation<1> &s) {
      const StepRecord &r         = s.record();
      const double      magnitude = r.energy_terms.magnitude();
      result.has_contact |= r.in_contact;
      if (r.step >= 2)
        {
          ++result.n_steps;
          // negated, so that NaN counts as an increase
          if (!(r.energy - last_energy <=
                1e-12 * std::max(magnitude, last_magnitude)))
            ++result.n_increases;
        }
      last_energy    = r.energy;
      last_magnitude = magnitude;
    };
    simulation.run({observe});
    return result;
  }
} // namespace



void
main_energy_decay()
{
  initlog();

  unsigned int n_scenes = 0, n_contact_total = 0, n_steps = 0, n_increases = 0;
  for (const double dt : {1e-4, 1e-2, 1., 100.})
    {
      unsigned int n_contact = 0, n_contact_a = 0;
      for (const double epsilon : {1e-8, 0.01, 1e3})
        for (const double zeta : {0., 0.2, 100.})
          for (const double a : {0., 0.017, 3.})
            {
              const SceneResult result = run_scene(dt, epsilon, zeta, a);
              ++n_scenes;
              n_steps += result.n_steps;
              n_increases += result.n_increases;
              n_contact += result.has_contact && a == 0.;
              n_contact_a += result.has_contact && a > 0.;
            }
      deallog << "dt = " << dt << ": scenes with contact " << n_contact
              << " of 9 with a = 0, " << n_contact_a << " of 18 with a > 0"
              << std::endl;
      n_contact_total += n_contact + n_contact_a;
    }
  deallog << "scenes " << n_scenes << ", with contact " << n_contact_total
          << ", steps " << n_steps << ", increases of the energy "
          << n_increases << std::endl;
}
