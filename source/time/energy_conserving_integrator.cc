// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/direct_solver.h>
#include <thermocontact/time/contact_equilibrium.h>
#include <thermocontact/time/energy_conserving_integrator.h>

namespace ThermoContact
{
  namespace
  {
    /** @p matrix times @p vector. */
    std::vector<double>
    product(const FullMatrix<double> &matrix, const std::vector<double> &vector)
    {
      std::vector<double> result(matrix.m(), 0.);
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          result[i] += matrix(i, j) * vector[j];
      return result;
    }

  } // namespace



  template <int dim>
  EnergyConservingIntegrator<dim>::EnergyConservingIntegrator(
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &stage_operator,
    const Energy<dim>                     &energy,
    const ContactLaw                      &law,
    Loads<dim>                            &loads,
    StageSolver<dim>                      &stage_solver)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , energy(energy)
    , law(law)
    , loads(loads)
    , stage_solver(stage_solver)
    , midpoint(discretization.make_state())
    , heat_load(discretization.make_vector(0))
    , momentum_load(discretization.make_vector(1))
  {
    rates.temperature_rate = heat_load;
    rates.velocity         = momentum_load;
    if (law.is_active)
      set_up_contact();
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::set_up_contact()
  {
    FullMatrix<double> stiffness =
      contact_stiffness(discretization, stage_operator);
    const unsigned int n = stiffness.m();
    if (stage_operator.heating_coefficient() != 0.)
      {
        DirectSolver mass_solver(stage_operator.heat_stage_matrix(0.));
        ++counters_.factorizations;
        Vector              unit(momentum_load), force(momentum_load);
        Vector              heat(heat_load);
        std::vector<double> values;
        for (unsigned int j = 0; j < n; ++j)
          {
            unit = 0.;
            for (const auto &[node, entry] : discretization.contact_entries(1))
              unit.begin()[entry] = node == j ? 1. : 0.;
            heat = 0.;
            stage_operator.subtract_heating(unit, heat);
            Vector &response = temperature_responses.emplace_back(heat);
            mass_solver.solve(response, heat);
            ++counters_.responses;
            force = 0.;
            stage_operator.add_thermal_stress(response, 1., force);
            discretization.contact_values(1, force, values);
            for (unsigned int i = 0; i < n; ++i)
              stiffness(i, j) -= values[i];
          }
      }
    receptance = contact_receptance(discretization, stiffness);
    contact    = std::make_unique<ConservingContact>(law, receptance);
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::assemble_loads(const double begin,
                                                  const double end)
  {
    std::vector<double> mean_load;
    if (loads.has_sources() && law.is_active)
      for (const double time : {begin, end})
        {
          loads.assemble(time, heat_load, momentum_load);
          mean_load.resize(discretization.contact_nodes().size(), 0.);
          for (const auto &[node, entry] : discretization.contact_entries(1))
            mean_load[node] += 0.5 * momentum_load.begin()[entry];
        }
    loads.assemble(0.5 * (begin + end), heat_load, momentum_load);
    if (!mean_load.empty())
      for (const auto &[node, entry] : discretization.contact_entries(1))
        momentum_load.begin()[entry] = mean_load[node];
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::apply_contact(const State    &state,
                                                 const TimeStep &time_step)
  {
    const unsigned int  n = discretization.contact_nodes().size();
    std::vector<double> old_displacement, velocity;
    discretization.contact_values(1, state.displacement, old_displacement);
    discretization.contact_values(1, rates.velocity, velocity);
    old_free_position = product(receptance, state.contact_pressure);
    free_position.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        old_free_position[i] += old_displacement[i];
        free_position[i] =
          2. * (old_displacement[i] + 0.5 * time_step.size * velocity[i]) -
          old_free_position[i];
      }
    FullMatrix<double> difference(stage_solver.response());
    difference.add(-1., receptance);
    rates.pressure     = state.contact_pressure;
    rates.n_iterations = contact->step_pressure(old_free_position,
                                                free_position,
                                                difference,
                                                rates.pressure);
    stage_solver.apply_pressure(rates);
    const std::vector<double> loss = product(difference, rates.pressure);
    for (unsigned int i = 0; i < n; ++i)
      free_position[i] -= 2. * loss[i];
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::finish_contact(const State    &state,
                                                  const TimeStep &time_step,
                                                  State          &new_state)
  {
    std::vector<double> &pressure = new_state.contact_pressure;
    pressure                      = rates.pressure;
    contact->equilibrium(free_position, pressure);

    std::vector<double> old_displacement, displacement;
    discretization.contact_values(1, state.displacement, old_displacement);
    discretization.contact_values(1, new_state.displacement, displacement);
    const std::vector<double> loss = product(receptance, pressure);
    std::vector<double>       position(loss.size());
    for (unsigned int i = 0; i < position.size(); ++i)
      {
        position[i] = pressure[i] > 0. ?
                        law.gap + law.compliance * pressure[i] :
                        free_position[i] - loss[i];
        if (!temperature_responses.empty())
          new_state.temperature.add(position[i] - displacement[i],
                                    temperature_responses[i]);
      }
    for (const auto &[node, entry] : discretization.contact_entries(1))
      {
        new_state.displacement.begin()[entry] = position[node];
        new_state.velocity.begin()[entry] =
          (position[node] - old_displacement[node]) / time_step.size;
      }
  }



  template <int dim>
  double
  EnergyConservingIntegrator<dim>::work(const double size,
                                        const State &new_state)
  {
    // contact nodes move from end to end, not along their mean velocity
    if (law.is_active)
      for (const auto &[node, entry] : discretization.contact_entries(1))
        midpoint.velocity.begin()[entry] = new_state.velocity.begin()[entry];
    return size * energy.work_rate(heat_load, momentum_load, midpoint);
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::step(const State    &state,
                                        const double    old_energy,
                                        const TimeStep &time_step,
                                        const ContactMode,
                                        StepResult &result)
  {
    const double size = time_step.size;
    midpoint.time     = state.time + 0.5 * size;
    assemble_loads(state.time, time_step.end);
    stage_solver.solve_without_contact(
      state, 0.5 * size, heat_load, momentum_load, rates);
    if (law.is_active)
      apply_contact(state, time_step);

    midpoint.velocity    = rates.velocity;
    midpoint.temperature = state.temperature;
    midpoint.temperature.add(0.5 * size, rates.temperature_rate);

    result.state      = state;
    result.state.time = time_step.end;
    result.state.temperature.add(size, rates.temperature_rate);
    result.state.displacement.add(size, rates.velocity);
    result.state.velocity.sadd(-1., 2., rates.velocity);
    if (law.is_active)
      finish_contact(state, time_step, result.state);

    result.failure.clear();
    result.n_iterations  = rates.n_iterations;
    result.is_prescribed = false;
    result.dissipation   = size * energy.dissipation_rate(midpoint);
    result.work          = energy.has_work() ? work(size, result.state) : 0.;
    result.impulse       = size * discretization.contact_mean(rates.pressure);
    result.energy        = energy.energy(result.state);
    result.numerical_dissipation =
      old_energy - result.energy.sum() + result.work - result.dissipation;
  }



  template class EnergyConservingIntegrator<1>;
  template class EnergyConservingIntegrator<2>;
  template class EnergyConservingIntegrator<3>;
} // namespace ThermoContact
