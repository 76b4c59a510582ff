// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/simulation/exchange_of_law.h>
#include <thermocontact/simulation/reset.h>
#include <thermocontact/space/node_laws.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** Of a static body that is moved at once, whose coefficients depend on the
     * temperature. */
    constexpr unsigned int max_iterations_of_heating = 30;



    /** The given nodes, else all nodes that do not lie before the obstacle.
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
                        std::vector<bool>(body.contact_end().n_nodes(), true),
                        laws);
      for (NodeLaw &law : laws)
        law.is_held = true;
      return laws;
    }
  } // namespace



  template <int dim>
  Reset<dim>::Reset(Body<dim> &body)
    : body(body)
    , inertia(body, motion_by_inertia, counters_)
    , stiffness(body, motion_without_inertia(body), counters_)
    , at_once(body,
              body.equations.is_coupled() ? motion_at_once :
                                            motion_without_inertia(body),
              counters_)
    , static_nodes(body, motion_without_heat, counters_, Rows::contact_end)
    , adiabatic_nodes(body, motion_at_once, counters_, Rows::contact_end)
    , viscous_nodes(body, motion_by_viscosity, counters_, Rows::contact_end)
  {}



  template <int dim>
  std::vector<bool>
  Reset<dim>::retained() const
  {
    return {inertia.is_provided(),
            stiffness.is_provided(),
            heat_mass != nullptr,
            adiabatic_nodes.is_provided(),
            at_once.is_provided(),
            viscous_nodes.is_provided()};
  }



  template <int dim>
  void
  Reset<dim>::restore(const std::vector<bool> &retained,
                      const SolverCounters    &counters)
  {
    if (retained[0])
      inertia.provide();
    if (retained[1])
      stiffness.provide();
    if (retained[2])
      provide_heat_mass();
    if (retained[3])
      adiabatic_nodes.provide();
    if (retained[4])
      at_once.provide();
    if (retained[5])
      viscous_nodes.provide();
    counters_ = counters;
  }



  template <int dim>
  LinearSystem<dim> &
  Reset<dim>::provide_heat_mass()
  {
    if (!heat_mass)
      {
        heat_mass =
          std::make_unique<LinearSystem<dim>>(body.equations, heat_at_once);
        counters_.factorizations += heat_mass->n_factorizations();
      }
    return *heat_mass;
  }



  template <int dim>
  void
  Reset<dim>::book(const double work, StepResult &result) const
  {
    const double old_energy = result.energy.sum();
    result.energy           = body.energy.energy(result.state);
    result.work += work;
    result.numerical_dissipation += old_energy + work - result.energy.sum();
  }



  template <int dim>
  void
  Reset<dim>::book_boundaries(const Vector &old_temperature,
                              const Vector &old_displacement,
                              StepResult   &result) const
  {
    if (body.boundary_flows.is_active())
      result.boundaries.add(1.,
                            body.boundary_flows.jump(old_temperature,
                                                     old_displacement,
                                                     result.state));
  }



  template <int dim>
  template <class Motion>
  double
  Reset<dim>::work_of(StepResult &result, const Motion &move) const
  {
    State       &state = result.state;
    const Vector old_temperature(state.temperature);
    const Vector old_displacement(state.displacement);
    Vector       before_and_after = nonlinear_forces(state, nullptr);
    move();
    book_boundaries(old_temperature, old_displacement, result);
    Vector change(state.displacement);
    change -= old_displacement;
    before_and_after += nonlinear_forces(state, nullptr);
    return body.energy.work_of_motion(momentum_load(state.load_time),
                                      state,
                                      change) +
           0.5 * (before_and_after * change) /
             body.discretization.geometry().cross_section();
  }



  template <int dim>
  Vector
  Reset<dim>::momentum_load(const double time) const
  {
    Vector heat = body.discretization.make_vector(Field::temperature);
    Vector load = body.discretization.make_vector(Field::displacement);
    body.loads.assemble(time, heat, load);
    return load;
  }



  template <int dim>
  Vector
  Reset<dim>::nonlinear_forces(const State &state, const Vector *velocity) const
  {
    Vector forces = body.discretization.make_vector(Field::displacement);
    if (!body.nonlinear)
      return forces;
    Vector unused = body.discretization.make_vector(Field::temperature);
    Rates  rates;
    if (velocity != nullptr)
      rates.velocity = *velocity;
    body.nonlinear->subtract(state, rates, unused, forces);
    return forces;
  }



  template <int dim>
  Vector
  Reset<dim>::forces(const State  &state,
                     const Vector &momentum_load,
                     const Vector *velocity) const
  {
    Vector forces(momentum_load);
    body.equations.momentum_residual(
      state, velocity, nullptr, momentum_load, forces);
    if (body.nonlinear)
      forces += nonlinear_forces(state, velocity);
    body.equations.zero_constrained(Field::displacement, forces);
    return forces;
  }



  template <int dim>
  Vector
  Reset<dim>::rows_of_end(const Vector &rows) const
  {
    Vector result = body.discretization.make_vector(Field::displacement);
    for (const auto &[node, entry] :
         body.contact_end().all_entries(Field::displacement))
      result.begin()[entry] = rows.begin()[entry];
    return result;
  }



  template <int dim>
  Vector
  Reset<dim>::node_forces(const State &state, const Vector *velocity) const
  {
    return rows_of_end(forces(state, momentum_load(state.load_time), velocity));
  }



  template <int dim>
  std::vector<double>
  Reset<dim>::relative_velocities(const State                &state,
                                  const std::vector<NodeLaw> &laws) const
  {
    std::vector<double> velocity;
    body.contact_end().get_values(Field::displacement,
                                  state.velocity,
                                  velocity);
    for (unsigned int i = 0; i < laws.size(); ++i)
      velocity[i] -= laws[i].local_rate();
    return velocity;
  }



  template <int dim>
  void
  Reset<dim>::set_velocity_of_viscous_body(const std::vector<bool> &is_closed,
                                           State                   &state,
                                           const bool               touches)
  {
    const double factor = velocity_factor(body);
    Vector       load   = momentum_load(state.load_time);
    Vector       of_end = body.discretization.make_vector(Field::displacement);
    body.driven_end.set_velocity(state.load_time, of_end);

    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    const SceneContact  &contact = body.scene.contact;
    // of elastic contacts, which follow from the displacement alone
    std::vector<double> elastic(state.contact.pressure.size(), 0.);
    if (contact.has_rigid())
      {
        get_velocity_laws(body,
                          state,
                          closed_nodes(body, state, is_closed),
                          laws);
        for (unsigned int i = 0; i < laws.size(); ++i)
          if (!contact.law_at(i).is_rigid())
            {
              laws[i].law = nullptr;
              elastic[i]  = state.contact.pressure[i];
            }
        std::fill(state.contact.pressure.begin(),
                  state.contact.pressure.end(),
                  0.);
        if (contact.has_rigid_beside_elastic())
          body.contact_end().subtract_load(Field::displacement,
                                           elastic,
                                           1.,
                                           load);
      }
    else if (contact.is_damped())
      {
        get_node_laws(body, state, laws, position);
        for (unsigned int i = 0; i < laws.size(); ++i)
          {
            laws[i].is_in_velocity = true; // of nodes that stay where they are
            laws[i].start          = position[i];
            if (touches)
              laws[i].start = laws[i].without_pull(position[i]);
          }
      }
    else
      body.contact_end().subtract_load(Field::displacement,
                                       state.contact.pressure,
                                       1.,
                                       load);
    position.clear();
    for (const NodeLaw &law : laws)
      position.push_back(0. - law.local_rate());
    const Vector r =
      forces(state,
             load,
             body.scene.sources.has_moving_end ? &of_end : nullptr);
    stiffness.linearize(state);
    stiffness.solve(
      r, laws, position, factor, state.velocity, state.contact.pressure);
    if (contact.has_rigid_beside_elastic())
      for (unsigned int i = 0; i < elastic.size(); ++i)
        if (!contact.law_at(i).is_rigid())
          state.contact.pressure[i] = elastic[i];
    state.velocity *= factor;
    body.driven_end.set_velocity(state.load_time, state.velocity);
  }



  template <int dim>
  void
  Reset<dim>::set_static_displacement(Equilibrium<dim> &matrix, State &state)
  {
    const Vector         r = forces(state, momentum_load(state.load_time));
    Vector               change(state.displacement);
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    matrix.linearize(state);
    matrix.solve(r, laws, position, 1., change, state.contact.pressure);
    state.displacement += change;
  }



  template <int dim>
  void
  Reset<dim>::complete(State &state)
  {
    const Material &material = body.scene.material;
    if (!body.scene.fields.has_displacement)
      return;
    if (material.has_inertia() || material.is_static())
      set_static_equilibrium(state);
    else
      set_velocity_of_viscous_body({}, state);
  }



  template <int dim>
  void
  Reset<dim>::set_static_equilibrium(State                           &state,
                                     const std::vector<unsigned int> &closing)
  {
    if (body.scene.material.is_static())
      set_static_displacement(stiffness, state);
    else if (body.scene.contact.is_in_equilibrium())
      settle_static_nodes(state, closing);
  }



  template <int dim>
  Vector
  Reset<dim>::rate_of_forces(const State &state)
  {
    Vector rate(state.velocity), elastic(rate);
    body.loads.assemble_momentum_rate(state.load_time, rate);
    body.equations.stiffness.vmult(elastic, state.velocity);
    rate -= elastic;
    // heat that has not flowed yet may have a rate that the mesh alone makes
    if (body.scene.fields.has_temperature &&
        body.scene.material.has_thermal_stress() && !state.was_moved_at_once())
      {
        Vector heat = body.discretization.make_vector(Field::temperature);
        Vector load = body.discretization.make_vector(Field::displacement);
        body.loads.assemble(state.load_time, heat, load);
        Vector right(heat), unused(load);
        body.equations.stage_rhs(state, 0., heat, load, right, unused);
        body.equations.add_heating(state.velocity, -1., right);
        if (!body.scene.heat.exchange->is_in_matrices())
          {
            std::vector<double> flux;
            body.contact_end().get_values(Field::temperature,
                                          state.temperature,
                                          flux);
            body.surroundings.to_fluxes(state, flux);
            body.contact_end().subtract_load(Field::temperature,
                                             flux,
                                             1.,
                                             right);
          }
        provide_heat_mass().solve(heat, right);
        body.equations.add_thermal_stress(heat, 1., rate);
      }
    return rate;
  }



  template <int dim>
  void
  Reset<dim>::settle_static_nodes(State                           &state,
                                  const std::vector<unsigned int> &closing)
  {
    std::vector<double> &p = state.contact.pressure;
    Vector change = body.discretization.make_vector(Field::displacement),
           acceleration(change);
    get_node_laws(body, state, node_laws, node_positions);
    static_nodes.solve(
      node_forces(state), node_laws, node_positions, 1., change, p);

    for (unsigned int i = 0; i < p.size(); ++i)
      node_laws[i].face_pressure(p[i]); // it may have gone to the other side
    static_nodes.solve_rates(rows_of_end(rate_of_forces(state)),
                             relative_velocities(state, node_laws),
                             node_laws,
                             closing,
                             acceleration);

    for (const auto &[i, entry] :
         body.contact_end().all_entries(Field::displacement))
      {
        double &displacement = state.displacement.begin()[entry];
        // where there is pressure, the law is exact to rounding of u
        displacement = i < p.size() && p[i] != 0. ?
                         displacement_of_law(body, state, i) :
                         displacement + change.begin()[entry];
        state.velocity.begin()[entry] += acceleration.begin()[entry];
      }
  }



  template <int dim>
  void
  Reset<dim>::settle_viscous_nodes(const std::vector<bool> &is_closed,
                                   State                   &state)
  {
    std::vector<double> &p = state.contact.pressure;
    Vector change = body.discretization.make_vector(Field::displacement);
    get_velocity_laws(body, state, is_closed, node_laws);
    for (unsigned int i = 0; i < p.size(); ++i)
      p[i] = is_closed[i] ? node_laws[i].without_pull(p[i]) : 0.;
    viscous_nodes.solve(node_forces(state, &state.velocity),
                        node_laws,
                        relative_velocities(state, node_laws),
                        1.,
                        change,
                        p);
    for (const auto &[i, entry] :
         body.contact_end().all_entries(Field::displacement))
      {
        double &velocity = state.velocity.begin()[entry];
        velocity         = i < p.size() && p[i] != 0. ?
                             node_laws[i].local_rate() :
                             velocity + change.begin()[entry];
      }
  }



  template <int dim>
  void
  Reset<dim>::move_static_nodes(State &state)
  {
    std::vector<double> pressure(state.contact.pressure);
    Vector change = body.discretization.make_vector(Field::displacement);
    get_node_laws(body, state, node_laws, node_positions);
    adiabatic_nodes.solve(
      node_forces(state), node_laws, node_positions, 1., change, pressure);
    adiabatic_nodes.add_heating(change, state.temperature);
    settle_static_nodes(state); // to rounding, with velocities
    set_exchange_of_law(body, state);
  }



  template <int dim>
  void
  Reset<dim>::move_static_body(State &state)
  {
    const Vector old_displacement(state.displacement);
    const Vector start(state.temperature);
    Vector       heat = body.discretization.make_vector(Field::temperature);
    Vector       change(heat), last(heat);
    for (unsigned int n = 0;; ++n)
      {
        if (n == max_iterations_of_heating)
          throw ComputationError(
            text("a static body that is moved at once, with coefficients of "
                 "the temperature: its heat did not settle in ",
                 n,
                 " iterations"));
        set_static_displacement(at_once, state);
        if (!body.equations.is_coupled())
          break;
        Vector motion(state.displacement);
        motion -= old_displacement;
        heat = 0.;
        last = change;
        if (body.nonlinear)
          {
            // heated with the coefficients in the middle of the way
            Vector middle(start);
            middle.add(0.5, change);
            const auto there = body.nonlinear->at(middle);
            there->add_heating(motion, -1., heat);
            LinearSystem<dim>(*there, heat_at_once).solve(change, heat);
          }
        else
          {
            body.equations.add_heating(motion, -1., heat);
            provide_heat_mass().solve(change, heat);
          }
        state.temperature = start;
        state.temperature += change;
        last -= change;
        if (!body.nonlinear ||
            last.linfty_norm() <= Tolerances::rounding_of_solution *
                                    state.temperature.linfty_norm())
          break;
      }
    state.velocity = 0.; // a motion at once has none
    set_exchange_of_law(body, state);
  }



  template <int dim>
  double
  Reset<dim>::set_temperature_of_fixed_end(const double temperature,
                                           State       &state)
  {
    const auto &entries =
      body.discretization.constrained_entries(Field::temperature);
    Vector     change = body.discretization.make_vector(Field::temperature);
    Vector     heat(change), inside(change);
    const auto given = [&](const unsigned int entry) {
      return body.discretization.is_right_end(entry) ?
               *body.scene.heat.right_temperature :
               temperature;
    };
    for (const unsigned int entry : entries)
      change.begin()[entry] = given(entry) - state.temperature.begin()[entry];
    body.equations.heat_mass.vmult(heat, change);
    heat *= -1.;
    body.equations.zero_constrained(Field::temperature, heat);
    provide_heat_mass().solve(inside, heat);
    change += inside;

    // the temperature rises evenly while the heat comes in
    Vector excess(state.temperature);
    excess -= body.energy.steady_profile();
    excess.add(0.5, change);
    state.temperature += change;
    body.equations.heat_mass.vmult(heat, change);
    double work = 0.;
    for (const unsigned int entry : entries)
      {
        work += heat.begin()[entry] * excess.begin()[entry];
        state.temperature.begin()[entry] = given(entry);
      }
    return Utilities::MPI::sum(work, body.discretization.communicator()) /
           body.discretization.geometry().cross_section();
  }



  template <int dim>
  bool
  Reset<dim>::moves_at_once() const
  {
    return body.scene.fields.has_displacement &&
           (!body.scene.material.has_inertia() ||
            body.scene.contact.is_in_equilibrium());
  }



  template <int dim>
  bool
  Reset<dim>::pass_discontinuity(const std::vector<bool> &is_closed,
                                 const LoadBreak         &at,
                                 StepResult              &result)
  {
    const bool moves = moves_at_once() && (at.jumping & force) != 0;
    if (moves)
      move_at_once(is_closed, 0., result);
    return moves;
  }



  template <int dim>
  bool
  Reset<dim>::heat_fixed_end(const std::vector<bool> &is_closed,
                             const LoadBreak *const   at,
                             StepResult              &result)
  {
    const SceneHeat &heat  = body.scene.heat;
    State           &state = result.state;
    const bool       starts =
      state.time == 0. &&
      body.discretization.largest_constrained(Field::temperature,
                                              state.temperature,
                                              heat.fixed_end_temperature,
                                              heat.right_temperature.value_or(
                                                0.)) > 0.;
    const bool jumps =
      at != nullptr && (at->jumping & fixed_end_temperature) != 0;
    const Vector old_temperature(state.temperature);
    if (starts)
      set_temperature_of_fixed_end(heat.fixed_end_temperature, state);
    const double work =
      jumps ?
        set_temperature_of_fixed_end(heat.fixed_end_drive->value(at->new_time),
                                     state) :
        0.;
    if (!starts && !jumps)
      return false;
    book_boundaries(old_temperature, state.displacement, result);
    move_at_once(is_closed, work, result);
    return true;
  }



  template <int dim>
  void
  Reset<dim>::move_at_once(const std::vector<bool> &is_closed,
                           double                   work,
                           StepResult              &result)
  {
    const Scene &scene = body.scene;
    State       &state = result.state;
    const bool   moves = moves_at_once();
    state.jump_time    = state.time;
    if (moves && scene.material.is_static())
      work += work_of(result, [&]() { move_static_body(state); });
    else if (moves && scene.contact.is_in_equilibrium())
      work += work_of(result, [&]() { move_static_nodes(state); });
    else
      {
        if (moves)
          set_velocity_of_viscous_body(is_closed, state);
        set_exchange_of_law(body, state);
      }
    book(work, result);
  }



  template <int dim>
  void
  Reset<dim>::impact(StepResult &result)
  {
    const ContactEnd<dim> &end   = body.contact_end();
    State                 &state = result.state;
    double                 work  = 0.;
    if (body.scene.contact.has_mass())
      {
        const std::vector<NodeLaw> laws = held_laws(body, state);
        std::vector<double>        impulses;
        Vector                     change(state.velocity);
        inertia.solve(body.discretization.make_vector(Field::displacement),
                      laws,
                      relative_velocities(state, laws),
                      1.,
                      change,
                      impulses);
        state.velocity += change;
        if (body.boundary_flows.is_active())
          result.boundaries.add(1.,
                                body.boundary_flows.impact(change,
                                                           state.velocity));
        for (unsigned int i = 0; i < impulses.size(); ++i)
          work -= end.share(i) * impulses[i] * laws[i].local_rate();
        result.add_impulse(1., impulses, body);
      }
    put_on_obstacle(body, state);
    if (!body.scene.material.has_inertia())
      set_velocity_of_viscous_body(
        std::vector<bool>(body.contact_end().n_nodes(), true), state);
    set_exchange_of_law(body, state);
    book(work, result);
  }



  template <int dim>
  void
  Reset<dim>::complete_step(const ContactMode mode, StepResult &result)
  {
    if (!body.obstacle.is_active() || !body.scene.contact.has_impacts())
      return;
    // impacts take the velocity of the obstacle, not that of the last stage
    body.obstacle.set_rates(result.state.load_time, result.state);
    if (mode != ContactMode::closed)
      return;
    put_on_obstacle(body, result.state); // where they are but for rounding
    // the audit of a scheme of first order has the pressure of its stage
    if (!body.scene.sources.has_moving_end && body.scene.scheme.order > 1)
      set_pressures_of_acceleration(result.state);
  }



  template <int dim>
  void
  Reset<dim>::set_pressures_of_acceleration(State &state)
  {
    const Vector r =
      forces(state, momentum_load(state.load_time), &state.velocity);
    Vector                       acceleration(r);
    const std::vector<NodeLaw>   laws = held_laws(body, state);
    std::vector<double>          relative;
    std::vector<TimeDerivatives> obstacle;
    body.obstacle.get_derivatives(state.load_time, obstacle);
    for (unsigned int i = 0; i < obstacle.size(); ++i)
      relative.push_back(0. - laws[i].of_local(obstacle[i].second));
    inertia.solve(r, laws, relative, 1., acceleration, state.contact.pressure);
    ++counters_.solves;
    set_exchange_of_law(body, state);
  }



  template <int dim>
  void
  Reset<dim>::settle_velocities(const std::vector<bool> &is_closed,
                                State                   &state)
  {
    const bool is_damped = body.scene.contact.is_damped();
    const bool is_viscous_at_rigid =
      body.scene.contact.has_rigid() &&
      body.scene.contact.order == NodeOrder::viscous;
    if ((!is_damped && !is_viscous_at_rigid) || body.scene.has_midpoint_mass)
      return; // waves give the end its velocity
    if (!body.scene.material.has_inertia())
      set_velocity_of_viscous_body(is_closed, state);
    else if (is_damped)
      set_pressures_of_law(body, state);
    else
      settle_viscous_nodes(is_closed, state);
    set_exchange_of_law(body, state);
  }



  template <int dim>
  bool
  Reset<dim>::remove_pull(const std::optional<int> held_at, State &state) const
  {
    get_node_laws(body, state, node_laws, node_positions);
    bool changed = false;
    for (unsigned int i = 0; i < node_laws.size(); ++i)
      {
        double &p = state.contact.pressure[i];
        if (held_at)
          node_laws[i].face(*held_at, 0.);
        const double push = node_laws[i].without_pull(p);
        changed |= push != p;
        p = push;
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
    State     &state    = result.state;
    bool       changed  = remove_pull(mode == ContactMode::closed ?
                                 std::optional<int>(finding.obstacle) :
                                 std::nullopt,
                               state);
    double work = 0.;
    if (is_event && body.scene.contact.is_in_equilibrium() &&
        !body.scene.contact.is_damped()) // damping presses by velocities, too
      {
        changed = true;
        std::vector<unsigned int>
          closing; // other nodes in contact have pressure
        if (mode == ContactMode::open)
          for (unsigned int i = 0; i < state.contact.pressure.size(); ++i)
            if (finding.changes_all_nodes || i == finding.node)
              closing.push_back(i);
        work =
          work_of(result, [&]() { set_static_equilibrium(state, closing); });
      }
    else if (is_event && mode == ContactMode::open && !body.law().is_rigid())
      {
        changed = true;
        // a dashpot pushes at once
        const bool is_held =
          body.scene.contact.law_at(finding.node, finding.obstacle).dashpot() >
            0. &&
          finding.changes_all_nodes;
        if (is_held && !body.scene.material.has_inertia())
          set_velocity_of_viscous_body({}, state, is_held);
        else
          set_pressures_of_law(body, state, is_held);
      }
    if (changed || (is_event && mode == ContactMode::closed))
      set_exchange_of_law(body, state);
    if (changed)
      book(work, result);
  }



  template class Reset<1>;
  template class Reset<2>;
  template class Reset<3>;
} // namespace ThermoContact
