// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/stop_watch.h>
#include <thermocontact/time/iterative_solver.h>

#include <algorithm>
#include <limits>

namespace ThermoContact
{
  template <int dim>
  void
  IterativeSolver<dim>::solve_equilibrium(const Vector &heat_load,
                                          const Vector &momentum_load,
                                          State        &known)
  {
    const double tau = 1.; // its matrix is S
    StageRates   rates;
    const auto   move = [&]() {
      known.displacement += rates.velocity;
      known.contact_pressure = rates.pressure;
    };
    rates.velocity = momentum_load;
    known.velocity = 0.;
    solve_momentum(
      known, tau, heat_load, momentum_load, ContactMode::unilateral, rates);
    move();
    const std::vector<int> branch = branches_of(known.contact_pressure);

    // What is left of the forces would move the body in the first stage,
    // however short that is: once more, relative to what is left.
    const StopWatch watch(counters_.solve_seconds);
    stage.prepare(
      known, tau, heat_load, momentum_load, known.contact_pressure, false);
    stage.set_branches(branch);
    count(stage.solve(body.scene.linear_solver.tolerance,
                      IterativeStage<dim>::Measure::of_start));
    stage.get_pressures(rates.pressure);
    rates.velocity.copy_locally_owned_data_from(
      stage.unknowns(Field::displacement));
    move();
    for (unsigned int i = 0; i < branch.size(); ++i)
      if (branch[i] * known.contact_pressure[i] <= 0.)
        known.contact_pressure[i] = 0.;
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_quasi_static_velocity(
    const State                &known,
    const Vector               &heat_load,
    const Vector               &momentum_load,
    const std::vector<NodeLaw> &laws,
    StageRates                 &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    const double    tau      = 1.; // its matrix is (zeta + 1) S
    const Material &material = body.scene.material;
    stage.prepare(
      known, tau, heat_load, momentum_load, known.contact_pressure, false);
    std::vector<double> velocity(laws.size(), 0.);
    for (unsigned int i = 0; i < known.gap_rate.size(); ++i)
      velocity[i] -=
        material.viscosity / (material.viscosity + 1.) * known.gap_rate[i];
    stage.set_laws(laws, velocity);
    std::vector<int> branch(laws.size(), 0);
    solve_contact(branch, rates);
    ++counters_.solves;
    rates.velocity.copy_locally_owned_data_from(
      stage.unknowns(Field::displacement));
  }



  template void
  IterativeSolver<2>::solve_equilibrium(const Vector &,
                                        const Vector &,
                                        State &);
  template void
  IterativeSolver<3>::solve_equilibrium(const Vector &,
                                        const Vector &,
                                        State &);
  template void
  IterativeSolver<2>::solve_quasi_static_velocity(const State &,
                                                  const Vector &,
                                                  const Vector &,
                                                  const std::vector<NodeLaw> &,
                                                  StageRates &);
  template void
  IterativeSolver<3>::solve_quasi_static_velocity(const State &,
                                                  const Vector &,
                                                  const Vector &,
                                                  const std::vector<NodeLaw> &,
                                                  StageRates &);
} // namespace ThermoContact
