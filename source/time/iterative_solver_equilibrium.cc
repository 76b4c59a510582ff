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
    SetsBetweenStops sets = stage.empty_sets();
    for (unsigned int i = 0; i < known.contact_pressure.size(); ++i)
      {
        sets.is_rear[i]   = known.contact_pressure[i] < 0.;
        sets.is_active[i] = known.contact_pressure[i] != 0.;
      }

    // What is left of the forces would move the body in the first stage,
    // however short that is: once more, relative to what is left.
    const StopWatch watch(counters_.solve_seconds);
    stage.prepare(
      known, tau, heat_load, momentum_load, known.contact_pressure, false);
    stage.set_active(sets);
    count(stage.solve(body.scene.linear_solver.tolerance,
                      IterativeStage<dim>::Measure::of_start));
    stage.get_pressures(rates.pressure);
    rates.velocity.copy_locally_owned_data_from(
      stage.unknowns(Field::displacement));
    move();
    remove_pull(sets,
                std::vector<bool>(known.contact_pressure.size(), false),
                known.contact_pressure);
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_quasi_static_velocity(
    const State             &known,
    const Vector            &heat_load,
    const Vector            &momentum_load,
    const std::vector<bool> &is_closed,
    const NearerStops       &stops,
    StageRates              &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    const double    tau      = 1.; // its matrix is (zeta + 1) S
    const Material &material = body.scene.material;
    stage.prepare(
      known, tau, heat_load, momentum_load, known.contact_pressure, false);
    // of the velocity; towards the other stop nodes are free
    constexpr double    infinity = std::numeric_limits<double>::infinity();
    std::vector<double> front(known.gap_rate), rear(stops.far.size(), 0.);
    for (double &value : front)
      value *= -material.viscosity / (material.viscosity + 1.);
    for (unsigned int i = 0; i < rear.size(); ++i)
      (stops.side(i) > 0. ? rear : front)[i] = -infinity;
    stage.set_penetrations(front, rear);
    SetsBetweenStops  sets = stage.empty_sets();
    std::vector<bool> is_away(is_closed);
    is_away.flip();
    rates.pressure.assign(is_closed.size(), 0.);
    solve_by_sets(sets, is_away, rates);
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
                                                  const NearerStops &,
                                                  StageRates &);
  template void
  IterativeSolver<3>::solve_quasi_static_velocity(const State &,
                                                  const Vector &,
                                                  const Vector &,
                                                  const std::vector<bool> &,
                                                  const NearerStops &,
                                                  StageRates &);
} // namespace ThermoContact
