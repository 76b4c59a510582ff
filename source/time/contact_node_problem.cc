// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/matrix_free_operator.h>
#include <thermocontact/time/contact_node_problem.h>

#include <deal.II/lac/diagonal_matrix.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    constexpr unsigned int max_sets_of_many_changes = 20;
  } // namespace



  template <int dim>
  ContactNodeProblem<dim>::ContactNodeProblem(const Body<dim> &body,
                                              const double     factor,
                                              const bool       takes_heat)
    : body(body)
    , factor(factor)
    , takes_heat(takes_heat && body.equations.is_coupled())
    , sets{std::vector<bool>(body.contact_end().n_all_nodes(), false),
           std::vector<bool>(body.contact_end().n_all_nodes(), false)}
    , values(body.discretization.make_vector(Field::displacement))
    , forces(values)
  {
    body.contact_end().get_all_values(
      Field::displacement,
      body.equations.matrix_free()->contact_stiffness_diagonal(),
      diagonal);
    for (double &entry : diagonal)
      entry *= factor;
    if (!this->takes_heat)
      return;
    inverse_heat_mass = body.equations.matrix_free()->heat_diagonal({1., 0.});
    for (double &entry : inverse_heat_mass)
      entry = 1. / entry;
  }



  template <int dim>
  double
  ContactNodeProblem<dim>::spring(const unsigned int node) const
  {
    return sets.is_active[node] && !body.law().is_rigid() ?
             body.contact_end().nodes()[node].weight / body.law().tangent(0.) :
             0.;
  }



  template <int dim>
  std::vector<double>
  ContactNodeProblem<dim>::product(const std::vector<double> &x) const
  {
    values = 0.;
    body.contact_end().set_all_values(Field::displacement, x, values);
    body.equations.matrix_free()->contact_stiffness(forces, values);
    if (takes_heat)
      body.equations.add_thermal_stress(heating(x), -1., forces);
    std::vector<double> y;
    body.contact_end().get_all_values(Field::displacement, forces, y);
    for (double &entry : y)
      entry *= factor;
    return y;
  }



  namespace
  {
    /** $M$ for temperatures that vanish where they are given. */
    template <int dim>
    struct FreeHeatMass
    {
      const ThermoviscoelasticOperator<dim> &equations;

      void
      vmult(Vector &y, const Vector &x) const
      {
        equations.heat_mass().vmult(y, x);
        equations.zero_constrained(Field::temperature, y);
      }
    };
  } // namespace



  template <int dim>
  Vector
  ContactNodeProblem<dim>::heating(const std::vector<double> &change) const
  {
    Vector heat = body.discretization.make_vector(Field::temperature);
    Vector temperature(heat);
    values = 0.;
    body.contact_end().set_all_values(Field::displacement, change, values);
    body.equations.subtract_heating(values, heat);
    if (heat.linfty_norm() > 0.)
      conjugate_gradients("the heat of nodes that move at once",
                          FreeHeatMass<dim>{body.equations},
                          temperature,
                          heat,
                          DiagonalMatrix<Vector>(inverse_heat_mass),
                          1e-13,
                          10000);
    return temperature;
  }



  template <int dim>
  void
  ContactNodeProblem<dim>::vmult(dealii::Vector<double>       &y,
                                 const dealii::Vector<double> &x) const
  {
    std::vector<double> free(x.begin(), x.end());
    for (unsigned int i = 0; i < free.size(); ++i)
      if (is_held(i))
        free[i] = 0.;
    const std::vector<double> result = product(free);
    for (unsigned int i = 0; i < result.size(); ++i)
      y(i) = is_held(i) ? x(i) : result[i] + spring(i) * x(i);
  }



  template <int dim>
  std::vector<double>
  ContactNodeProblem<dim>::solve_for_same_set(
    const std::vector<double> &load,
    const std::vector<double> &penetration)
  {
    const unsigned int  n = load.size();
    std::vector<double> held(n, 0.);
    for (unsigned int i = 0; i < n; ++i)
      if (is_held(i))
        held[i] = -penetration[i];
    const std::vector<double> by_held = product(held);
    dealii::Vector<double>    b(n), x(n), inverse(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        if (!is_held(i))
          b(i) = load[i] - by_held[i];
        if (const double stiffness = spring(i); stiffness > 0.)
          b(i) -= stiffness * penetration[i];
        inverse(i) = is_held(i) ? 1. : 1. / (diagonal[i] + spring(i));
      }
    if (b.linfty_norm() > 0.)
      conjugate_gradients("the equilibrium of the contact nodes",
                          *this,
                          x,
                          b,
                          DiagonalMatrix<dealii::Vector<double>>(inverse),
                          tolerance(),
                          10000);
    std::vector<double> change(x.begin(), x.end());
    for (unsigned int i = 0; i < n; ++i)
      change[i] += held[i];
    return change;
  }



  template <int dim>
  std::vector<double>
  ContactNodeProblem<dim>::solve(const std::vector<double> &load,
                                 const EndPenetrations     &penetration,
                                 const std::vector<bool>   &can_touch,
                                 std::vector<double>       &pressure)
  {
    const ContactEnd<dim> &end      = body.contact_end();
    const unsigned int     n        = pressure.size();
    const unsigned int     max_sets = 200 + 2 * n;
    const bool             are_two  = !penetration.rear.empty();
    for (unsigned int i = 0; i < n; ++i)
      {
        sets.is_rear[i] = are_two && can_touch[i] && pressure[i] < 0.;
        sets.is_active[i] =
          sets.is_rear[i] || (can_touch[i] && pressure[i] > 0.);
      }
    for (unsigned int n_sets = 1; n_sets <= max_sets; ++n_sets)
      {
        std::vector<double> at_stop(penetration.front);
        for (unsigned int i = 0; i < n; ++i)
          if (sets.is_rear[i])
            at_stop[i] = -penetration.rear[i];
        const std::vector<double> change = solve_for_same_set(load, at_stop);
        const std::vector<double> force  = product(change);
        std::vector<double>       reach(n), rear_reach;
        for (unsigned int i = 0; i < n; ++i)
          {
            reach[i] = penetration.front[i] + change[i];
            if (are_two)
              rear_reach.push_back(penetration.rear[i] - change[i]);
            pressure[i] = sets.is_active[i] ?
                            (load[i] - force[i]) / end.nodes()[i].weight :
                            0.;
          }
        if (!update_active_set(pressure,
                               reach,
                               rear_reach,
                               can_touch,
                               10. * tolerance(),
                               n_sets > max_sets_of_many_changes,
                               sets))
          {
            remove_pull(sets, std::vector<bool>(n, false), pressure);
            return change;
          }
      }
    throw ComputationError("the active set of " + std::to_string(n) +
                           " contact nodes did not settle in equilibrium\n"
                           "  remedy:  a larger Contact/Compliance or "
                           "Solver/Linear solver = direct");
  }



  template class ContactNodeProblem<2>;
  template class ContactNodeProblem<3>;
} // namespace ThermoContact
