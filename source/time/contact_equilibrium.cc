// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/contact_solver.h>
#include <thermocontact/time/contact_equilibrium.h>

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
    return body.contact_end().response_matrix(
      [&](const unsigned int node) -> const Vector & {
        std::vector<double> unit_value(body.contact_end().n_nodes(), 0.);
        unit_value[node] = 1.;
        unit             = 0.;
        body.contact_end().set_values(Field::displacement, unit_value, unit);
        body.equations.stiffness().vmult(force, unit);
        return force;
      });
  }



  template <int dim>
  FullMatrix<double>
  contact_receptance(const ContactEnd<dim>    &end,
                     const FullMatrix<double> &stiffness)
  {
    FullMatrix<double> receptance(stiffness);
    receptance.gauss_jordan();
    for (unsigned int i = 0; i < receptance.m(); ++i)
      for (unsigned int j = 0; j < receptance.n(); ++j)
        receptance(i, j) *= end.nodes()[j].weight;
    return receptance;
  }



  namespace
  {
    /** Values of the nodes plus the displacement by forces on them. */
    template <int dim>
    std::vector<double>
    moved_by_force(const ContactEnd<dim>    &end,
                   const FullMatrix<double> &receptance,
                   const Vector             &force,
                   const Vector             &field)
    {
      std::vector<double> forces, moved;
      end.get_values(Field::displacement, force, forces);
      end.get_values(Field::displacement, field, moved);
      for (unsigned int i = 0; i < moved.size(); ++i)
        for (unsigned int j = 0; j < moved.size(); ++j)
          moved[i] += receptance(i, j) * forces[j] / end.nodes()[j].weight;
      return moved;
    }
  } // namespace



  template <int dim>
  void
  settle_contact_nodes(Body<dim> &body, State &state)
  {
    const ContactEnd<dim>   &end = body.contact_end();
    const FullMatrix<double> receptance =
      contact_receptance(end, contact_stiffness(body));
    const Discretization<dim> &space = body.discretization;
    Vector heat_load                 = space.make_vector(Field::temperature);
    Vector momentum_load             = space.make_vector(Field::displacement);
    Vector heat_rhs(heat_load), force(momentum_load);
    body.loads.assemble(state.time, heat_load, momentum_load);

    // The nodes have no mass, so that a stage of length 1 has the forces on
    // them on its right-hand side.
    body.equations.stage_rhs(
      state, 1., heat_load, momentum_load, heat_rhs, force);
    const std::vector<double> s =
      moved_by_force(end, receptance, force, state.displacement);
    std::vector<double> free_penetration(s);
    for (unsigned int i = 0; i < s.size(); ++i)
      free_penetration[i] -= end.nodes()[i].gap;
    std::vector<double> &p = state.contact_pressure;
    ContactSolver(body.law()).solve(receptance, free_penetration, p);

    body.equations.stiffness().vmult(force, state.velocity);
    force *= -1.;
    const std::vector<double> s_rate =
      moved_by_force(end, receptance, force, state.velocity);
    for (const auto &[node, entry] : end.entries(Field::displacement))
      {
        // where there is pressure, the law is exact to rounding of u
        double displacement = s[node], velocity = s_rate[node];
        for (unsigned int j = 0; j < p.size(); ++j)
          displacement -= receptance(node, j) * p[j];
        if (p[node] > 0.)
          {
            const double tangent = body.law().tangent(p[node]);
            displacement =
              end.nodes()[node].gap + body.law().penetration(p[node]);
            velocity *= tangent / (tangent + receptance(node, node));
          }
        state.displacement.begin()[entry] = displacement;
        state.velocity.begin()[entry]     = velocity;
      }
  }



  template <int dim>
  void
  settle_contact_velocities(Body<dim>                &body,
                            const FullMatrix<double> &stiffness,
                            const std::vector<bool>  &is_closed,
                            State                    &state)
  {
    const ContactEnd<dim>     &end   = body.contact_end();
    const Discretization<dim> &space = body.discretization;
    const double               zeta  = body.scene.material.viscosity;
    FullMatrix<double>         viscous_stiffness(stiffness);
    viscous_stiffness *= zeta;
    const FullMatrix<double> receptance =
      contact_receptance(end, viscous_stiffness);

    Vector heat_load     = space.make_vector(Field::temperature);
    Vector momentum_load = space.make_vector(Field::displacement);
    Vector heat_rhs(heat_load), force(momentum_load), viscous(momentum_load);
    body.loads.assemble(state.time, heat_load, momentum_load);
    body.equations.stage_rhs(
      state, 1., heat_load, momentum_load, heat_rhs, force);
    body.equations.stiffness().vmult(viscous, state.velocity);
    force.add(-zeta, viscous);
    const std::vector<double> free =
      moved_by_force(end, receptance, force, state.velocity);

    std::vector<unsigned int> nodes;
    for (unsigned int i = 0; i < is_closed.size(); ++i)
      if (is_closed[i])
        nodes.push_back(i);
    const unsigned int  n = nodes.size();
    FullMatrix<double>  response(n, n);
    std::vector<double> free_velocity(n), p(n);
    response.extract_submatrix_from(receptance, nodes, nodes);
    for (unsigned int i = 0; i < n; ++i)
      {
        free_velocity[i] = free[nodes[i]];
        p[i]             = state.contact_pressure[nodes[i]];
      }
    ContactSolver(body.law()).solve(response, free_velocity, p);

    std::fill(state.contact_pressure.begin(), state.contact_pressure.end(), 0.);
    for (unsigned int i = 0; i < n; ++i)
      state.contact_pressure[nodes[i]] = p[i];
    std::vector<double> velocity(free);
    for (unsigned int i = 0; i < velocity.size(); ++i)
      for (unsigned int j = 0; j < velocity.size(); ++j)
        velocity[i] -= receptance(i, j) * state.contact_pressure[j];
    end.set_values(Field::displacement, velocity, state.velocity);
  }



#define INSTANTIATE(dim)                                                   \
  template FullMatrix<double> contact_stiffness<dim>(const Body<dim> &);   \
  template FullMatrix<double> contact_receptance<dim>(                     \
    const ContactEnd<dim> &, const FullMatrix<double> &);                  \
  template void settle_contact_nodes<dim>(Body<dim> &, State &);           \
  template void settle_contact_velocities<dim>(Body<dim> &,                \
                                               const FullMatrix<double> &, \
                                               const std::vector<bool> &,  \
                                               State &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
