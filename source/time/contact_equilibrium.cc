// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/contact_solver.h>
#include <thermocontact/time/contact_equilibrium.h>

#include <vector>

namespace ThermoContact
{
  template <int dim>
  FullMatrix<double>
  contact_stiffness(const Discretization<dim>             &discretization,
                    const ThermoviscoelasticOperator<dim> &stage_operator)
  {
    const unsigned int  n = discretization.contact_nodes().size();
    FullMatrix<double>  stiffness(n, n);
    Vector              unit = discretization.make_vector(1), force(unit);
    std::vector<double> values;
    for (unsigned int j = 0; j < n; ++j)
      {
        unit = 0.;
        for (const auto &[node, entry] : discretization.contact_entries(1))
          unit.begin()[entry] = node == j ? 1. : 0.;
        stage_operator.stiffness().vmult(force, unit);
        discretization.contact_values(1, force, values);
        for (unsigned int i = 0; i < n; ++i)
          stiffness(i, j) = values[i];
      }
    return stiffness;
  }



  template <int dim>
  FullMatrix<double>
  contact_receptance(const Discretization<dim> &discretization,
                     const FullMatrix<double>  &stiffness)
  {
    FullMatrix<double> receptance(stiffness);
    receptance.gauss_jordan();
    for (unsigned int i = 0; i < receptance.m(); ++i)
      for (unsigned int j = 0; j < receptance.n(); ++j)
        receptance(i, j) *= discretization.contact_nodes()[j].weight;
    return receptance;
  }



  namespace
  {
    /** Values of the nodes plus the displacement by forces on them. */
    template <int dim>
    std::vector<double>
    moved_by_force(const Discretization<dim> &discretization,
                   const FullMatrix<double>  &receptance,
                   const Vector              &force,
                   const Vector              &field)
    {
      std::vector<double> forces, moved;
      discretization.contact_values(1, force, forces);
      discretization.contact_values(1, field, moved);
      for (unsigned int i = 0; i < moved.size(); ++i)
        for (unsigned int j = 0; j < moved.size(); ++j)
          moved[i] += receptance(i, j) * forces[j] /
                      discretization.contact_nodes()[j].weight;
      return moved;
    }
  } // namespace



  template <int dim>
  void
  settle_contact_nodes(const Discretization<dim>             &discretization,
                       const ThermoviscoelasticOperator<dim> &stage_operator,
                       const ContactLaw                      &law,
                       Loads<dim>                            &loads,
                       State                                 &state)
  {
    const FullMatrix<double> receptance =
      contact_receptance(discretization,
                         contact_stiffness(discretization, stage_operator));
    Vector heat_load     = discretization.make_vector(0), heat_rhs(heat_load);
    Vector momentum_load = discretization.make_vector(1), force(momentum_load);
    loads.assemble(state.time, heat_load, momentum_load);

    // The nodes have no mass, so that a stage of length 1 has the forces on
    // them on its right-hand side.
    stage_operator.stage_rhs(
      state, 1., heat_load, momentum_load, heat_rhs, force);
    const std::vector<double> s =
      moved_by_force(discretization, receptance, force, state.displacement);
    std::vector<double> &p = state.contact_pressure;
    ContactSolver(law).solve(receptance, s, p);

    stage_operator.stiffness().vmult(force, state.velocity);
    force *= -1.;
    const std::vector<double> s_rate =
      moved_by_force(discretization, receptance, force, state.velocity);
    for (const auto &[node, entry] : discretization.contact_entries(1))
      {
        // where there is pressure, the law is exact to rounding of u
        double displacement = s[node];
        for (unsigned int j = 0; j < p.size(); ++j)
          displacement -= receptance(node, j) * p[j];
        const bool is_closed = p[node] > 0.;
        state.displacement.begin()[entry] =
          is_closed ? law.gap + law.compliance * p[node] : displacement;
        state.velocity.begin()[entry] =
          is_closed ? s_rate[node] * law.compliance /
                        (law.compliance + receptance(node, node)) :
                      s_rate[node];
      }
  }



#define INSTANTIATE(dim)                                                   \
  template FullMatrix<double> contact_stiffness<dim>(                      \
    const Discretization<dim> &, const ThermoviscoelasticOperator<dim> &); \
  template FullMatrix<double> contact_receptance<dim>(                     \
    const Discretization<dim> &, const FullMatrix<double> &);              \
  template void settle_contact_nodes<dim>(                                 \
    const Discretization<dim> &,                                           \
    const ThermoviscoelasticOperator<dim> &,                               \
    const ContactLaw &,                                                    \
    Loads<dim> &,                                                          \
    State &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
