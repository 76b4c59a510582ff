// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/exchange_of_law.h>
#include <thermocontact/simulation/reset.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/contact_equilibrium.h>
#include <thermocontact/time/iterative_solver.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** Those that were given, else those that do not lie before the obstacle.
     */
    template <int dim>
    std::vector<bool>
    closed_nodes(const Body<dim>         &body,
                 const State             &state,
                 const std::vector<bool> &is_closed)
    {
      if (!is_closed.empty())
        return is_closed;
      std::vector<NodeLaw> laws;
      std::vector<double>  position;
      get_node_laws(body, state, laws, position);
      std::vector<bool> result;
      for (unsigned int i = 0; i < laws.size(); ++i)
        result.push_back(laws[i].penetration(position[i]) >= 0.);
      return result;
    }



    /** Laws of nodes that stay where they are, whatever pulls. */
    template <int dim>
    std::vector<NodeLaw>
    held_laws(const Body<dim> &body, const State &state)
    {
      std::vector<NodeLaw> laws;
      get_velocity_laws(body,
                        state,
                        std::vector<bool>(state.contact_pressure.size(), true),
                        laws);
      for (NodeLaw &law : laws)
        law.is_held = true;
      return laws;
    }
  } // namespace



  template <int dim>
  Reset<dim>::Reset(Body<dim> &body)
    : body(body)
    , inertia(body, Equilibrium<dim>::Matrix::inertia, counters_)
    , stiffness(body, Equilibrium<dim>::Matrix::stiffness, counters_)
  {}



  template <int dim>
  void
  Reset<dim>::restore(const SolverCounters &counters)
  {
    if (counters.factorizations > counters_.factorizations &&
        body.scene.contact.has_mass())
      inertia.provide();
    counters_ = counters;
  }



  template <int dim>
  Vector
  Reset<dim>::forces_at_rest(const State &state) const
  {
    Vector heat_load = body.discretization.make_vector(Field::temperature);
    Vector load      = body.discretization.make_vector(Field::displacement);
    Vector forces(load);
    body.loads.assemble(state.time, heat_load, load);
    if (!body.scene.material.is_static())
      body.driven_end.subtract_viscous_stress(state.time, load);
    body.equations.momentum_residual(
      state.temperature, state.displacement, nullptr, nullptr, load, forces);
    body.equations.zero_constrained(Field::displacement, forces);
    return forces;
  }



  namespace
  {
    /**
     * complete() without matrices: stages of length 1 with the temperature as
     * it is. Their equations have the matrix $(\zeta+1)S$ and the forces on the
     * body as loads.
     */
    template <int dim>
    void
    complete_iteratively(Body<dim>               &body,
                         const std::vector<bool> &is_closed,
                         IterativeSolver<dim>    &solver,
                         State                   &state)
    {
      const Discretization<dim> &space = body.discretization;
      Vector heat_load                 = space.make_vector(Field::temperature);
      Vector momentum_load             = space.make_vector(Field::displacement);
      body.loads.assemble(state.time, heat_load, momentum_load);
      StageRates rates;
      rates.velocity = momentum_load;
      State known(state);
      known.velocity           = 0.;
      const Material &material = body.scene.material;
      if (material.is_static())
        {
          solver.solve_equilibrium(heat_load, momentum_load, known);
          state.displacement     = known.displacement;
          state.contact_pressure = known.contact_pressure;
          return;
        }
      body.driven_end.subtract_viscous_stress(state.time, momentum_load);
      if (body.law().is_rigid())
        {
          std::vector<NodeLaw> laws;
          get_velocity_laws(body,
                            state,
                            closed_nodes(body, state, is_closed),
                            laws);
          solver.solve_quasi_static_velocity(
            known, heat_load, momentum_load, laws, rates);
          state.contact_pressure = rates.pressure;
        }
      else
        {
          body.contact_end().subtract_load(Field::displacement,
                                           state.contact_pressure,
                                           1.,
                                           momentum_load);
          solver.solve_momentum(
            known, 1., heat_load, momentum_load, ContactMode::open, rates);
        }
      state.velocity.equ((material.viscosity + 1.) / material.viscosity,
                         rates.velocity);
      body.driven_end.set_velocity(state.time, state.velocity);
    }
  } // namespace



  template <int dim>
  void
  Reset<dim>::set_quasi_static_velocity(const std::vector<bool> &is_closed,
                                        State                   &state)
  {
    const double viscosity = body.scene.material.viscosity;
    const double factor    = (viscosity + 1.) / viscosity;
    Vector       forces    = forces_at_rest(state);

    std::vector<NodeLaw> laws;
    std::vector<double>  position, velocity;
    if (body.law().is_rigid())
      {
        get_velocity_laws(body,
                          state,
                          closed_nodes(body, state, is_closed),
                          laws);
        std::fill(state.contact_pressure.begin(),
                  state.contact_pressure.end(),
                  0.);
      }
    else if (body.law().damping() > 0.)
      {
        get_node_laws(body, state, laws, position);
        for (unsigned int i = 0; i < laws.size(); ++i)
          {
            laws[i].is_in_velocity = true; // of nodes that stay where they are
            laws[i].start          = position[i];
          }
      }
    else // the pressure follows from the displacement alone
      body.contact_end().subtract_load(Field::displacement,
                                       state.contact_pressure,
                                       1.,
                                       forces);
    stiffness.solve(forces, state.velocity);
    if (!laws.empty())
      {
        body.contact_end().get_values(Field::displacement,
                                      state.velocity,
                                      velocity);
        for (double &v : velocity)
          v *= factor;
        for (unsigned int i = 0; i < state.gap_rate.size(); ++i)
          velocity[i] -= state.gap_rate[i];
        stiffness.add_contact(
          laws, velocity, factor, &state.velocity, state.contact_pressure);
      }
    state.velocity *= factor;
    body.driven_end.set_velocity(state.time, state.velocity);
  }



  template <int dim>
  void
  Reset<dim>::complete(State &state, const std::vector<bool> &is_closed)
  {
    if constexpr (dim > 1)
      if (!body.scene.linear_solver.has_matrices())
        {
          if (!iterative)
            iterative = std::make_unique<IterativeSolver<dim>>(body);
          iterative->restore({}); // what it makes is always the same
          complete_iteratively(body,
                               is_closed,
                               static_cast<IterativeSolver<dim> &>(*iterative),
                               state);
          SolverCounters made = iterative->counters();
          made.solves         = 0; // those of stages count
          counters_ += made;
          return;
        }
    if (!body.scene.material.is_static())
      {
        set_quasi_static_velocity(is_closed, state);
        return;
      }
    Vector change(state.displacement);
    stiffness.solve(forces_at_rest(state), change);
    state.displacement += change;
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    stiffness.add_contact(
      laws, position, 1., &state.displacement, state.contact_pressure);
  }



  template <int dim>
  void
  Reset<dim>::impact(State &state, EnergyTerms &energy_terms, ResetCost &cost)
  {
    const ContactEnd<dim> &end = body.contact_end();
    ResetCost              own;
    if (body.scene.contact.has_mass())
      {
        std::vector<double> velocity, impulses;
        end.get_relative_velocities(state, velocity);
        inertia.add_contact(
          held_laws(body, state), velocity, 1., &state.velocity, impulses);
        for (unsigned int i = 0; i < impulses.size(); ++i)
          own.work -= end.share(i) * impulses[i] * state.gap_rate[i];
        own.impulse += end.mean(impulses);
      }
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    for (const auto &[node, entry] : end.entries(Field::displacement))
      state.displacement.begin()[entry] =
        obstacle_at(body, state.gap, node, laws[node].side);
    set_exchange_of_law(body, state);
    const double old_energy   = energy_terms.sum();
    energy_terms              = body.energy.energy(state);
    own.numerical_dissipation = old_energy - energy_terms.sum() + own.work;
    cost += own;
  }



  template <int dim>
  void
  Reset<dim>::set_pressures_of_acceleration(State &state)
  {
    Vector heat = body.discretization.make_vector(Field::temperature);
    Vector load = body.discretization.make_vector(Field::displacement);
    Vector forces(load), acceleration(load);
    body.loads.assemble(state.time, heat, load);
    body.equations.momentum_residual(state.temperature,
                                     state.displacement,
                                     &state.velocity,
                                     nullptr,
                                     load,
                                     forces);
    body.equations.zero_constrained(Field::displacement, forces);
    inertia.solve(forces, acceleration);
    ++counters_.solves;
    std::vector<double>          excess;
    std::vector<TimeDerivatives> obstacle;
    body.contact_end().get_values(Field::displacement, acceleration, excess);
    body.obstacle.get_derivatives(state.time, obstacle);
    for (unsigned int i = 0; i < excess.size(); ++i)
      excess[i] -= obstacle[i].second;
    inertia.add_contact(
      held_laws(body, state), excess, 1., nullptr, state.contact_pressure);
    set_exchange_of_law(body, state);
  }



  template <int dim>
  void
  Reset<dim>::settle_closed_nodes(StepResult &result)
  {
    if (result.closed_nodes.empty() || !body.law().is_rigid())
      return;
    if (!body.scene.material.has_inertia())
      complete(result.state, result.closed_nodes);
    else
      {
        if (body.scene.linear_solver.has_matrices() &&
            contact_stiffness_.empty())
          contact_stiffness_ = contact_stiffness(body);
        settle_contact_velocities(body,
                                  contact_stiffness_,
                                  result.closed_nodes,
                                  result.state);
      }
    set_exchange_of_law(body, result.state);
  }



  template <int dim>
  void
  Reset<dim>::set_pressures_of_velocity(State &state)
  {
    if (body.law().damping() == 0.)
      return;
    if (body.scene.material.has_inertia())
      set_pressures_of_law(body, state);
    else
      complete(state);
    set_exchange_of_law(body, state);
  }



  template <int dim>
  bool
  Reset<dim>::remove_pull(const int held_at, State &state) const
  {
    get_node_laws(body, state, node_laws, node_positions);
    bool changed = false;
    for (unsigned int i = 0; i < node_laws.size(); ++i)
      {
        double &p = state.contact_pressure[i];
        if ((held_at != 0 ? held_at : node_laws[i].side) * p < 0.)
          {
            p       = 0.;
            changed = true;
          }
      }
    return changed;
  }



  template <int dim>
  void
  Reset<dim>::finish_pressure(const ContactMode            mode,
                              const EventLocator::Finding &finding,
                              StepResult                  &result)
  {
    const bool is_event = finding.kind == EventLocator::Finding::at_end;
    bool       changed =
      remove_pull(mode == ContactMode::closed ? finding.side : 0, result.state);
    if (is_event && mode == ContactMode::open && !body.law().is_rigid())
      {
        changed = true;
        set_pressures_of_law(body, result.state);
      }
    if (changed || (is_event && mode == ContactMode::closed))
      set_exchange_of_law(body, result.state);
    if (!changed)
      return;
    const double old_energy = result.energy.sum();
    result.energy           = body.energy.energy(result.state);
    result.numerical_dissipation += old_energy - result.energy.sum();
  }



  template class Reset<1>;
  template class Reset<2>;
  template class Reset<3>;
} // namespace ThermoContact
