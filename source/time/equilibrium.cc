// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/equilibrium.h>

namespace ThermoContact
{
  template <int dim>
  Equilibrium<dim>::Equilibrium(const Body<dim> &body,
                                const Matrix     matrix,
                                SolverCounters  &counters)
    : body(body)
    , kind(matrix)
    , counters(counters)
  {}



  template <int dim>
  void
  Equilibrium<dim>::provide()
  {
    if (factors)
      return;
    // a stage without length has bM_u, one of length 1 without inertia the sum
    // of elastic and viscous stiffness
    factors = std::make_unique<DirectSolver>(
      body.equations.momentum_stage_matrix(kind == Matrix::inertia ? 0. : 1.));
    ++counters.factorizations;
    if (!body.law().is_active())
      return;
    const ContactEnd<dim> &end = body.contact_end();
    Vector unit_load = body.discretization.make_vector(Field::displacement);
    receptance =
      end.response_matrix([&](const unsigned int node) -> const Vector & {
        end.set_load_of_node(Field::displacement, node, 1., unit_load);
        Vector &response = unit_responses.emplace_back(unit_load);
        factors->solve(response, unit_load);
        ++counters.responses;
        return response;
      });
  }



  template <int dim>
  void
  Equilibrium<dim>::solve(const Vector &forces, Vector &y)
  {
    provide();
    factors->solve(y, forces);
  }



  template <int dim>
  void
  Equilibrium<dim>::add_contact(const std::vector<NodeLaw> &laws,
                                const std::vector<double>  &free,
                                const double                factor,
                                Vector                     *y,
                                std::vector<double>        &pressure)
  {
    if (!body.law().is_active())
      return;
    provide();
    FullMatrix<double> response(receptance);
    response *= factor;
    InterfaceProblem().solve(response, laws, free, pressure);
    if (y != nullptr)
      for (unsigned int i = 0; i < pressure.size(); ++i)
        y->add(-pressure[i], unit_responses[i]);
  }



  template class Equilibrium<1>;
  template class Equilibrium<2>;
  template class Equilibrium<3>;
} // namespace ThermoContact
