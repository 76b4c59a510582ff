// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/linear_system.h>
#include <thermocontact/time/iterative_node_equilibrium.h>
#include <thermocontact/time/node_equilibrium.h>

namespace ThermoContact
{
  namespace
  {
    /** Calls @p response for a unit value at one node after the other. */
    template <int dim, class Response>
    FullMatrix<double>
    matrix_by_columns(const Body<dim> &body, const Response &response)
    {
      const ContactEnd<dim> &end = body.contact_end();
      Vector unit = body.discretization.make_vector(Field::displacement);
      return end.all_response_matrix(
        [&](const unsigned int node) -> const Vector & {
          std::vector<double> unit_value(end.n_all_nodes(), 0.);
          unit_value[node] = 1.;
          unit             = 0.;
          end.set_all_values(Field::displacement, unit_value, unit);
          return response(unit);
        });
    }
  } // namespace



  template <int dim>
  DirectNodeEquilibrium<dim>::DirectNodeEquilibrium(const Body<dim> &body,
                                                    const double     factor,
                                                    SolverCounters  &counters,
                                                    const bool       takes_heat)
    : law(body.law())
  {
    Vector force = body.discretization.make_vector(Field::displacement);
    flexibility  = matrix_by_columns(body, [&](const Vector &unit) -> Vector  &{
      body.equations.stiffness.vmult(force, unit);
      return force;
    });
    if (takes_heat && body.equations.is_coupled())
      add_heating_to(body, counters, flexibility);
    flexibility *= factor;
    flexibility.gauss_jordan();
    const unsigned int n = body.contact_end().n_nodes();
    all_receptance.reinit(flexibility.m(), n);
    for (unsigned int i = 0; i < flexibility.m(); ++i)
      for (unsigned int j = 0; j < n; ++j)
        all_receptance(i, j) =
          flexibility(i, j) * body.contact_end().nodes()[j].weight;
    between_pressures.reinit(n, n);
    between_pressures.fill(all_receptance);
  }



  template <int dim>
  void
  DirectNodeEquilibrium<dim>::add_heating_to(const Body<dim>    &body,
                                             SolverCounters     &counters,
                                             FullMatrix<double> &stiffness)
  {
    LinearSystem<dim> heat_mass(body.equations, heat_at_once);
    counters.factorizations += heat_mass.n_factorizations();
    Vector heat  = body.discretization.make_vector(Field::temperature);
    Vector force = body.discretization.make_vector(Field::displacement);
    stiffness.add(-1.,
                  matrix_by_columns(body, [&](const Vector &unit) -> Vector & {
                    heat = 0.;
                    body.equations.add_heating(unit, -1., heat);
                    Vector &response = temperature_responses.emplace_back(heat);
                    heat_mass.solve(response, heat);
                    ++counters.responses;
                    force = 0.;
                    body.equations.add_thermal_stress(response, 1., force);
                    return force;
                  }));
  }



  template <int dim>
  std::vector<double>
  DirectNodeEquilibrium<dim>::change_by(
    const std::vector<double> &free,
    const std::vector<double> &pressure) const
  {
    std::vector<double> change = product(all_receptance, pressure);
    for (unsigned int i = 0; i < change.size(); ++i)
      change[i] = free[i] - change[i];
    return change;
  }



  template <int dim>
  std::vector<double>
  DirectNodeEquilibrium<dim>::moved(const std::vector<double> &position,
                                    const std::vector<double> &free) const
  {
    std::vector<double> result(position);
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] += free[i];
    return result;
  }



  template <int dim>
  std::vector<double>
  DirectNodeEquilibrium<dim>::solve(const std::vector<double>  &load,
                                    const std::vector<NodeLaw> &laws,
                                    const std::vector<double>  &position,
                                    std::vector<double>        &pressure)
  {
    const std::vector<double> free = product(flexibility, load);
    problem.solve(between_pressures, laws, moved(position, free), pressure);
    return change_by(free, pressure);
  }



  template <int dim>
  std::vector<double>
  DirectNodeEquilibrium<dim>::solve_rates(
    const std::vector<double>       &load,
    const std::vector<double>       &rate,
    const std::vector<unsigned int> &closing)
  {
    const std::vector<double> free   = product(flexibility, load);
    std::vector<double>       slopes = problem.slopes();
    for (const unsigned int i : closing)
      slopes[i] =
        NodeLaw(law).tangent_of_pressure(0.).slope(between_pressures(i, i));
    return change_by(
      free, change_of_pressure(between_pressures, slopes, moved(rate, free)));
  }



  template <int dim>
  void
  DirectNodeEquilibrium<dim>::add_heating(const std::vector<double> &change,
                                          Vector &temperature) const
  {
    for (unsigned int i = 0; i < temperature_responses.size(); ++i)
      temperature.add(change[i], temperature_responses[i]);
  }



  template <int dim>
  std::unique_ptr<NodeEquilibrium<dim>>
  make_node_equilibrium(const Body<dim> &body,
                        const double     factor,
                        SolverCounters  &counters,
                        const bool       takes_heat)
  {
    if constexpr (dim > 1)
      if (!body.scene.linear_solver.has_matrices())
        return std::make_unique<IterativeNodeEquilibrium<dim>>(body,
                                                               factor,
                                                               takes_heat);
    return std::make_unique<DirectNodeEquilibrium<dim>>(body,
                                                        factor,
                                                        counters,
                                                        takes_heat);
  }



#define INSTANTIATE(dim)                                                \
  template class DirectNodeEquilibrium<dim>;                            \
  template std::unique_ptr<NodeEquilibrium<dim>> make_node_equilibrium( \
    const Body<dim> &, const double, SolverCounters &, const bool)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
