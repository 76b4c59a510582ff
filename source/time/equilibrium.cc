// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/motion_preconditioner.h>
#include <thermocontact/time/equilibrium.h>

namespace ThermoContact
{
  template <int dim>
  Equilibrium<dim>::Equilibrium(const Body<dim> &body,
                                const Matrix     matrix,
                                SolverCounters  &counters)
    : body(body)
    , matrix(matrix)
    , counters(counters)
  {}



  template <int dim>
  const SystemCoefficients &
  Equilibrium<dim>::coefficients() const
  {
    return matrix == Matrix::inertia ? motion_by_inertia :
           matrix == Matrix::at_once && body.equations.is_coupled() ?
                                       motion_at_once :
           dim == 1 && body.scene.material.has_viscosity() ?
                                       motion_by_viscosity :
                                       motion_by_stiffness;
  }



  template <int dim>
  void
  Equilibrium<dim>::linearize(const State &state)
  {
    if (!body.nonlinear)
      return;
    system.reset();
    own_equations = std::make_unique<const ThermoviscoelasticOperator<dim>>(
      body.equations, body.nonlinear->at(state.temperature));
  }



  template <int dim>
  void
  Equilibrium<dim>::provide()
  {
    if (system)
      return;
    if (matrix != Matrix::inertia)
      preconditioner = make_motion_preconditioner(body);
    auto made =
      std::make_unique<LinearSystem<dim>>(equations(),
                                          coefficients(),
                                          nullptr,
                                          LinearSystem<dim>::Rows::all,
                                          preconditioner.get());
    counters.factorizations += made->n_factorizations();
    port = std::make_unique<ContactPort<dim>>(body, *made);
    if (made->has_factors() && body.law().is_active())
      counters.responses += port->response().m();
    system = std::move(made);
  }



  template <int dim>
  void
  Equilibrium<dim>::solve(const Vector               *forces,
                          const std::vector<NodeLaw> &laws,
                          const std::vector<double>  &position,
                          const double                factor,
                          Vector                     &y,
                          std::vector<double>        &pressure)
  {
    provide();
    const Vector  none = body.discretization.make_vector(Field::displacement);
    const Vector &r    = forces != nullptr ? *forces : none;
    const unsigned int n_iterations = system->n_iterations();
    const unsigned int n_made = preconditioner ? preconditioner->n_made() : 0;
    if (!system->has_factors())
      system->set_springs({}, {});
    y = 0.;
    if (laws.empty() || !body.law().is_active())
      system->solve(y, r);
    else
      {
        pressure.resize(laws.size(), 0.);
        const unsigned int n_sets =
          port->solve_contact(r, laws, position, factor, y, pressure);
        if (!system->has_factors())
          counters.active_set_iterations += n_sets;
      }
    if (preconditioner)
      {
        counters.factorizations += preconditioner->n_made() - n_made;
        counters.linear_iterations += system->n_iterations() - n_iterations;
      }
  }



  template class Equilibrium<1>;
  template class Equilibrium<2>;
  template class Equilibrium<3>;
} // namespace ThermoContact
