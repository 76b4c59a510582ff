// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/contact_solver.h>
#include <thermocontact/simulation/quasi_static_start.h>
#include <thermocontact/space/direct_solver.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /**
     * Solves $Sw=r-Np$ with (M.18) for $w$ at the contact nodes.
     *
     * @param law with the gap for $w$
     * @param excluded nodes that carry no pressure
     * @param load $r$
     * @param w in: a vector of the right layout; out: the solution
     * @param pressure in: a guess; out: the solution
     */
    template <int dim>
    void
    solve_with_contact(const Discretization<dim>             &discretization,
                       const ThermoviscoelasticOperator<dim> &stage_operator,
                       const ContactLaw                      &law,
                       const std::vector<bool>               &excluded,
                       DirectSolver                          &solver,
                       const Vector                          &load,
                       Vector                                &w,
                       std::vector<double>                   &pressure)
    {
      solver.solve(w, load);
      std::vector<unsigned int> nodes;
      for (unsigned int i = 0; i < excluded.size(); ++i)
        if (!excluded[i])
          nodes.push_back(i);
      if (!law.is_active || nodes.empty())
        return;

      const unsigned int  n = nodes.size();
      FullMatrix<double>  response(n, n);
      std::vector<Vector> unit_responses;
      std::vector<double> values, free(n), p(n);
      Vector              unit_load(load);
      for (unsigned int j = 0; j < n; ++j)
        {
          std::vector<double> unit_pressure(excluded.size(), 0.);
          unit_pressure[nodes[j]] = 1.;
          unit_load               = 0.;
          stage_operator.subtract_pressure(unit_pressure, -1., unit_load);
          solver.solve(unit_responses.emplace_back(unit_load), unit_load);
          discretization.contact_values(1, unit_responses[j], values);
          for (unsigned int i = 0; i < n; ++i)
            response(i, j) = values[nodes[i]];
        }
      discretization.contact_values(1, w, values);
      for (unsigned int i = 0; i < n; ++i)
        {
          free[i] = values[nodes[i]];
          p[i]    = pressure[nodes[i]];
        }
      ContactSolver(law).solve(response, free, p);
      for (unsigned int i = 0; i < n; ++i)
        {
          w.add(-p[i], unit_responses[i]);
          pressure[nodes[i]] = p[i];
        }
    }
  } // namespace



  template <int dim>
  void
  complete_quasi_static_state(
    const ModelParameters                 &model,
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &stage_operator,
    const ContactLaw                      &law,
    Loads<dim>                            &loads,
    State                                 &state)
  {
    Vector heat_load     = discretization.make_vector(0), heat_rhs(heat_load);
    Vector momentum_load = discretization.make_vector(1), rhs(momentum_load);
    loads.assemble(state.time, heat_load, momentum_load);

    // Without inertia a stage of length 1 has the matrix (zeta + 1) S and, on
    // the right-hand side, the forces on the body.
    DirectSolver solver(stage_operator.momentum_stage_matrix(1.));
    stage_operator.stage_rhs(
      state, 1., heat_load, momentum_load, heat_rhs, rhs);
    const unsigned int n = state.contact_pressure.size();
    if (model.is_static())
      {
        solve_with_contact(discretization,
                           stage_operator,
                           law,
                           std::vector<bool>(n, false),
                           solver,
                           rhs,
                           state.displacement,
                           state.contact_pressure);
        return;
      }

    stage_operator.subtract_pressure(state.contact_pressure, 1., rhs);
    std::vector<bool>   is_away(n, true);
    std::vector<double> displacement;
    discretization.contact_values(1, state.displacement, displacement);
    if (law.is_active && law.compliance == 0.)
      for (unsigned int i = 0; i < n; ++i)
        is_away[i] = displacement[i] < law.gap;
    solve_with_contact(discretization,
                       stage_operator,
                       ContactLaw{law.is_active, 0., 0.},
                       is_away,
                       solver,
                       rhs,
                       state.velocity,
                       state.contact_pressure);
    state.velocity *= (model.viscosity + 1.) / model.viscosity;
  }



#define INSTANTIATE(dim)                          \
  template void complete_quasi_static_state<dim>( \
    const ModelParameters &,                      \
    const Discretization<dim> &,                  \
    const ThermoviscoelasticOperator<dim> &,      \
    const ContactLaw &,                           \
    Loads<dim> &,                                 \
    State &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
