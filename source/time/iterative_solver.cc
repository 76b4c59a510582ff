// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/stop_watch.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/time/iterative_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ThermoContact
{
  template <int dim>
  IterativeSolver<dim>::IterativeSolver(const Body<dim> &body)
    : body(body)
    , stage(body)
  {}



  template <int dim>
  types::global_dof_index
  IterativeSolver<dim>::n_factorized_unknowns() const
  {
    const MultigridLevels<dim, float> &levels = stage.preconditioners().levels();
    types::global_dof_index            largest = 0;
    for (const Field::Block field : all_fields)
      largest = std::max(largest, levels.field(0, field).right.size());
    return largest;
  }



  template <int dim>
  RetainedFactorizations
  IterativeSolver<dim>::retained() const
  {
    RetainedFactorizations retained;
    retained.counters = counters_;
    for (const auto &hierarchy : stage.preconditioners().all())
      {
        retained.taus.push_back(hierarchy.tau);
        retained.has_response.push_back(false);
        retained.active_sets.push_back(hierarchy.last_contact);
      }
    return retained;
  }



  template <int dim>
  void
  IterativeSolver<dim>::restore(const RetainedFactorizations &retained)
  {
    stage.preconditioners().clear();
    for (unsigned int i = retained.taus.size(); i-- > 0;)
      stage.restore(retained.taus[i], retained.active_sets[i]);
    counters_ = retained.counters;
  }



  template <int dim>
  void
  IterativeSolver<dim>::count(const unsigned int n_iterations)
  {
    counters_.linear_iterations += n_iterations;
    counters_.max_linear_iterations =
      std::max(counters_.max_linear_iterations, n_iterations);
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_linear(const double         tolerance,
                                     std::vector<double> &pressure)
  {
    count(stage.solve(tolerance));
    stage.get_pressures(pressure);
    for (const std::string &warning : stage.take_warnings())
      warnings.push_back(warning);
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_prepared(const State      &known,
                                       const ContactMode mode,
                                       StageRates       &rates)
  {
    rates.start(known);
    std::vector<NodeLaw> laws(stage.contact_laws());
    std::vector<int>     branch(laws.size(), 0);
    if (body.law().is_active() && mode != ContactMode::open)
      for (unsigned int i = 0; i < laws.size(); ++i)
        {
          laws[i].is_held = mode == ContactMode::closed;
          const double p  = known.contact_pressure[i];
          branch[i]       = !laws[i].is_held ? (p > 0.) - (p < 0.) :
                            !rates.held_at.empty() && rates.held_at[i] < 0 ? -1 :
                                                                             1;
        }
    stage.set_laws(laws);
    if (body.law().is_active() && mode == ContactMode::unilateral)
      {
        rates.n_iterations = solve_contact(branch, rates.pressure);
        return;
      }
    stage.set_branches(branch);
    solve_linear(body.scene.linear_solver.tolerance, rates.pressure);
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve(const std::vector<int> &branch,
                              const bool              is_last,
                              std::vector<double>    &position,
                              std::vector<double>    &pressure)
  {
    const double tolerance = body.scene.linear_solver.tolerance;
    stage.set_branches(branch);
    solve_linear(is_last ? tolerance :
                           std::max(tolerance, Tolerances::loose_residual),
                 pressure);
    stage.get_positions(position);
  }



  template <int dim>
  unsigned int
  IterativeSolver<dim>::solve_contact(std::vector<int>    &branch,
                                      std::vector<double> &pressure)
  {
    const unsigned int n_sets =
      solve_by_branches(*this,
                        stage.contact_laws(),
                        stage.receptances(),
                        Tolerances::rounding_of_solution,
                        branch,
                        pressure);
    counters_.active_set_iterations += n_sets;
    return n_sets;
  }



  template <int dim>
  double
  IterativeSolver<dim>::algebraic_power(
    const State               &known,
    const double               tau,
    const std::vector<double> &pressure) const
  {
    double sum = 0.;
    if (body.scene.fields.has_temperature)
      {
        Vector excess(known.temperature);
        excess += stage.unknowns(Field::temperature);
        excess -= body.energy.steady_profile();
        sum += stage.unsolved(Field::temperature) * excess;
      }
    if (body.scene.fields.has_displacement)
      {
        Vector unsolved(stage.unsolved(Field::displacement));
        body.contact_end().subtract_load(Field::displacement,
                                         pressure,
                                         tau,
                                         unsolved);
        sum += unsolved * stage.unknowns(Field::displacement);
      }
    return -sum / (tau * body.discretization.geometry().cross_section());
  }



  template <int dim>
  void
  IterativeSolver<dim>::keep_contact(const std::vector<bool> &is_closed,
                                     const std::vector<double> & /*pressure*/,
                                     State &difference)
  {
    std::vector<double> displacement;
    body.contact_end().get_values(Field::displacement,
                                  difference.displacement,
                                  displacement);
    double largest = 0.;
    for (unsigned int i = 0; i < displacement.size(); ++i)
      if (is_closed[i])
        largest = std::max(largest, std::abs(displacement[i]));
    if (largest <=
        (body.law().is_rigid() ? Tolerances::negligible_displacement : 0.) *
          difference.displacement.linfty_norm())
      return;

    const StopWatch    watch(counters_.solve_seconds);
    const unsigned int n_made = stage.preconditioners().n_made();
    stage.prepare_displacement(displacement);
    stage.set_branches(std::vector<int>(is_closed.begin(), is_closed.end()));
    counters_.factorizations += stage.preconditioners().n_made() - n_made;
    count(stage.solve(Tolerances::estimate_residual,
                      IterativeStage<dim>::Measure::of_start));
    const double  tau       = stage.length();
    const double  viscosity = body.scene.material.viscosity;
    const Vector &v         = stage.unknowns(Field::displacement);
    difference.displacement.add(-tau, v);
    difference.velocity.add(-viscosity / (viscosity + tau), v);
    if (body.scene.fields.has_temperature)
      difference.temperature.add(-1., stage.unknowns(Field::temperature));
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve(const State      &known,
                              const double      tau,
                              const Vector     &heat_load,
                              const Vector     &momentum_load,
                              const ContactMode mode,
                              StageRates       &rates)
  {
    const StopWatch    watch(counters_.solve_seconds);
    const unsigned int n_made   = stage.preconditioners().n_made();
    const bool         has_heat = body.scene.fields.has_temperature;
    {
      const StopWatch watch_of_hierarchy(counters_.factorization_seconds);
      stage.preconditioners().provide(tau);
    }
    stage.prepare(known,
                  tau,
                  heat_load,
                  momentum_load,
                  mode == ContactMode::open ?
                    std::vector<double>(known.contact_pressure.size(), 0.) :
                    known.contact_pressure,
                  has_heat);
    solve_prepared(known, mode, rates);
    counters_.factorizations += stage.preconditioners().n_made() - n_made;
    ++counters_.solves;
    if (has_heat)
      rates.temperature_rate.equ(1. / tau, stage.unknowns(Field::temperature));
    if (body.scene.fields.has_displacement)
      rates.velocity.copy_locally_owned_data_from(
        stage.unknowns(Field::displacement));
    rates.algebraic_power = algebraic_power(known, tau, rates.pressure);
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_forces(const Vector               &forces,
                                     const std::vector<NodeLaw> &laws,
                                     const std::vector<double>  &position,
                                     Vector                     &y,
                                     std::vector<double>        &pressure)
  {
    const StopWatch watch(counters_.solve_seconds);
    const State     at_rest = body.discretization.make_state();
    const Vector no_heat = body.discretization.make_vector(Field::temperature);
    const unsigned int  n_made = stage.preconditioners().n_made();
    const unsigned int  n      = at_rest.contact_pressure.size();
    std::vector<double> expected =
      laws.empty() ? std::vector<double>() : pressure;
    expected.resize(n, 0.);
    stage.prepare(at_rest, 1., no_heat, forces, expected, false);
    if (laws.empty())
      {
        stage.set_branches(std::vector<int>(n, 0));
        solve_linear(body.scene.linear_solver.tolerance, expected);
      }
    else
      {
        stage.set_laws(laws, position);
        std::vector<int> branch = branches_of(expected);
        for (unsigned int i = 0; i < n; ++i)
          if (laws[i].law == nullptr)
            branch[i] = 0;
        solve_contact(branch, pressure);
      }
    counters_.factorizations += stage.preconditioners().n_made() - n_made;
    ++counters_.solves;
    y.copy_locally_owned_data_from(stage.unknowns(Field::displacement));
  }



  template class IterativeSolver<2>;
  template class IterativeSolver<3>;
} // namespace ThermoContact
