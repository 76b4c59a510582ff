// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/heat_system.h>

namespace ThermoContact
{
  template <int dim>
  HeatSystem<dim>::HeatSystem(const ThermoviscoelasticOperator<dim> &equations,
                              const Vector *const                    diagonal_)
    : equations(equations)
    , is_mass(diagonal_ == nullptr)
  {
    if (!is_mass)
      diagonal = *diagonal_;
    if (equations.cell_products() == nullptr)
      {
        SparseMatrix matrix =
          equations.heat_stage_matrix(is_mass ? 0. : 1., is_mass ? 1. : 0.);
        for (const types::global_dof_index dof :
             diagonal.locally_owned_elements())
          matrix.add(dof, dof, diagonal(dof));
        matrix.compress(VectorOperation::add);
        factors = std::make_unique<DirectSolver>(std::move(matrix));
        return;
      }
    if constexpr (dim > 1)
      inverse_diagonal = equations.cell_products()->diagonal(Field::temperature,
                                                             is_mass ? 1. : 0.,
                                                             is_mass ? 0. : 1.);
    if (!is_mass)
      inverse_diagonal += diagonal;
    for (double &entry : inverse_diagonal)
      entry = 1. / entry;
  }



  template <int dim>
  void
  HeatSystem<dim>::solve(Vector &temperature, const Vector &heat) const
  {
    if (factors)
      {
        factors->solve(temperature, heat);
        return;
      }
    conjugate_gradients(is_mass ?
                          "the temperature of a body that is heated at once" :
                          "the steady profile",
                        *this,
                        temperature,
                        heat,
                        inverse_diagonal,
                        Tolerances::rounding_of_solution,
                        100000);
  }



  template <int dim>
  void
  HeatSystem<dim>::vmult(Vector &y, const Vector &x) const
  {
    if (is_mass)
      equations.heat_mass.vmult(y, x);
    else
      {
        equations.conduction.vmult(y, x);
        Vector product(x);
        product.scale(diagonal);
        y += product;
      }
    equations.zero_constrained(Field::temperature, y);
  }



  template class HeatSystem<1>;
  template class HeatSystem<2>;
  template class HeatSystem<3>;
} // namespace ThermoContact
