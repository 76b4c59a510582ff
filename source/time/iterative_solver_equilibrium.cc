// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/stop_watch.h>
#include <thermocontact/time/iterative_solver.h>

#include <algorithm>

namespace ThermoContact
{
  template <int dim>
  void
  IterativeSolver<dim>::solve_equilibrium(const Vector &heat_load,
                                          const Vector &momentum_load,
                                          State        &known)
  {
    const double      tau = 1.; // its matrix is S
    StageRates        rates;
    std::vector<bool> is_active;
    const auto        move = [&]() {
      known.displacement += rates.velocity;
      known.contact_pressure = rates.pressure;
    };
    rates.velocity = momentum_load;
    known.velocity = 0.;
    solve_momentum(
      known, tau, heat_load, momentum_load, ContactMode::unilateral, rates);
    move();
    for (const double p : known.contact_pressure)
      is_active.push_back(p > 0.);

    // What is left of the forces would move the body in the first stage,
    // however short that is: once more, relative to what is left.
    const StopWatch watch(counters_.solve_seconds);
    stage.prepare(
      known, tau, heat_load, momentum_load, known.contact_pressure, false);
    stage.set_active(is_active);
    count(stage.solve(body.scene.linear_solver.tolerance,
                      IterativeStage<dim>::Measure::of_start));
    stage.get_pressures(rates.pressure);
    rates.velocity.copy_locally_owned_data_from(
      stage.unknowns(Field::displacement));
    move();
    for (double &p : known.contact_pressure)
      p = std::max(p, 0.);
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_quasi_static_velocity(
    const State             &known,
    const Vector            &heat_load,
    const Vector            &momentum_load,
    const std::vector<bool> &is_closed,
    StageRates              &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    const double    tau      = 1.; // its matrix is (zeta + 1) S
    const Material &material = body.scene.material;
    stage.prepare(
      known, tau, heat_load, momentum_load, known.contact_pressure, false);
    std::vector<double> penetrations(known.gap_rate);
    for (double &value : penetrations) // of the velocity
      value *= -material.viscosity / (material.viscosity + 1.);
    stage.set_penetrations(penetrations);
    std::vector<bool> is_active(is_closed.size(), false), is_away(is_closed);
    is_away.flip();
    rates.pressure.assign(is_closed.size(), 0.);
    solve_by_sets(is_active, is_away, rates);
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
                                                  const std::vector<bool> &,
                                                  StageRates &);
  template void
  IterativeSolver<3>::solve_quasi_static_velocity(const State &,
                                                  const Vector &,
                                                  const Vector &,
                                                  const std::vector<bool> &,
                                                  StageRates &);
} // namespace ThermoContact
