// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/contact_equilibrium.h>
#include <thermocontact/time/contact_equilibrium_many.h>
#include <thermocontact/time/contact_node_problem.h>

#include <algorithm>
#include <vector>

namespace ThermoContact
{
  template <int dim>
  FullMatrix<double>
  contact_stiffness(const Body<dim> &body)
  {
    Vector unit = body.discretization.make_vector(Field::displacement);
    Vector force(unit);
    return body.contact_end().all_response_matrix([&](const unsigned int node)
                                                    -> const Vector & {
      std::vector<double> unit_value(body.contact_end().n_all_nodes(), 0.);
      unit_value[node] = 1.;
      unit             = 0.;
      body.contact_end().set_all_values(Field::displacement, unit_value, unit);
      body.equations.stiffness().vmult(force, unit);
      return force;
    });
  }



  template <int dim>
  FullMatrix<double>
  contact_receptance(const ContactEnd<dim>    &end,
                     const FullMatrix<double> &flexibility)
  {
    FullMatrix<double> receptance(end.n_all_nodes(), end.n_nodes());
    for (unsigned int i = 0; i < receptance.m(); ++i)
      for (unsigned int j = 0; j < receptance.n(); ++j)
        receptance(i, j) = flexibility(i, j) * end.nodes()[j].weight;
    return receptance;
  }



  FullMatrix<double>
  between_pressures(const FullMatrix<double> &receptance)
  {
    FullMatrix<double> square(receptance.n(), receptance.n());
    square.fill(receptance);
    return square;
  }



  namespace
  {
    /** Values of all nodes plus the displacement by forces on them. */
    template <int dim>
    std::vector<double>
    moved_by_force(const ContactEnd<dim>    &end,
                   const FullMatrix<double> &flexibility,
                   const Vector             &force,
                   const Vector             &field)
    {
      std::vector<double> forces, moved;
      end.get_all_values(Field::displacement, force, forces);
      end.get_all_values(Field::displacement, field, moved);
      for (unsigned int i = 0; i < moved.size(); ++i)
        for (unsigned int j = 0; j < moved.size(); ++j)
          moved[i] += flexibility(i, j) * forces[j];
      return moved;
    }
  } // namespace



  std::vector<double>
  before_obstacle(const std::vector<double> &gap,
                  const std::vector<double> &displacement)
  {
    std::vector<double> penetration(displacement);
    for (unsigned int i = 0; i < gap.size(); ++i)
      penetration[i] -= gap[i];
    return penetration;
  }



  namespace
  {
    /**
     * Forces on the body without pressures, as contact nodes that have no mass
     * feel them.
     *
     * @param velocity of their viscous stress; null: they have none
     */
    template <int dim>
    Vector
    forces_on_nodes(Body<dim>    &body,
                    const State  &state,
                    const Vector *velocity = nullptr)
    {
      const Discretization<dim> &space = body.discretization;
      Vector heat_load                 = space.make_vector(Field::temperature);
      Vector load                      = space.make_vector(Field::displacement);
      Vector forces(load);
      body.loads.assemble(state.time, heat_load, load);
      body.equations.momentum_residual(
        state.temperature, state.displacement, velocity, nullptr, load, forces);
      body.equations.zero_constrained(Field::displacement, forces);
      return forces;
    }
  } // namespace



  template <int dim>
  void
  settle_contact_nodes(Body<dim> &body, State &state)
  {
    const ContactEnd<dim> &end   = body.contact_end();
    Vector                 force = forces_on_nodes(body, state);
    if constexpr (dim > 1)
      if (!body.scene.linear_solver.has_matrices())
        {
          std::vector<double> load, rate_load;
          end.get_all_values(Field::displacement, force, load);
          body.equations.stiffness().vmult(force, state.velocity);
          force *= -1.;
          end.get_all_values(Field::displacement, force, rate_load);
          settle_many_nodes(body, load, rate_load, state);
          return;
        }
    FullMatrix<double> flexibility = contact_stiffness(body);
    flexibility.gauss_jordan();
    const FullMatrix<double>  receptance = contact_receptance(end, flexibility);
    const std::vector<double> s =
      moved_by_force(end, flexibility, force, state.displacement);
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state.gap, s, laws, position);
    std::vector<double>     &p      = state.contact_pressure;
    const FullMatrix<double> square = between_pressures(receptance);
    InterfaceProblem         problem;
    problem.solve(square, laws, position, p);

    body.equations.stiffness().vmult(force, state.velocity);
    force *= -1.;
    const std::vector<double> s_rate =
      moved_by_force(end, flexibility, force, state.velocity);
    const std::vector<double> p_rate =
      change_of_pressure(square,
                         problem.slopes(),
                         before_obstacle(state.gap_rate, s_rate));
    for (const auto &[node, entry] : end.all_entries(Field::displacement))
      {
        double displacement = s[node], velocity = s_rate[node];
        for (unsigned int j = 0; j < p.size(); ++j)
          {
            displacement -= receptance(node, j) * p[j];
            velocity -= receptance(node, j) * p_rate[j];
          }
        if (node < p.size() && p[node] != 0.)
          {
            displacement = displacement_of_law(body, state, node);
            velocity =
              state.gap_rate[node] + body.law().tangent(p[node]) * p_rate[node];
          }
        state.displacement.begin()[entry] = displacement;
        state.velocity.begin()[entry]     = velocity;
      }
  }



  template <int dim>
  Vector
  move_contact_nodes(Body<dim> &body, State &state)
  {
    const ContactEnd<dim> &end = body.contact_end();
    Vector                 way(state.displacement);
    if constexpr (dim > 1)
      {
        std::vector<double> load, displacement;
        end.get_all_values(Field::displacement,
                           forces_on_nodes(body, state),
                           load);
        end.get_all_values(Field::displacement,
                           state.displacement,
                           displacement);
        std::vector<double>     pressure(state.contact_pressure), position;
        std::vector<NodeLaw>    laws;
        ContactNodeProblem<dim> problem(body, 1., true);
        get_node_laws(body, state.gap, displacement, laws, position);
        const std::vector<double> change =
          problem.solve(load, laws, position, pressure);
        if (body.equations.is_coupled())
          state.temperature += problem.heating(change);
      }
    settle_contact_nodes(body, state); // to rounding, with velocities
    way.sadd(-1., 1., state.displacement);
    return way;
  }



  template <int dim>
  void
  settle_contact_velocities(Body<dim>                &body,
                            const FullMatrix<double> &stiffness,
                            const std::vector<bool>  &is_closed,
                            State                    &state)
  {
    const ContactEnd<dim> &end  = body.contact_end();
    const double           zeta = body.scene.material.viscosity;
    Vector force                = forces_on_nodes(body, state, &state.velocity);
    if constexpr (dim > 1)
      if (!body.scene.linear_solver.has_matrices())
        {
          std::vector<double> load;
          end.get_all_values(Field::displacement, force, load);
          settle_many_velocities(body, load, is_closed, state);
          return;
        }

    FullMatrix<double> flexibility(stiffness);
    flexibility *= zeta;
    flexibility.gauss_jordan();
    const FullMatrix<double>  receptance = contact_receptance(end, flexibility);
    const std::vector<double> free =
      moved_by_force(end, flexibility, force, state.velocity);

    std::vector<NodeLaw> laws;
    get_velocity_laws(body, state, is_closed, laws);
    std::fill(state.contact_pressure.begin(), state.contact_pressure.end(), 0.);
    InterfaceProblem().solve(between_pressures(receptance),
                             laws,
                             before_obstacle(state.gap_rate, free),
                             state.contact_pressure);
    std::vector<double> velocity(free);
    for (unsigned int i = 0; i < velocity.size(); ++i)
      for (unsigned int j = 0; j < state.contact_pressure.size(); ++j)
        velocity[i] -= receptance(i, j) * state.contact_pressure[j];
    end.set_all_values(Field::displacement, velocity, state.velocity);
  }



#define INSTANTIATE(dim)                                                     \
  template FullMatrix<double> contact_stiffness<dim>(const Body<dim> &);     \
  template FullMatrix<double> contact_receptance<dim>(                       \
    const ContactEnd<dim> &, const FullMatrix<double> &);                    \
  template void   settle_contact_nodes<dim>(Body<dim> &, State &);           \
  template Vector move_contact_nodes<dim>(Body<dim> &, State &);             \
  template void   settle_contact_velocities<dim>(Body<dim> &,                \
                                               const FullMatrix<double> &, \
                                               const std::vector<bool> &,  \
                                               State &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
