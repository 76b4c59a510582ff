// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/time/iterative_node_equilibrium.h>

#include <algorithm>

namespace ThermoContact
{
  template <int dim>
  IterativeNodeEquilibrium<dim>::IterativeNodeEquilibrium(const Body<dim> &body,
                                                          const double factor,
                                                          const bool takes_heat)
    : body(body)
    , factor(factor)
    , takes_heat(takes_heat && body.equations.is_coupled())
    , tangents(body.contact_end().n_all_nodes())
    , values(body.discretization.make_vector(Field::displacement))
    , forces(values)
  {
    body.contact_end().get_all_values(
      Field::displacement,
      body.equations.cell_products()->diagonal(Field::displacement, 0., 1.),
      diagonal);
    for (double &entry : diagonal)
      entry *= factor;
    if (this->takes_heat)
      heat_mass =
        std::make_unique<LinearSystem<dim>>(body.equations, heat_at_once);
  }



  template <int dim>
  double
  IterativeNodeEquilibrium<dim>::spring(const unsigned int node) const
  {
    return is_held(node) ? 0. :
                           body.contact_end().all_nodes()[node].weight /
                             tangents[node].compliance;
  }



  template <int dim>
  std::vector<double>
  IterativeNodeEquilibrium<dim>::product(const std::vector<double> &x) const
  {
    values = 0.;
    body.contact_end().set_all_values(Field::displacement, x, values);
    body.equations.cell_products()->contact_stiffness(forces, values);
    if (takes_heat)
      body.equations.add_thermal_stress(heating(x), -1., forces);
    std::vector<double> y;
    body.contact_end().get_all_values(Field::displacement, forces, y);
    for (double &entry : y)
      entry *= factor;
    return y;
  }



  template <int dim>
  Vector
  IterativeNodeEquilibrium<dim>::heating(
    const std::vector<double> &change) const
  {
    Vector heat = body.discretization.make_vector(Field::temperature);
    Vector temperature(heat);
    values = 0.;
    body.contact_end().set_all_values(Field::displacement, change, values);
    body.equations.add_heating(values, -1., heat);
    heat_mass->solve(temperature, heat);
    return temperature;
  }



  template <int dim>
  void
  IterativeNodeEquilibrium<dim>::vmult(dealii::Vector<double>       &y,
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
  IterativeNodeEquilibrium<dim>::solve_linear(
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
          b(i) = load[i] - by_held[i] - spring(i) * penetration[i];
        inverse(i) = is_held(i) ? 1. : 1. / (diagonal[i] + spring(i));
      }
    conjugate_gradients("the equilibrium of the contact nodes",
                        *this,
                        x,
                        b,
                        inverse,
                        tolerance());
    std::vector<double> change(x.begin(), x.end());
    for (unsigned int i = 0; i < n; ++i)
      change[i] += held[i];
    return change;
  }



  template <int dim>
  std::vector<double>
  IterativeNodeEquilibrium<dim>::solve_rates(
    const std::vector<double>       &load,
    const std::vector<double>       &rate,
    const std::vector<unsigned int> &closing)
  {
    for (const unsigned int i : closing)
      tangents[i] = NodeLaw(body.law()).tangent_of_pressure(0.);
    std::vector<double> of_all(rate);
    of_all.resize(load.size(), 0.);
    return solve_linear(load, of_all);
  }



  template <int dim>
  void
  IterativeNodeEquilibrium<dim>::add_heating(const std::vector<double> &change,
                                             Vector &temperature) const
  {
    if (takes_heat)
      temperature += heating(change);
  }



  template <int dim>
  void
  IterativeNodeEquilibrium<dim>::solve(const std::vector<AffineLaw> &laws,
                                       const bool,
                                       std::vector<double> &new_position,
                                       std::vector<double> &pressure)
  {
    const unsigned int n = laws.size();
    std::copy(laws.begin(), laws.end(), tangents.begin());
    std::vector<double> penetration(load->size(), 0.);
    for (unsigned int i = 0; i < n; ++i)
      penetration[i] = (*position)[i] - laws[i].offset;
    change                          = solve_linear(*load, penetration);
    const std::vector<double> force = product(change);
    new_position.resize(n);
    pressure.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        new_position[i] =
          is_held(i) ? laws[i].offset : (*position)[i] + change[i];
        pressure[i] =
          laws[i].is_open() ?
            0. :
            ((*load)[i] - force[i]) / body.contact_end().nodes()[i].weight;
      }
  }



  template <int dim>
  std::vector<double>
  IterativeNodeEquilibrium<dim>::solve(const std::vector<double>  &load,
                                       const std::vector<NodeLaw> &laws,
                                       const std::vector<double>  &position,
                                       std::vector<double>        &pressure)
  {
    this->load     = &load;
    this->position = &position;
    std::vector<double> receptance, found(position);
    for (unsigned int i = 0; i < laws.size(); ++i)
      receptance.push_back(body.contact_end().nodes()[i].weight / diagonal[i]);
    solve_by_tangents(
      *this, laws, receptance, 10. * tolerance(), found, pressure);
    return change;
  }



  template class IterativeNodeEquilibrium<2>;
  template class IterativeNodeEquilibrium<3>;
} // namespace ThermoContact
