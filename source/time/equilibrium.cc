// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/stage_preconditioner.h>
#include <thermocontact/time/equilibrium.h>

namespace ThermoContact
{
  template <int dim>
  Equilibrium<dim>::Equilibrium(const Body<dim>          &body,
                                const SystemCoefficients &coefficients,
                                SolverCounters           &counters,
                                const Rows                rows)
    : body(body)
    , coefficients(body.equations.is_coupled() ?
                     coefficients :
                     coefficients.of(Field::displacement))
    , rows(rows)
    , counters(counters)
  {}



  template <int dim>
  void
  Equilibrium<dim>::linearize(const State &state)
  {
    if (!body.nonlinear)
      return;
    keep(std::make_unique<LinearSystem<dim>>(
      body.nonlinear->at(state.temperature), coefficients, rows));
  }



  template <int dim>
  void
  Equilibrium<dim>::provide()
  {
    if (system)
      return;
    if (rows == Rows::all && coefficients.stiffness != 0.)
      preconditioner = make_stage_preconditioner(body);
    keep(std::make_unique<LinearSystem<dim>>(
      body.equations, coefficients, nullptr, rows, preconditioner.get()));
  }



  template <int dim>
  void
  Equilibrium<dim>::keep(std::unique_ptr<LinearSystem<dim>> made)
  {
    port = std::make_unique<ContactPort<dim>>(body, *made);
    counters.factorizations += made->n_factorizations();
    counters.responses += made->n_responses();
    if (rows == Rows::all && body.law().is_active())
      counters.responses += port->provide_response();
    system = std::move(made);
  }



  template <int dim>
  void
  Equilibrium<dim>::solve(const Vector               &forces,
                          const std::vector<NodeLaw> &laws,
                          const std::vector<double>  &position,
                          const double                factor,
                          Vector                     &y,
                          std::vector<double>        &pressure)
  {
    provide();
    const unsigned int n_iterations = system->n_iterations();
    const unsigned int n_made = preconditioner ? preconditioner->n_made() : 0;
    if (preconditioner)
      preconditioner->make(1.);
    system->set_springs({}, {});
    y = 0.;
    if (laws.empty() || !body.law().is_active())
      system->solve(y, forces);
    else
      {
        pressure.resize(laws.size(), 0.);
        counters.active_set_iterations +=
          port->solve_contact(forces, laws, position, factor, y, pressure);
      }
    if (preconditioner)
      {
        counters.factorizations += preconditioner->n_made() - n_made;
        counters.linear_iterations += system->n_iterations() - n_iterations;
      }
  }



  template <int dim>
  void
  Equilibrium<dim>::solve_rates(const Vector                    &forces,
                                const std::vector<double>       &rate,
                                const std::vector<NodeLaw>      &laws,
                                const std::vector<unsigned int> &closing,
                                Vector                          &y)
  {
    port->solve_rates(forces, rate, laws, closing, y);
  }



  template <int dim>
  void
  Equilibrium<dim>::add_heating(const Vector &change, Vector &temperature)
  {
    if (coefficients.heating == 0.)
      return;
    provide();
    Vector heat(temperature);
    system->heat_of_motion(heat, change);
    temperature += heat;
  }



  template <int dim>
  FullMatrix<double>
  Equilibrium<dim>::receptance()
  {
    provide();
    const ContactEnd<dim> &end = body.contact_end();
    Vector forces = body.discretization.make_vector(Field::displacement);
    Vector displacement(forces);
    FullMatrix<double>  result(end.n_all_nodes(), end.n_nodes());
    std::vector<double> column;
    for (unsigned int j = 0; j < result.n(); ++j)
      {
        end.set_load_of_node(Field::displacement, j, 1., forces);
        system->solve(displacement, forces);
        end.get_all_values(Field::displacement, displacement, column);
        for (unsigned int i = 0; i < result.m(); ++i)
          result(i, j) = column[i];
      }
    return result;
  }



  template class Equilibrium<1>;
  template class Equilibrium<2>;
  template class Equilibrium<3>;
} // namespace ThermoContact
