// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/field_matrices.h>
#include <thermocontact/space/lateral_exchange.h>

namespace ThermoContact
{
  template <int dim>
  void
  FieldMatrices<dim>::assemble_lateral_exchange()
  {
    if (!(scene.lateral_exchange > 0.))
      return;
    const LateralExchange<dim> exchange(scene, discretization);
    AffineConstraints<double>  unconstrained;
    unconstrained.close();

    const unsigned int n = discretization.finite_element().dofs_per_cell;
    FullMatrix<double> cell_matrix(n, n);
    std::vector<types::global_dof_index> dofs(n);
    exchange.for_each_place(
      [&](const auto &cell, const FEValuesBase<dim> &values) {
        exchange.integrate(values, cell_matrix);
        cell->get_dof_indices(dofs);
        unconstrained.distribute_local_to_global(cell_matrix, dofs, stiffness);
        unconstrained.distribute_local_to_global(cell_matrix,
                                                 dofs,
                                                 lateral_exchange);
        if (rod_cells)
          rod_cells->add_exchange(cell->active_cell_index(), cell_matrix);
      });
    stiffness.compress(VectorOperation::add);
    lateral_exchange.compress(VectorOperation::add);
  }



  template void
  FieldMatrices<1>::assemble_lateral_exchange();
  template void
  FieldMatrices<2>::assemble_lateral_exchange();
  template void
  FieldMatrices<3>::assemble_lateral_exchange();
} // namespace ThermoContact
