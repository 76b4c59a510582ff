// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/quasi_static_start.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/iterative_solver.h>

#include <algorithm>
#include <cmath>

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
  } // namespace



  template <int dim>
  QuasiStaticStart<dim>::QuasiStaticStart(Body<dim> &body)
    : body(body)
  {}



  template <int dim>
  void
  QuasiStaticStart<dim>::factorize()
  {
    if (factors || !body.scene.linear_solver.has_matrices())
      return;
    // Without inertia a stage of length 1 has the matrix (zeta + 1) S and, on
    // the right-hand side, the forces on the body.
    factors =
      std::make_unique<DirectSolver>(body.equations.momentum_stage_matrix(1.));
    ++counters_.factorizations;
    if (!body.law().is_active())
      return;
    const ContactEnd<dim> &end = body.contact_end();
    Vector unit_load = body.discretization.make_vector(Field::displacement);
    response =
      end.response_matrix([&](const unsigned int node) -> const Vector & {
        end.set_load_of_node(Field::displacement, node, 1., unit_load);
        Vector &unit_response = unit_responses.emplace_back(unit_load);
        factors->solve(unit_response, unit_load);
        ++counters_.responses;
        return unit_response;
      });
  }



  template <int dim>
  void
  QuasiStaticStart<dim>::add_contact(const std::vector<NodeLaw> &laws,
                                     const std::vector<double>  &free,
                                     const double                factor,
                                     Vector                     &w,
                                     std::vector<double>        &pressure)
  {
    if (!body.law().is_active())
      return;
    FullMatrix<double> receptance(response);
    receptance *= factor;
    InterfaceProblem().solve(receptance, laws, free, pressure);
    for (unsigned int i = 0; i < pressure.size(); ++i)
      w.add(-pressure[i], unit_responses[i]);
  }



  template <int dim>
  void
  QuasiStaticStart<dim>::solve_static(const Vector &load, State &state)
  {
    factors->solve(state.displacement, load);
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    add_contact(laws, position, 1., state.displacement, state.contact_pressure);
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
  QuasiStaticStart<dim>::solve_with_damping(const Vector &load, State &state)
  {
    // a stage of length 1 has the matrix (zeta + 1) S
    const double viscosity = body.scene.material.viscosity;
    const double factor    = viscosity / (viscosity + 1.);
    factors->solve(state.velocity, load);
    std::vector<NodeLaw> laws;
    std::vector<double>  position, velocity;
    get_node_laws(body, state, laws, position);
    body.contact_end().get_values(Field::displacement,
                                  state.velocity,
                                  velocity);
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        laws[i].is_in_velocity = true; // of nodes that stay where they are
        laws[i].start          = position[i];
        velocity[i]            = velocity[i] / factor -
                      (state.gap_rate.empty() ? 0. : state.gap_rate[i]);
      }
    add_contact(
      laws, velocity, 1. / factor, state.velocity, state.contact_pressure);
    state.velocity /= factor;
  }



  template <int dim>
  void
  QuasiStaticStart<dim>::solve_on_rigid(const std::vector<bool> &is_closed,
                                        const Vector            &load,
                                        State                   &state)
  {
    std::vector<NodeLaw> laws;
    get_velocity_laws(body, state, closed_nodes(body, state, is_closed), laws);
    std::fill(state.contact_pressure.begin(), state.contact_pressure.end(), 0.);
    factors->solve(state.velocity, load);
    std::vector<double> velocity;
    body.contact_end().get_values(Field::displacement,
                                  state.velocity,
                                  velocity);
    // velocities are scaled
    const double factor =
      body.scene.material.viscosity / (body.scene.material.viscosity + 1.);
    for (unsigned int i = 0; i < state.gap_rate.size(); ++i)
      velocity[i] -= factor * state.gap_rate[i];
    add_contact(laws, velocity, 1., state.velocity, state.contact_pressure);
  }



  template <int dim>
  void
  QuasiStaticStart<dim>::complete(State                   &state,
                                  const std::vector<bool> &is_closed)
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
    const Discretization<dim> &space = body.discretization;
    Vector heat_load                 = space.make_vector(Field::temperature);
    Vector momentum_load             = space.make_vector(Field::displacement);
    Vector heat_rhs(heat_load), rhs(momentum_load);
    body.loads.assemble(state.time, heat_load, momentum_load);

    factorize();
    const Material &material = body.scene.material;
    if (!material.is_static())
      body.driven_end.subtract_viscous_stress(state.time, momentum_load);
    body.equations.stage_rhs(
      state, 1., heat_load, momentum_load, heat_rhs, rhs);
    if (material.is_static())
      {
        solve_static(rhs, state);
        return;
      }

    if (body.law().damping() > 0.)
      {
        solve_with_damping(rhs, state);
        body.driven_end.set_velocity(state.time, state.velocity);
        return;
      }
    if (body.law().is_rigid())
      solve_on_rigid(is_closed, rhs, state);
    else
      {
        body.contact_end().subtract_load(Field::displacement,
                                         state.contact_pressure,
                                         1.,
                                         rhs);
        factors->solve(state.velocity, rhs);
      }
    state.velocity *= (material.viscosity + 1.) / material.viscosity;
    body.driven_end.set_velocity(state.time, state.velocity);
  }



  template class QuasiStaticStart<1>;
  template class QuasiStaticStart<2>;
  template class QuasiStaticStart<3>;
} // namespace ThermoContact
