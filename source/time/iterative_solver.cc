// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/stop_watch.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/iterative_solver.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  template <int dim>
  IterativeSolver<dim>::IterativeSolver(const Body<dim> &body)
    : ContactPort<dim>(body)
    , body(body)
    , stage(body, warnings)
  {}



  template <int dim>
  types::global_dof_index
  IterativeSolver<dim>::n_factorized_unknowns() const
  {
    const MultigridLevels<dim, float> &levels =
      stage.preconditioners().levels();
    types::global_dof_index largest = 0;
    for (const Field::Block field : all_fields)
      largest = std::max(largest, levels.field(0, field).right.size());
    return largest;
  }



  template <int dim>
  RetainedFactorizations
  IterativeSolver<dim>::retained() const
  {
    RetainedFactorizations retained;
    retained.counters          = counters_;
    retained.reported_rounding = stage.reported_rounding();
    for (const auto &hierarchy : stage.preconditioners().all())
      {
        retained.taus.push_back(hierarchy.tau);
        retained.has_response.push_back(false);
        retained.contact_springs.push_back(hierarchy.last_contact);
      }
    return retained;
  }



  template <int dim>
  void
  IterativeSolver<dim>::restore(const RetainedFactorizations &retained)
  {
    stage.preconditioners().clear();
    for (unsigned int i = retained.taus.size(); i-- > 0;)
      stage.restore(retained.taus[i], retained.contact_springs[i]);
    stage.set_reported_rounding(retained.reported_rounding);
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
  IterativeSolver<dim>::solve_system(const bool is_last)
  {
    const double tolerance =
      body.scene.linear_solver.tolerance *
      (body.scene.heat.exchange->is_in_matrices() ? 1. :
                                                    Tolerances::within_search);
    count(stage.solve(
      is_last ? tolerance : std::max(tolerance, Tolerances::loose_residual)));
  }



  template <int dim>
  unsigned int
  IterativeSolver<dim>::meet_laws(std::vector<double> &pressure)
  {
    this->scale = stage.length();
    return this->solve_contact(
      stage.forces(), laws, start, factor, stage.velocity(), pressure);
  }



  template <int dim>
  std::vector<double>
  IterativeSolver<dim>::law_at(const std::vector<double> &coefficient)
  {
    stage.set_exchange(coefficient);
    n_sets += meet_laws(end_pressures);
    const std::vector<ExchangeConditions> conditions = stage.conditions();
    std::vector<double>                   result;
    for (unsigned int i = 0; i < laws.size(); ++i)
      result.push_back(
        coefficient_of_node(*body.scene.heat.exchange,
                            laws[i],
                            laws[i].position(this->positions()[i]),
                            end_pressures[i],
                            conditions[i]));
    return result;
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
  IterativeSolver<dim>::subtract_response(
    const std::vector<AffineLaw> &laws,
    const std::vector<double>    &displacement,
    State                        &difference)
  {
    const StopWatch     watch(counters_.solve_seconds);
    const unsigned int  n_made = stage.preconditioners().n_made();
    std::vector<double> misfit(displacement);
    for (double &one : misfit)
      one *= -1.;
    stage.prepare_pressures();
    this->scale = stage.length();
    this->set_tangents(laws, misfit, stage.length());
    counters_.factorizations += stage.preconditioners().n_made() - n_made;
    count(stage.solve(Tolerances::estimate_residual,
                      IterativeStage<dim>::Measure::of_start));
    const Vector none;
    this->subtract(1.,
                   stage.length(),
                   body.scene.material.viscosity,
                   stage.unknowns(Field::displacement),
                   1.,
                   body.scene.fields.has_temperature ?
                     stage.unknowns(Field::temperature) :
                     none,
                   difference);
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
    rates.start(known);
    if (mode != ContactMode::open)
      rates.contact.pressure = known.contact.pressure;
    stage.prepare(known, tau, heat_load, momentum_load, rates.contact.pressure);
    factor = get_stage_laws(body, known, tau, mode, rates.held_at, laws, start);
    n_sets = 0;
    if (body.scene.heat.exchange->is_in_matrices())
      n_sets = meet_laws(rates.contact.pressure);
    else
      {
        end_pressures = rates.contact.pressure;
        solve_by_secants(*this,
                         body.scene.linear_solver.tolerance,
                         rates.contact.exchange_coefficient);
        rates.contact.pressure = end_pressures;
      }
    if (body.law().is_active() && mode != ContactMode::open)
      {
        rates.n_iterations = n_sets;
        counters_.active_set_iterations += n_sets;
      }
    counters_.factorizations += stage.preconditioners().n_made() - n_made;
    ++counters_.solves;
    if (has_heat)
      rates.temperature_rate.equ(1. / tau, stage.unknowns(Field::temperature));
    if (body.scene.fields.has_displacement)
      rates.velocity.copy_locally_owned_data_from(
        stage.unknowns(Field::displacement));
    rates.algebraic_power = algebraic_power(known, tau, rates.contact.pressure);
  }



  template class IterativeSolver<2>;
  template class IterativeSolver<3>;
} // namespace ThermoContact
