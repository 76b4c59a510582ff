// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/contact_transition.h>
#include <thermocontact/simulation/exchange_of_law.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/contact_equilibrium.h>

namespace ThermoContact
{
  template <int dim>
  ContactTransition<dim>::ContactTransition(Body<dim>             &body,
                                            QuasiStaticStart<dim> &quasi_static)
    : body(body)
    , quasi_static(quasi_static)
  {}



  template <int dim>
  void
  ContactTransition<dim>::compute_impulse_responses()
  {
    mass_solver =
      std::make_unique<DirectSolver>(body.equations.momentum_stage_matrix(0.));
    ++counters_.factorizations;

    Vector load        = body.discretization.make_vector(Field::displacement);
    inverse_receptance = body.contact_end().response_matrix(
      [&](const unsigned int node) -> const Vector & {
        body.contact_end().set_load_of_node(Field::displacement,
                                            node,
                                            1.,
                                            load);
        Vector &response = impulse_responses.emplace_back(load);
        mass_solver->solve(response, load);
        ++counters_.responses;
        return response;
      });
    inverse_receptance.gauss_jordan();
  }



  template <int dim>
  void
  ContactTransition<dim>::restore(const SolverCounters &counters)
  {
    if (counters.factorizations > 0 && body.scene.contact.has_mass() &&
        !mass_solver)
      compute_impulse_responses();
    counters_ = counters;
  }



  template <int dim>
  void
  ContactTransition<dim>::stop_contact_nodes(State &state, ImpactCost &cost)
  {
    if (!mass_solver)
      compute_impulse_responses();
    std::vector<double> contact_velocity;
    body.contact_end().get_approach(state, contact_velocity);
    std::vector<double> impulses(contact_velocity.size(), 0.);
    for (unsigned int i = 0; i < impulses.size(); ++i)
      for (unsigned int j = 0; j < impulses.size(); ++j)
        impulses[i] += inverse_receptance(i, j) * contact_velocity[j];
    for (unsigned int i = 0; i < impulses.size(); ++i)
      {
        state.velocity.add(-impulses[i], impulse_responses[i]);
        cost.work -=
          body.contact_end().share(i) * impulses[i] * state.gap_rate[i];
      }
    cost.impulse += body.contact_end().mean(impulses);
  }



  template <int dim>
  void
  ContactTransition<dim>::set_pressures_of_acceleration(State &state)
  {
    if (!mass_solver)
      compute_impulse_responses();
    const Material &material = body.scene.material;
    Vector          heat = body.discretization.make_vector(Field::temperature);
    Vector          load = body.discretization.make_vector(Field::displacement);
    Vector          heat_load = heat, force = load, product = load;
    body.loads.assemble(state.time, heat_load, load);
    // a stage of length 1 has the forces on its right-hand side, and more
    body.equations.stage_rhs(state, 1., heat_load, load, heat, force);
    body.equations.momentum_mass().vmult(product, state.velocity);
    force.add(-material.inertia, product);
    if (material.has_viscosity())
      {
        body.equations.viscous_stiffness().vmult(product, state.velocity);
        force.add(-material.viscosity, product);
      }
    body.equations.zero_constrained(Field::displacement, force);
    mass_solver->solve(product, force);
    ++counters_.solves;
    std::vector<double>          excess;
    std::vector<TimeDerivatives> obstacle;
    body.contact_end().get_values(Field::displacement, product, excess);
    body.obstacle.get_derivatives(state.time, obstacle);
    for (unsigned int i = 0; i < excess.size(); ++i)
      excess[i] -= obstacle[i].second;
    for (unsigned int i = 0; i < excess.size(); ++i)
      {
        state.contact_pressure[i] = 0.;
        for (unsigned int j = 0; j < excess.size(); ++j)
          state.contact_pressure[i] += inverse_receptance(i, j) * excess[j];
      }
    set_exchange_of_law(body, state);
  }



  template <int dim>
  void
  ContactTransition<dim>::impact(State       &state,
                                 EnergyTerms &energy_terms,
                                 ImpactCost  &cost)
  {
    ImpactCost own;
    if (body.scene.contact.has_mass())
      stop_contact_nodes(state, own);
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::displacement))
      state.displacement.begin()[entry] =
        laws[node].side > 0 ? state.gap[node] : -*body.scene.contact.rear_gap;
    set_exchange_of_law(body, state);
    const double old_energy   = energy_terms.sum();
    energy_terms              = body.energy.energy(state);
    own.numerical_dissipation = old_energy - energy_terms.sum() + own.work;
    cost += own;
  }



  template <int dim>
  void
  ContactTransition<dim>::settle_closed_nodes(StepResult &result)
  {
    if (result.closed_nodes.empty() || !body.law().is_rigid())
      return;
    if (!body.scene.material.has_inertia())
      {
        quasi_static.complete(result.state, result.closed_nodes);
        set_exchange_of_law(body, result.state);
        return;
      }
    if (body.scene.linear_solver.has_matrices() && contact_stiffness_.empty())
      contact_stiffness_ = contact_stiffness(body);
    settle_contact_velocities(body,
                              contact_stiffness_,
                              result.closed_nodes,
                              result.state);
    set_exchange_of_law(body, result.state);
  }



  template <int dim>
  bool
  ContactTransition<dim>::remove_pull(const int held_at, State &state) const
  {
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    bool changed = false;
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        double &p = state.contact_pressure[i];
        if ((held_at != 0 ? held_at : laws[i].side) * p < 0.)
          {
            p       = 0.;
            changed = true;
          }
      }
    return changed;
  }



  template <int dim>
  void
  ContactTransition<dim>::follow_turn(State &state)
  {
    if (body.law().damping() == 0.)
      return;
    if (body.scene.material.has_inertia())
      body.set_pressures_of_law(state);
    else
      quasi_static.complete(state);
    set_exchange_of_law(body, state);
  }



  template <int dim>
  void
  ContactTransition<dim>::finish_pressure(const ContactMode            mode,
                                          const EventLocator::Finding &finding,
                                          StepResult                  &result)
  {
    const bool is_event = finding.kind == EventLocator::Finding::at_end;
    bool       changed =
      remove_pull(mode == ContactMode::closed ? finding.side : 0, result.state);
    if (is_event && mode == ContactMode::open && !body.law().is_rigid())
      {
        changed = true;
        body.set_pressures_of_law(result.state);
      }
    if (changed || (is_event && mode == ContactMode::closed))
      set_exchange_of_law(body, result.state);
    if (!changed)
      return;
    const double old_energy = result.energy.sum();
    result.energy           = body.energy.energy(result.state);
    result.numerical_dissipation += old_energy - result.energy.sum();
  }



  template class ContactTransition<1>;
  template class ContactTransition<2>;
  template class ContactTransition<3>;
} // namespace ThermoContact
