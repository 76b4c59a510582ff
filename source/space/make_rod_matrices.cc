// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/make_rod_matrices.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** The numbering of deal.II for cells that come in a row. */
    bool
    is_in_order(const Discretization<1> &discretization,
                const RodLayout         &layout)
    {
      const FiniteElement<1>              &fe = discretization.finite_element();
      std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
      unsigned int                         c = 0;
      for (const auto &cell :
           discretization.dof_handler().active_cell_iterators())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const auto [component, node] = fe.system_to_component_index(i);
              const Field::Block field =
                component == discretization.first_component(
                               Field::displacement) &&
                    discretization.has_field(Field::displacement) ?
                  Field::displacement :
                  Field::temperature;
              if (dofs[i] != discretization.first_dof(field) +
                               layout.node(c, node))
                return false;
            }
          ++c;
        }
      return true;
    }



    /** An entry of a matrix of one process; 0 if there is none. */
    double
    entry(const SparseMatrix &matrix,
          const unsigned int  row,
          const unsigned int  column)
    {
      int     n_entries = 0;
      double *values    = nullptr;
      int    *columns   = nullptr;
      matrix.trilinos_matrix().ExtractMyRowView(row,
                                                n_entries,
                                                values,
                                                columns);
      const int *const place =
        std::find(columns, columns + n_entries, static_cast<int>(column));
      return place == columns + n_entries ? 0. : values[place - columns];
    }



    /** The blocks that a scene has. */
    std::array<const SparseMatrix *, RodMatrices::n_matrices>
    blocks_of(const Discretization<1> &discretization,
              const FieldMatrices<1>  &matrices)
    {
      std::array<const SparseMatrix *, RodMatrices::n_matrices> blocks{};
      if (discretization.has_field(Field::temperature))
        {
          blocks[RodMatrices::heat_mass]  = &matrices.mass.block(0, 0);
          blocks[RodMatrices::conduction] = &matrices.stiffness.block(0, 0);
        }
      if (matrices.coupling.n_block_rows() > 0)
        {
          blocks[RodMatrices::divergence]     = &matrices.coupling.block(0, 1);
          blocks[RodMatrices::thermal_stress] = &matrices.coupling.block(1, 0);
        }
      if (discretization.has_field(Field::displacement))
        {
          const unsigned int last = matrices.mass.n_block_rows() - 1;
          blocks[RodMatrices::momentum_mass] = &matrices.mass.block(last, last);
          blocks[RodMatrices::stiffness] = &matrices.stiffness.block(last, last);
          blocks[RodMatrices::viscous_stiffness] =
            matrices.viscous_stiffness.n_block_rows() > 0 ?
              &matrices.viscous_stiffness.block(last, last) :
              blocks[RodMatrices::stiffness];
        }
      return blocks;
    }
  } // namespace



  std::unique_ptr<const RodMatrices>
  make_rod_matrices(const Discretization<1> &discretization,
                    const FieldMatrices<1>  &matrices)
  {
    const RodLayout layout{discretization.n_active_cells(),
                           discretization.degree()};
    if (!is_in_order(discretization, layout))
      return nullptr;
    const auto blocks = blocks_of(discretization, matrices);
    // The sizes of equal cells differ by the rounding of their vertices.
    const double rounding =
      4. * std::numeric_limits<double>::epsilon() * layout.n_cells;
    return std::make_unique<const RodMatrices>(
      layout,
      rounding,
      [&](const RodMatrices::Matrix matrix,
          const unsigned int        row,
          const unsigned int        column) {
        return blocks[matrix] == nullptr ? 0. :
                                           entry(*blocks[matrix], row, column);
      });
  }
} // namespace ThermoContact
