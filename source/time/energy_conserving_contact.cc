// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact in the midpoint rule: what the pressures of a step are.

#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/contact_equilibrium.h>
#include <thermocontact/time/energy_conserving_integrator.h>

#include <algorithm>
#include <cmath>

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
  void
  EnergyConservingIntegrator<dim>::add_heating(FullMatrix<double> &stiffness)
  {
    const ContactEnd<dim> &end = body.contact_end();
    DirectSolver           mass_solver(body.equations.heat_stage_matrix(0.));
    ++counters_.factorizations;
    Vector unit(momentum_load), force(momentum_load), heat(heat_load);
    stiffness.add(-1.,
                  end.all_response_matrix(
                    [&](const unsigned int node) -> const Vector & {
                      std::vector<double> unit_value(end.n_all_nodes(), 0.);
                      unit_value[node] = 1.;
                      unit             = 0.;
                      end.set_all_values(Field::displacement, unit_value, unit);
                      heat = 0.;
                      body.equations.subtract_heating(unit, heat);
                      Vector &response =
                        temperature_responses.emplace_back(heat);
                      mass_solver.solve(response, heat);
                      ++counters_.responses;
                      force = 0.;
                      body.equations.add_thermal_stress(response, 1., force);
                      return force;
                    }));
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::set_up_contact()
  {
    FullMatrix<double> stiffness = contact_stiffness(body);
    if (body.equations.is_coupled())
      add_heating(stiffness);
    stiffness.gauss_jordan(); // its inverse
    all_receptance = contact_receptance(body.contact_end(), stiffness);
    receptance     = between_pressures(all_receptance);
    contact = std::make_unique<ConservingContact>(body.law(), receptance);
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::move_obstacle(const State    &state,
                                                 const TimeStep &time_step)
  {
    obstacle.gap      = state.gap;
    obstacle.gap_rate = state.gap_rate;
    body.obstacle.place(time_step.end, obstacle);
    for (unsigned int i = 0; i < state.gap.size(); ++i)
      midpoint.gap_rate[i] = (obstacle.gap[i] - state.gap[i]) / time_step.size;
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::apply_contact(const State    &state,
                                                 const TimeStep &time_step)
  {
    const unsigned int  n = body.contact_end().n_nodes();
    std::vector<double> old_displacement, velocity;
    body.contact_end().get_values(Field::displacement,
                                  state.displacement,
                                  old_displacement);
    body.contact_end().get_values(Field::displacement,
                                  rates.velocity,
                                  velocity);
    old_free_position = product(receptance, state.contact_pressure);
    free_position.resize(n);
    double displacement_scale = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        old_free_position[i] += old_displacement[i];
        free_position[i] =
          2. * (old_displacement[i] + 0.5 * time_step.size * velocity[i]) -
          old_free_position[i];
      }
    get_node_laws(body, state.gap, old_free_position, laws, start);
    std::vector<double> free_end(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double obstacle_at = // the local one, at the end
          laws[i].side > 0 ? obstacle.gap[i] : -*body.scene.contact.rear_gap;
        free_end[i] = free_position[i] - obstacle_at;
        displacement_scale =
          std::max(displacement_scale,
                   std::abs(obstacle_at) + std::abs(old_free_position[i]));
      }
    FullMatrix<double> difference(solver->response());
    difference.add(-1., receptance);
    rates.pressure     = state.contact_pressure;
    rates.n_iterations = contact->step_pressure(
      laws, start, free_end, difference, displacement_scale, rates.pressure);
    solver->apply_pressure(rates);
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
    get_node_laws(body, new_state.gap, free_position, laws, start);
    contact->equilibrium(laws, start, pressure);

    std::vector<double> old_displacement, displacement;
    body.contact_end().get_all_values(Field::displacement,
                                      state.displacement,
                                      old_displacement);
    body.contact_end().get_all_values(Field::displacement,
                                      new_state.displacement,
                                      displacement);
    const std::vector<double> loss = product(receptance, pressure);

    // nodes without pressure follow from the middle of the step to its end
    std::vector<double> change(pressure);
    for (unsigned int i = 0; i < change.size(); ++i)
      change[i] =
        2. * rates.pressure[i] - state.contact_pressure[i] - change[i];
    std::vector<double> position = product(all_receptance, change);
    for (unsigned int i = 0; i < position.size(); ++i)
      {
        position[i] =
          i >= pressure.size() ? displacement[i] + position[i] :
          pressure[i] != 0.    ? displacement_of_law(body, new_state, i) :
                                 free_position[i] - loss[i];
        if (!temperature_responses.empty())
          new_state.temperature.add(position[i] - displacement[i],
                                    temperature_responses[i]);
      }
    for (const auto &[node, entry] :
         body.contact_end().all_entries(Field::displacement))
      {
        new_state.displacement.begin()[entry] = position[node];
        new_state.velocity.begin()[entry] =
          (position[node] - old_displacement[node]) / time_step.size;
      }
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::apply_step_contact(const State    &state,
                                                      const TimeStep &time_step)
  {
    const ContactEnd<dim> &end = body.contact_end();
    AssertDimension(end.n_nodes(), 1);
    get_node_laws(body, state, laws, start);
    // the velocity first, then where it leads
    std::vector<double> end_position;
    end.get_values(Field::displacement, rates.velocity, end_position);
    end_position[0] =
      start[0] + (time_step.size * end_position[0] -
                  (laws[0].side > 0 ? obstacle.gap[0] - state.gap[0] : 0.));
    rates.pressure.assign(1, 0.);
    rates.n_iterations = 0;
    if (laws[0].is_open(start[0]) && laws[0].is_open(end_position[0]))
      return;
    if (has_mean_pressure)
      laws[0].mean_from = start[0];
    rates.pressure[0] =
      laws[0].resolve(end_position[0], 2. * solver->response()(0, 0)).pressure;
    rates.n_iterations = 1;
    solver->apply_pressure(rates);
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::finish_step_contact(State &new_state)
  {
    new_state.contact_pressure = rates.pressure;
    if (has_mean_pressure)
      body.set_pressures_of_law(new_state);
  }



#define INSTANTIATE(dim)                                             \
  template void EnergyConservingIntegrator<dim>::set_up_contact();   \
  template void EnergyConservingIntegrator<dim>::move_obstacle(      \
    const State &, const TimeStep &);                                \
  template void EnergyConservingIntegrator<dim>::apply_contact(      \
    const State &, const TimeStep &);                                \
  template void EnergyConservingIntegrator<dim>::finish_contact(     \
    const State &, const TimeStep &, State &);                       \
  template void EnergyConservingIntegrator<dim>::apply_step_contact( \
    const State &, const TimeStep &);                                \
  template void EnergyConservingIntegrator<dim>::finish_step_contact(State &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
