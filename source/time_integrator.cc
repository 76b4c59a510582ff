// SPDX-License-Identifier: LGPL-2.1-or-later

#include "time_integrator.h"

#include "direct_solver.h"

namespace ThermoContact
{
  template <int dim>
  TimeIntegrator<dim>::TimeIntegrator(
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &stage_operator,
    const Energy<dim>                     &energy,
    const ContactLaw                      &law,
    ProblemData<dim>                      &data,
    StepSolver                            &step_solver)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , energy(energy)
    , law(law)
    , data(data)
    , step_solver(step_solver)
    , heat_load(stage_operator.robin_load())
    , momentum_load(discretization.make_vector(1))
  {
    rates.temperature_rate.reinit(heat_load);
    rates.velocity.reinit(momentum_load);
  }



  template <int dim>
  void
  TimeIntegrator<dim>::step(const State    &state,
                            const TimeStep &time_step,
                            StepResult     &result)
  {
    stage_operator.load(data, time_step.end, heat_load, momentum_load);
    step_solver.solve(state, time_step.size, heat_load, momentum_load, rates);

    result.failure       = rates.failure;
    result.n_iterations  = rates.n_iterations;
    result.is_prescribed = false;
    if (!result.failure.empty())
      return;

    result.state                  = state;
    result.state.time             = time_step.end;
    result.state.velocity         = rates.velocity;
    result.state.contact_pressure = rates.pressure;
    result.state.temperature.add(time_step.size, rates.temperature_rate);
    result.state.displacement.add(time_step.size, rates.velocity);

    balance(time_step, result);
    result.numerical_dissipation =
      energy.numerical_dissipation(state, result.state);
  }



  template <int dim>
  void
  TimeIntegrator<dim>::prescribed_step(const State    &state,
                                       const TimeStep &time_step,
                                       StepResult     &result)
  {
    const double tau = time_step.size;
    DirectSolver heat_solver(stage_operator.heat_stage_matrix(tau));
    ++counters_.factorizations;

    Vector heat_rhs(heat_load), momentum_rhs(momentum_load);
    stage_operator.load(data, time_step.end, heat_load, momentum_load);
    stage_operator.stage_rhs(
      state, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    stage_operator.subtract_heating(state.velocity, heat_rhs);
    heat_solver.solve(rates.temperature_rate, heat_rhs);
    ++counters_.solves;

    result.failure.clear();
    result.n_iterations  = 0;
    result.is_prescribed = true;
    result.state         = state;
    result.state.time    = time_step.end;
    result.state.temperature.add(tau, rates.temperature_rate);
    result.state.displacement.add(tau, state.velocity);

    std::vector<double> end_displacement;
    discretization.contact_values(1,
                                  result.state.displacement,
                                  end_displacement);
    if (law.compliance > 0.)
      for (unsigned int i = 0; i < end_displacement.size(); ++i)
        result.state.contact_pressure[i] =
          law.pressure(end_displacement[i], 0.);

    balance(time_step, result);
    result.numerical_dissipation = energy.energy(state).sum() -
                                   result.energy.sum() + result.work -
                                   result.dissipation;
  }



  template <int dim>
  void
  TimeIntegrator<dim>::balance(const TimeStep &time_step,
                               StepResult     &result) const
  {
    result.energy      = energy.energy(result.state);
    result.dissipation = time_step.size * energy.dissipation_rate(result.state);
    result.work        = data.has_sources() ?
                           time_step.size *
                      energy.work_rate(heat_load, momentum_load, result.state) :
                           0.;
  }



  template class TimeIntegrator<1>;
  template class TimeIntegrator<2>;
  template class TimeIntegrator<3>;
} // namespace ThermoContact
