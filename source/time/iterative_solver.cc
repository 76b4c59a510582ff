// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/stop_watch.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/iterative_solver.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ThermoContact
{
  template <int dim>
  IterativeSolver<dim>::IterativeSolver(const Body<dim> &body)
    : ContactPort<dim>(body)
    , body(body)
    , stage(body, warnings)
    , responses(stage.preconditioners().most_kept())
  {}



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
        retained.has_response.push_back(
          std::any_of(responses.all().begin(),
                      responses.all().end(),
                      [&](const Response &response) {
                        return response.tau == hierarchy.tau;
                      }));
        retained.contact_springs.push_back(hierarchy.last_contact);
      }
    return retained;
  }



  template <int dim>
  void
  IterativeSolver<dim>::restore(const RetainedFactorizations &retained)
  {
    stage.preconditioners().clear();
    responses.clear();
    for (unsigned int i = retained.taus.size(); i-- > 0;)
      {
        stage.restore(retained.taus[i], retained.contact_springs[i]);
        if (retained.has_response[i])
          response(retained.taus[i]);
      }
    stage.set_reported_rounding(retained.reported_rounding);
    counters_ = retained.counters;
    warnings.clear(); // the run has given them before
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_system(const bool is_last)
  {
    const double tolerance =
      body.scene.linear_solver.tolerance *
      (body.scene.heat.exchange->is_in_matrices() ? 1. :
                                                    Tolerances::within_search);
    counters_.count_iterations(stage.solve(
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
  const FullMatrix<double> &
  IterativeSolver<dim>::response(const double tau)
  {
    if (responses.use(tau))
      return responses.front().matrix;
    const unsigned int n_made = stage.preconditioners().n_made();
    {
      const StopWatch watch(counters_.solve_seconds);
      const StopWatch watch_of_hierarchy(counters_.factorization_seconds);
      stage.preconditioners().provide(tau);
    }
    const StopWatch           watch(counters_.contact_seconds);
    const State               at_rest(body.make_state());
    const Vector              no_heat(at_rest.temperature);
    Vector                    load(at_rest.displacement);
    const std::vector<double> none(body.contact_end().n_nodes(), 0.);

    FullMatrix<double> matrix = body.contact_end().response_matrix(
      [&](const unsigned int node) -> const Vector & {
        body.contact_end().set_load_of_node(Field::displacement,
                                            node,
                                            1.,
                                            load);
        stage.prepare(at_rest, tau, no_heat, load, none);
        stage.set_springs(none, none);
        solve_system(true);
        ++counters_.responses;
        return stage.velocity();
      });
    matrix *= tau;
    counters_.factorizations += stage.preconditioners().n_made() - n_made;
    responses.add({tau, std::move(matrix)});
    return responses.front().matrix;
  }



  template <int dim>
  void
  IterativeSolver<dim>::apply_pressure(StageRates &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    stage.push(rates.contact.pressure);
    solve_system(true);
    set_rates(std::vector<double>(rates.contact.pressure.size(), 0.), rates);
  }



  template <int dim>
  void
  IterativeSolver<dim>::set_rates(const std::vector<double> &pressure,
                                  StageRates                &rates) const
  {
    const double tau = stage.length();
    double       sum = 0.;
    if (body.scene.fields.has_temperature)
      {
        rates.temperature_rate.equ(1. / tau,
                                   stage.unknowns(Field::temperature));
        Vector at_end(excess);
        at_end += stage.unknowns(Field::temperature);
        sum += stage.unsolved(Field::temperature) * at_end;
      }
    if (body.scene.fields.has_displacement)
      {
        rates.velocity.copy_locally_owned_data_from(
          stage.unknowns(Field::displacement));
        Vector unsolved(stage.unsolved(Field::displacement));
        body.contact_end().subtract_load(Field::displacement,
                                         pressure,
                                         tau,
                                         unsolved);
        sum += unsolved * stage.unknowns(Field::displacement);
      }
    rates.algebraic_power =
      -sum / (tau * body.discretization.geometry().cross_section());
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
    counters_.count_iterations(
      stage.solve(Tolerances::estimate_residual,
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
    const unsigned int n_made = stage.preconditioners().n_made();
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
    if (body.scene.fields.has_temperature)
      {
        excess = known.temperature;
        excess -= body.energy.steady_profile();
      }
    set_rates(rates.contact.pressure, rates);
  }



  template class IterativeSolver<2>;
  template class IterativeSolver<3>;
} // namespace ThermoContact
