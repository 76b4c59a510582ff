// SPDX-License-Identifier: LGPL-2.1-or-later

#include "time_integrator.h"

#include <algorithm>


namespace ThermoContact
{
  template <int dim>
  TimeIntegrator<dim>::TimeIntegrator(
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &stage_operator,
    const Energy<dim>                     &energy,
    const ContactLaw                      &law,
    const ButcherTableau                  &tableau,
    Loads<dim>                            &loads,
    StepSolver                            &step_solver)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , energy(energy)
    , law(law)
    , tableau(tableau)
    , loads(loads)
    , step_solver(step_solver)
    , stages(tableau.n_stages())
    , accelerations(tableau.n_stages(), discretization.make_vector(1))
    , known(discretization.make_state())
    , difference(known)
    , heat_load(discretization.make_vector(0))
    , momentum_load(discretization.make_vector(1))
  {
    for (StageRates &stage : stages)
      {
        stage.temperature_rate = heat_load;
        stage.velocity         = momentum_load;
      }
  }



  template <int dim>
  void
  TimeIntegrator<dim>::set_known_values(const State       &state,
                                        const double       step_size,
                                        const unsigned int i)
  {
    known = state;
    for (unsigned int j = 0; j < i; ++j)
      {
        const double factor = step_size * tableau.a[i][j];
        known.temperature.add(factor, stages[j].temperature_rate);
        known.displacement.add(factor, stages[j].velocity);
        known.velocity.add(factor, accelerations[j]);
      }
    if (i > 0)
      known.contact_pressure = stages[i - 1].pressure;
  }



  template <int dim>
  void
  TimeIntegrator<dim>::step(const State      &state,
                            const double      old_energy,
                            const TimeStep   &time_step,
                            const ContactMode mode,
                            StepResult       &result)
  {
    const double tau = tableau.gamma() * time_step.size;

    result.work = result.dissipation = result.impulse = 0.;
    result.n_iterations                               = 0;
    result.is_prescribed                              = false;
    for (unsigned int i = 0; i < tableau.n_stages(); ++i)
      {
        const bool   is_last = i + 1 == tableau.n_stages();
        const double time =
          is_last ? time_step.end : state.time + tableau.c[i] * time_step.size;
        StageRates &stage = stages[i];

        set_known_values(state, time_step.size, i);
        loads.assemble(time, heat_load, momentum_load);
        step_solver.solve(known, tau, heat_load, momentum_load, mode, stage);
        result.failure = stage.failure;
        result.n_iterations += stage.n_iterations;
        if (!result.failure.empty())
          return;

        if (!is_last || tableau.has_error_estimate())
          {
            accelerations[i] = stage.velocity;
            accelerations[i].add(-1., known.velocity);
            accelerations[i] /= tau;
          }
        known.time             = time;
        known.velocity         = stage.velocity;
        known.contact_pressure = stage.pressure;
        known.temperature.add(tau, stage.temperature_rate);
        known.displacement.add(tau, stage.velocity);
        book(known, tableau.b()[i] * time_step.size, result);
      }
    result.state  = known;
    result.energy = energy.energy(result.state);
    if (tableau.has_error_estimate())
      estimate_error(time_step.size, result);
    result.numerical_dissipation =
      tableau.n_stages() == 1 ?
        energy.numerical_dissipation(state, result.state) :
        old_energy - result.energy.sum() + result.work - result.dissipation;
  }



  template <int dim>
  void
  TimeIntegrator<dim>::estimate_error(const double step_size,
                                      StepResult  &result)
  {
    difference.temperature  = 0.;
    difference.displacement = 0.;
    difference.velocity     = 0.;
    for (unsigned int i = 0; i < tableau.n_stages(); ++i)
      {
        const double factor =
          step_size * (tableau.b()[i] - tableau.embedded_b[i]);
        if (factor == 0.)
          continue;
        difference.temperature.add(factor, stages[i].temperature_rate);
        difference.displacement.add(factor, stages[i].velocity);
        difference.velocity.add(factor, accelerations[i]);
      }
    result.error =
      energy.difference_energy(difference, result.state.contact_pressure);
  }



  template <int dim>
  void
  TimeIntegrator<dim>::prescribed_step(const State    &state,
                                       const TimeStep &time_step,
                                       StepResult     &result)
  {
    const double tau   = time_step.size;
    StageRates  &stage = stages[0];
    DirectSolver heat_solver(stage_operator.heat_stage_matrix(tau));
    ++counters_.factorizations;

    Vector heat_rhs(heat_load), momentum_rhs(momentum_load);
    loads.assemble(time_step.end, heat_load, momentum_load);
    stage_operator.stage_rhs(
      state, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    stage_operator.subtract_heating(state.velocity, heat_rhs);
    heat_solver.solve(stage.temperature_rate, heat_rhs);
    ++counters_.solves;

    result.failure.clear();
    result.n_iterations  = 0;
    result.is_prescribed = true;
    result.state         = state;
    result.state.time    = time_step.end;
    result.state.temperature.add(tau, stage.temperature_rate);
    result.state.displacement.add(tau, state.velocity);

    std::vector<double> end_displacement;
    discretization.contact_values(1,
                                  result.state.displacement,
                                  end_displacement);
    if (law.compliance > 0.)
      for (unsigned int i = 0; i < end_displacement.size(); ++i)
        result.state.contact_pressure[i] =
          law.pressure(end_displacement[i], 0.);

    result.work = result.dissipation = result.impulse = 0.;
    book(result.state, tau, result);
    result.energy                = energy.energy(result.state);
    result.numerical_dissipation = energy.energy(state).sum() -
                                   result.energy.sum() + result.work -
                                   result.dissipation;
  }



  template <int dim>
  void
  TimeIntegrator<dim>::compute_impulse_responses()
  {
    mass_solver =
      std::make_unique<DirectSolver>(stage_operator.momentum_stage_matrix(0.));
    ++counters_.factorizations;

    const unsigned int n = discretization.contact_nodes().size();
    inverse_receptance.reinit(n, n);
    std::vector<double> velocity(n);
    Vector              load(momentum_load);
    for (unsigned int j = 0; j < n; ++j)
      {
        std::vector<double> unit_impulse(n, 0.);
        unit_impulse[j] = 1.;
        load            = 0.;
        stage_operator.subtract_pressure(unit_impulse, -1., load);
        mass_solver->solve(impulse_responses.emplace_back(load), load);
        ++counters_.responses;
        discretization.contact_values(1, impulse_responses[j], velocity);
        for (unsigned int i = 0; i < n; ++i)
          inverse_receptance(i, j) = velocity[i];
      }
    inverse_receptance.gauss_jordan();
  }



  template <int dim>
  void
  TimeIntegrator<dim>::impact(State       &state,
                              EnergyTerms &energy_terms,
                              double      &impulse,
                              double      &numerical_dissipation)
  {
    if (!mass_solver)
      compute_impulse_responses();
    std::vector<double> velocity;
    discretization.contact_values(1, state.velocity, velocity);
    std::vector<double> impulses(velocity.size(), 0.);
    for (unsigned int i = 0; i < impulses.size(); ++i)
      for (unsigned int j = 0; j < impulses.size(); ++j)
        impulses[i] += inverse_receptance(i, j) * velocity[j];
    for (unsigned int i = 0; i < impulses.size(); ++i)
      state.velocity.add(-impulses[i], impulse_responses[i]);
    for (const auto &[node, entry] : discretization.contact_entries(1))
      state.displacement.begin()[entry] = law.gap;
    impulse += discretization.contact_mean(impulses);
    const double old_energy = energy_terms.sum();
    energy_terms            = energy.energy(state);
    numerical_dissipation += old_energy - energy_terms.sum();
  }



  template <int dim>
  void
  TimeIntegrator<dim>::finish_pressure(const bool  begins_contact,
                                       StepResult &result)
  {
    std::vector<double> &pressure = result.state.contact_pressure;
    bool                 changed  = false;
    for (double &p : pressure)
      {
        changed |= p < 0.;
        p = std::max(p, 0.);
      }
    if (begins_contact && law.compliance > 0.)
      {
        changed = true;
        discretization.contact_values(1, result.state.displacement, pressure);
        for (double &p : pressure) // displacements so far
          p = law.pressure(p, 0.);
      }
    if (!changed)
      return;
    const double old_energy = result.energy.sum();
    result.energy           = energy.energy(result.state);
    result.numerical_dissipation += old_energy - result.energy.sum();
  }



  template <int dim>
  void
  TimeIntegrator<dim>::book(const State &stage_state,
                            const double weight,
                            StepResult  &result)
  {
    result.dissipation += weight * energy.dissipation_rate(stage_state);
    result.impulse +=
      weight * discretization.contact_mean(stage_state.contact_pressure);
    if (loads.has_sources())
      result.work +=
        weight * energy.work_rate(heat_load, momentum_load, stage_state);
  }



  template class TimeIntegrator<1>;
  template class TimeIntegrator<2>;
  template class TimeIntegrator<3>;
} // namespace ThermoContact
