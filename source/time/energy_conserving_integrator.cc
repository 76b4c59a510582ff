// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/local_sums.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/energy_conserving_integrator.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  template <int dim>
  EnergyConservingIntegrator<dim>::EnergyConservingIntegrator(Body<dim> &body)
    : body(body)
    , solver(make_stage_solver(body))
    , driven(body)
    , midpoint(body.make_state())
    , heat_load(body.discretization.make_vector(Field::temperature))
    , momentum_load(body.discretization.make_vector(Field::displacement))
    , nodes(body,
            motion_at_once,
            this->counters_,
            LinearSystem<dim>::Rows::contact_end)
  {
    rates.temperature_rate = heat_load;
    rates.velocity         = momentum_load;
    rates.acceleration     = momentum_load;
    if (body.law().is_active())
      set_up_contact();
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::assemble_loads(const double begin,
                                                  const double end)
  {
    std::vector<double> mean_load;
    if (body.loads.has_sources() && contact)
      for (const double time : {begin, end})
        {
          body.loads.assemble(time, heat_load, momentum_load);
          mean_load.resize(body.contact_end().n_all_nodes(), 0.);
          for (const auto &[node, entry] :
               body.contact_end().all_entries(Field::displacement))
            mean_load[node] += 0.5 * momentum_load.begin()[entry];
        }
    body.loads.assemble(0.5 * (begin + end), heat_load, momentum_load);
    if (!mean_load.empty())
      for (const auto &[node, entry] :
           body.contact_end().all_entries(Field::displacement))
        momentum_load.begin()[entry] = mean_load[node];
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::solve_without_contact(
    const State    &state,
    const TimeStep &time_step)
  {
    const double tau = 0.5 * time_step.size;
    if (!driven.is_active())
      {
        solver->solve(
          state, tau, heat_load, momentum_load, ContactMode::open, rates);
        return;
      }
    static const std::vector<std::vector<double>> half   = {{0.5}};
    static const std::vector<double>              weight = {1.};
    driven.start(state, time_step.size, {half, weight, {time_step.last_loads}});
    State      known(state);
    const auto loads = driven.constrain(0, {heat_load, momentum_load}, known);
    solver->solve(
      known, tau, loads.heat, loads.momentum, ContactMode::open, rates);
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::step(const State    &state,
                                        const TimeStep &time_step,
                                        const ContactMode,
                                        StepResult &result)
  {
    const double size = time_step.size;
    move_obstacle(state, time_step);
    assemble_loads(time_step.first_loads, time_step.last_loads);
    if (contact)
      {
        loss = solver->response(0.5 * size);
        loss.add(-1., receptance);
      }
    solve_without_contact(state, time_step);
    if (contact)
      apply_contact(state, time_step);

    driven.complete(0, rates);
    set_equal(midpoint.velocity, rates.velocity);
    set_sum(midpoint.temperature,
            state.temperature,
            0.5 * size,
            rates.temperature_rate);

    result.state.copy_values(state);
    result.state.time     = time_step.end;
    result.state.gap      = obstacle.gap;
    result.state.gap_rate = obstacle.gap_rate;
    result.state.temperature.add(size, rates.temperature_rate);
    result.state.displacement.add(size, rates.velocity);
    result.state.velocity.sadd(-1., 2., rates.velocity);
    if (contact)
      finish_contact(state, time_step, result.state);

    result.failure.clear();
    result.start_sums();
    result.n_iterations  = rates.n_iterations;
    result.is_prescribed = false;
    result.algebraic += size * rates.algebraic_power;
    result.add_dissipation(size, midpoint, body);
    // contact nodes move from end to end, not along their mean velocity
    if (contact)
      for (const auto &[node, entry] :
           body.contact_end().all_entries(Field::displacement))
        midpoint.velocity.begin()[entry] = result.state.velocity.begin()[entry];
    midpoint.contact.pressure = rates.contact.pressure;
    if (body.boundary_flows.is_active())
      {
        set_sum(midpoint.displacement,
                state.displacement,
                0.5 * size,
                rates.velocity);
        set_sum(rates.acceleration, result.state.velocity, -1., state.velocity);
        rates.acceleration *= 1. / size;
        midpoint.load_time =
          0.5 * (time_step.first_loads + time_step.last_loads);
      }
    result.add_work(size,
                    {midpoint,
                     rates.temperature_rate,
                     rates.acceleration,
                     heat_load,
                     momentum_load},
                    body);
    result.add_contact(size, midpoint, body);
    result.energy = body.energy.energy(result.state);
    result.close_balance();
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::set_up_contact()
  {
    const unsigned int n = body.contact_end().n_nodes();
    all_receptance       = nodes.receptance();
    receptance.reinit(n, n);
    receptance.fill(all_receptance);
    contact = std::make_unique<ConservingContact>(body.law(), receptance);
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::move_obstacle(const State    &state,
                                                 const TimeStep &time_step)
  {
    obstacle.gap      = state.gap;
    obstacle.gap_rate = state.gap_rate;
    body.obstacle.place(time_step.end, time_step.last_loads, obstacle);
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
    old_free_position = product(receptance, state.contact.pressure);
    free_position.resize(n);
    double displacement_scale = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        old_free_position[i] += old_displacement[i];
        free_position[i] =
          2. * (old_displacement[i] + 0.5 * time_step.size * velocity[i]) -
          old_free_position[i];
      }
    get_node_laws(
      body.scene.contact, state.gap, old_free_position, laws, start);
    std::vector<double> free_end(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double at_end = // where the local one is
          body.scene.contact.place(laws[i].side, i, obstacle.gap[i]);
        free_end[i] = free_position[i] - at_end;
        displacement_scale =
          std::max(displacement_scale,
                   std::abs(at_end) + std::abs(old_free_position[i]));
      }
    rates.contact.pressure = state.contact.pressure;
    rates.n_iterations     = contact->step_pressure(
      laws, start, free_end, loss, displacement_scale, rates.contact.pressure);
    solver->apply_pressure(rates);
    const std::vector<double> lost = product(loss, rates.contact.pressure);
    for (unsigned int i = 0; i < n; ++i)
      free_position[i] -= 2. * lost[i];
  }



  template <int dim>
  void
  EnergyConservingIntegrator<dim>::finish_contact(const State    &state,
                                                  const TimeStep &time_step,
                                                  State          &new_state)
  {
    std::vector<double> &pressure = new_state.contact.pressure;
    pressure                      = rates.contact.pressure;
    get_node_laws(
      body.scene.contact, new_state.gap, free_position, laws, start);
    contact->equilibrium(laws, start, pressure);

    std::vector<double> old_displacement, displacement;
    body.contact_end().get_all_values(Field::displacement,
                                      state.displacement,
                                      old_displacement);
    body.contact_end().get_all_values(Field::displacement,
                                      new_state.displacement,
                                      displacement);
    const std::vector<double> yielded = product(receptance, pressure);

    // nodes without pressure follow from the middle of the step to its end
    std::vector<double> more(pressure);
    for (unsigned int i = 0; i < more.size(); ++i)
      more[i] =
        2. * rates.contact.pressure[i] - state.contact.pressure[i] - more[i];
    std::vector<double> position = product(all_receptance, more);
    for (unsigned int i = 0; i < position.size(); ++i)
      {
        position[i] =
          i >= pressure.size() ? displacement[i] + position[i] :
          pressure[i] != 0.    ? displacement_of_law(body, new_state, i) :
                                 free_position[i] - yielded[i];
        displacement[i] = position[i] - displacement[i];
      }
    Vector change = body.discretization.make_vector(Field::displacement);
    body.contact_end().set_all_values(Field::displacement,
                                      displacement,
                                      change);
    nodes.add_heating(change, new_state.temperature);
    for (const auto &[node, entry] :
         body.contact_end().all_entries(Field::displacement))
      {
        new_state.displacement.begin()[entry] = position[node];
        new_state.velocity.begin()[entry] =
          (position[node] - old_displacement[node]) / time_step.size;
      }
  }



  template class EnergyConservingIntegrator<1>;
  template class EnergyConservingIntegrator<2>;
  template class EnergyConservingIntegrator<3>;
} // namespace ThermoContact
