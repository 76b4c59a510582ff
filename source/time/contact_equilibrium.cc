// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/contact_solver.h>
#include <thermocontact/time/contact_equilibrium.h>

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



  template <int dim>
  void
  settle_contact_nodes(Body<dim> &body, State &state)
  {
    const ContactEnd<dim> &end         = body.contact_end();
    FullMatrix<double>     flexibility = contact_stiffness(body);
    flexibility.gauss_jordan();
    const FullMatrix<double> receptance = contact_receptance(end, flexibility);
    const Discretization<dim> &space    = body.discretization;
    Vector heat_load                    = space.make_vector(Field::temperature);
    Vector momentum_load = space.make_vector(Field::displacement);
    Vector heat_rhs(heat_load), force(momentum_load);
    body.loads.assemble(state.time, heat_load, momentum_load);

    // The nodes have no mass, so that a stage of length 1 has the forces on
    // them on its right-hand side.
    body.equations.stage_rhs(
      state, 1., heat_load, momentum_load, heat_rhs, force);
    const std::vector<double> s =
      moved_by_force(end, flexibility, force, state.displacement);
    std::vector<double> free_penetration(s.begin(), s.begin() + end.n_nodes());
    for (unsigned int i = 0; i < end.n_nodes(); ++i)
      free_penetration[i] -= end.nodes()[i].gap;
    std::vector<double> &p = state.contact_pressure;
    ContactSolver(body.law())
      .solve(between_pressures(receptance), free_penetration, p);

    body.equations.stiffness().vmult(force, state.velocity);
    force *= -1.;
    const std::vector<double> s_rate =
      moved_by_force(end, flexibility, force, state.velocity);
    for (const auto &[node, entry] : end.all_entries(Field::displacement))
      {
        // where there is pressure, the law is exact to rounding of u
        double displacement = s[node], velocity = s_rate[node];
        for (unsigned int j = 0; j < p.size(); ++j)
          displacement -= receptance(node, j) * p[j];
        if (node < p.size() && p[node] > 0.)
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



#define INSTANTIATE(dim)                                                 \
  template FullMatrix<double> contact_stiffness<dim>(const Body<dim> &); \
  template FullMatrix<double> contact_receptance<dim>(                   \
    const ContactEnd<dim> &, const FullMatrix<double> &);                \
  template void settle_contact_nodes<dim>(Body<dim> &, State &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
