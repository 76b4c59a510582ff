// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/method/contact_solver.h>
#include <thermocontact/time/contact_equilibrium.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/vector.h>

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



  namespace
  {
    /** The stiffness of the contact nodes among each other, with springs. */
    template <int dim>
    class ContactNodeStiffness
    {
    public:
      explicit ContactNodeStiffness(const Body<dim> &body)
        : body(body)
        , unit(body.discretization.make_vector(Field::displacement))
        , force(unit)
        , springs(body.contact_end().n_all_nodes(), 0.)
        , is_held(body.contact_end().n_all_nodes(), false)
      {}

      const Body<dim>    &body;
      mutable Vector      unit, force;
      std::vector<double> springs;
      std::vector<bool>   is_held;

      /** Forces on the nodes by their displacements alone. */
      std::vector<double>
      forces(const std::vector<double> &displacement) const
      {
        unit = 0.;
        body.contact_end().set_all_values(Field::displacement,
                                          displacement,
                                          unit);
        body.equations.stiffness().vmult(force, unit);
        std::vector<double> result;
        body.contact_end().get_all_values(Field::displacement, force, result);
        return result;
      }

      void
      vmult(dealii::Vector<double> &y, const dealii::Vector<double> &x) const
      {
        std::vector<double> values(x.begin(), x.end());
        for (unsigned int i = 0; i < values.size(); ++i)
          values[i] *= is_held[i] ? 0. : 1.;
        const std::vector<double> result = forces(values);
        for (unsigned int i = 0; i < result.size(); ++i)
          y(i) = is_held[i] ? x(i) : result[i] + springs[i] * x(i);
      }

      /**
       * The displacements by forces, with given ones where nodes are held.
       *
       * @param load forces; those on held nodes are of no account
       * @param held displacements of the nodes that are held, else zero
       * @param offset what springs are compressed by before
       */
      std::vector<double>
      solve(const std::vector<double> &load,
            const std::vector<double> &held,
            const std::vector<double> &offset) const
      {
        const std::vector<double> by_held = forces(held);
        dealii::Vector<double>    b(load.size()), x(load.size());
        for (unsigned int i = 0; i < load.size(); ++i)
          b(i) =
            is_held[i] ? 0. : load[i] - by_held[i] - springs[i] * offset[i];
        SolverControl control(10000, 1e-13 * b.l2_norm(), false, false);
        if (b.linfty_norm() > 0.)
          SolverCG<dealii::Vector<double>>(control).solve(
            *this, x, b, PreconditionIdentity());
        std::vector<double> result(held);
        for (unsigned int i = 0; i < result.size(); ++i)
          result[i] += x(i);
        return result;
      }
    };



    /**
     * As settle_contact_nodes(), for as many nodes as there may be: active sets
     * and conjugate gradients instead of a receptance.
     *
     * @param load forces on the nodes
     * @param rate_load likewise, of the velocity
     */
    template <int dim>
    void
    settle_many_nodes(const Body<dim>           &body,
                      const std::vector<double> &load,
                      const std::vector<double> &rate_load,
                      State                     &state)
    {
      const ContactEnd<dim>    &end = body.contact_end();
      const unsigned int        n   = end.n_all_nodes();
      ContactNodeStiffness<dim> stiffness(body);
      std::vector<double>      &p           = state.contact_pressure;
      const unsigned int        n_pressures = p.size();
      std::vector<double>       displacement, change(n, 0.);
      end.get_all_values(Field::displacement, state.displacement, displacement);
      std::vector<double> penetration(displacement);
      for (unsigned int i = 0; i < n_pressures; ++i)
        penetration[i] -= end.nodes()[i].gap;
      const double      tangent = body.law().tangent(0.);
      std::vector<bool> is_active(n, false);
      for (unsigned int i = 0; i < n_pressures; ++i)
        is_active[i] = p[i] > 0.;
      const unsigned int max_sets  = 100 + n;
      unsigned int       iteration = 0;
      for (bool has_changed = true; has_changed; ++iteration)
        {
          if (iteration > max_sets)
            throw ComputationError(
              "the active set of " + std::to_string(n) +
              " contact nodes did not settle at the start\n  remedy:  a larger "
              "Contact/Compliance or Solver/Linear solver = direct");
          std::vector<double> held(n, 0.);
          for (unsigned int i = 0; i < n; ++i)
            {
              stiffness.is_held[i] = is_active[i] && body.law().is_rigid();
              stiffness.springs[i] = is_active[i] && !body.law().is_rigid() ?
                                       end.nodes()[i].weight / tangent :
                                       0.;
              if (stiffness.is_held[i])
                held[i] = -penetration[i];
            }
          change = stiffness.solve(load, held, penetration);
          const std::vector<double> force = stiffness.forces(change);
          has_changed                     = false;
          for (unsigned int i = 0; i < n_pressures; ++i)
            {
              p[i] = is_active[i] ?
                       (load[i] - force[i]) / end.nodes()[i].weight :
                       0.;
              const bool is_wrong =
                is_active[i] ? p[i] < 0. : penetration[i] + change[i] > 1e-14;
              if (is_wrong)
                {
                  is_active[i] = !is_active[i];
                  has_changed  = true;
                }
            }
        }
      for (unsigned int i = 0; i < n; ++i)
        stiffness.springs[i] = is_active[i] && !body.law().is_rigid() ?
                                 end.nodes()[i].weight / tangent :
                                 0.;
      std::vector<double> velocity, values(n);
      end.get_all_values(Field::displacement, state.velocity, velocity);
      std::vector<double> stop(n, 0.);
      for (unsigned int i = 0; i < n; ++i)
        if (stiffness.is_held[i])
          stop[i] = -velocity[i];
      const std::vector<double> acceleration =
        stiffness.solve(rate_load, stop, velocity);
      for (unsigned int i = 0; i < n; ++i)
        {
          velocity[i] += acceleration[i];
          // where there is pressure, the law is exact to rounding of u
          values[i] = i < n_pressures && p[i] > 0. ?
                        end.nodes()[i].gap + body.law().penetration(p[i]) :
                        displacement[i] + change[i];
        }
      end.set_all_values(Field::displacement, values, state.displacement);
      end.set_all_values(Field::displacement, velocity, state.velocity);
    }
  } // namespace



  template <int dim>
  void
  settle_contact_nodes(Body<dim> &body, State &state)
  {
    const ContactEnd<dim>     &end   = body.contact_end();
    const Discretization<dim> &space = body.discretization;
    Vector heat_load                 = space.make_vector(Field::temperature);
    Vector momentum_load             = space.make_vector(Field::displacement);
    Vector heat_rhs(heat_load), force(momentum_load);
    body.loads.assemble(state.time, heat_load, momentum_load);

    // The nodes have no mass, so that a stage of length 1 has the forces on
    // them on its right-hand side.
    body.equations.stage_rhs(
      state, 1., heat_load, momentum_load, heat_rhs, force);
    if (!body.scene.linear_solver.has_matrices())
      {
        std::vector<double> load, rate_load;
        end.get_all_values(Field::displacement, force, load);
        body.equations.stiffness().vmult(force, state.velocity);
        end.get_all_values(Field::displacement, force, rate_load);
        for (double &rate : rate_load)
          rate *= -1.;
        settle_many_nodes(body, load, rate_load, state);
        return;
      }
    FullMatrix<double> flexibility = contact_stiffness(body);
    flexibility.gauss_jordan();
    const FullMatrix<double>  receptance = contact_receptance(end, flexibility);
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
    Vector heat_load                 = space.make_vector(Field::temperature);
    Vector momentum_load             = space.make_vector(Field::displacement);
    Vector heat_rhs(heat_load), force(momentum_load), viscous(momentum_load);
    body.loads.assemble(state.time, heat_load, momentum_load);
    body.equations.stage_rhs(
      state, 1., heat_load, momentum_load, heat_rhs, force);
    body.equations.stiffness().vmult(viscous, state.velocity);
    force.add(-zeta, viscous);

    FullMatrix<double> flexibility(stiffness);
    flexibility *= zeta;
    flexibility.gauss_jordan();
    const FullMatrix<double>  receptance = contact_receptance(end, flexibility);
    const std::vector<double> free =
      moved_by_force(end, flexibility, force, state.velocity);

    std::vector<unsigned int> nodes;
    for (unsigned int i = 0; i < is_closed.size(); ++i)
      if (is_closed[i])
        nodes.push_back(i);
    const unsigned int  n = nodes.size();
    FullMatrix<double>  response(n, n);
    std::vector<double> free_velocity(n), p(n, 0.);
    response.extract_submatrix_from(receptance, nodes, nodes);
    for (unsigned int i = 0; i < n; ++i)
      free_velocity[i] = free[nodes[i]];
    ContactSolver(body.law()).solve(response, free_velocity, p);

    std::fill(state.contact_pressure.begin(), state.contact_pressure.end(), 0.);
    for (unsigned int i = 0; i < n; ++i)
      state.contact_pressure[nodes[i]] = p[i];
    std::vector<double> velocity(free);
    for (unsigned int i = 0; i < velocity.size(); ++i)
      for (unsigned int j = 0; j < state.contact_pressure.size(); ++j)
        velocity[i] -= receptance(i, j) * state.contact_pressure[j];
    end.set_all_values(Field::displacement, velocity, state.velocity);
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
