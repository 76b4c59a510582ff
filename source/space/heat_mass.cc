// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/heat_mass.h>
#include <thermocontact/space/matrix_free_operator.h>

#include <deal.II/lac/diagonal_matrix.h>

namespace ThermoContact
{
  namespace
  {
    constexpr unsigned int max_iterations = 10000;



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
  HeatMass<dim>::HeatMass(const Body<dim> &body)
    : body(body)
  {
    if (body.scene.linear_solver.has_matrices())
      {
        factors =
          std::make_unique<DirectSolver>(body.equations.heat_stage_matrix(0.));
        return;
      }
    if constexpr (dim > 1)
      inverse_diagonal = body.equations.matrix_free()->heat_diagonal({1., 0.});
    for (double &entry : inverse_diagonal)
      entry = 1. / entry;
  }



  template <int dim>
  void
  HeatMass<dim>::solve(Vector &temperature, const Vector &heat) const
  {
    if (factors)
      {
        factors->solve(temperature, heat);
        return;
      }
    temperature = 0.;
    if (heat.linfty_norm() > 0.)
      conjugate_gradients("the temperature of a body that is heated at once",
                          FreeHeatMass<dim>{body.equations},
                          temperature,
                          heat,
                          DiagonalMatrix<Vector>(inverse_diagonal),
                          Tolerances::rounding_of_solution,
                          max_iterations);
  }



  template class HeatMass<1>;
  template class HeatMass<2>;
  template class HeatMass<3>;
} // namespace ThermoContact
