// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/rod_cells.h>

#include <limits>

namespace ThermoContact
{
  RodCells::RodCells(const Discretization<1> &discretization)
    : discretization(discretization)
    , layout{discretization.n_active_cells(), discretization.degree()}
    , values(static_cast<std::size_t>(RodMatrices::n_matrices) *
               layout.n_cells * layout.nodes_per_cell() *
               layout.nodes_per_cell(),
             0.)
  {}



  std::size_t
  RodCells::place(const unsigned int matrix,
                  const unsigned int cell,
                  const unsigned int i,
                  const unsigned int j) const
  {
    const std::size_t n = layout.nodes_per_cell();
    return ((static_cast<std::size_t>(matrix) * layout.n_cells + cell) * n +
            j) *
             n +
           i;
  }



  bool
  RodCells::is_in_order() const
  {
    const FiniteElement<1>              &fe = discretization.finite_element();
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    unsigned int                         c = 0;
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (const Field::Block field : all_fields)
          for (unsigned int i = 0;
               discretization.has_field(field) && i < layout.nodes_per_cell();
               ++i)
            if (dofs[fe.component_to_system_index(
                  discretization.first_component(field), i)] !=
                discretization.first_dof(field) + layout.node(c, i))
              return false;
        ++c;
      }
    return true;
  }



  void
  RodCells::add(const RodMatrices::Matrix matrix,
                const unsigned int        cell,
                const Field::Block        row_field,
                const Field::Block        column_field,
                const FullMatrix<double> &cell_matrix)
  {
    const FiniteElement<1> &fe  = discretization.finite_element();
    const unsigned int      row = discretization.first_component(row_field);
    const unsigned int column   = discretization.first_component(column_field);
    for (unsigned int i = 0; i < layout.nodes_per_cell(); ++i)
      for (unsigned int j = 0; j < layout.nodes_per_cell(); ++j)
        values[place(matrix, cell, i, j)] +=
          cell_matrix(fe.component_to_system_index(row, i),
                      fe.component_to_system_index(column, j));
  }



  void
  RodCells::add_diagonal(const RodMatrices::Matrix of_temperature,
                         const RodMatrices::Matrix of_displacement,
                         const unsigned int        cell,
                         const FullMatrix<double> &cell_matrix)
  {
    if (discretization.has_field(Field::temperature))
      add(of_temperature,
          cell,
          Field::temperature,
          Field::temperature,
          cell_matrix);
    if (discretization.has_field(Field::displacement))
      add(of_displacement,
          cell,
          Field::displacement,
          Field::displacement,
          cell_matrix);
  }



  void
  RodCells::add_exchange(const unsigned int        cell,
                         const FullMatrix<double> &cell_matrix)
  {
    for (const auto matrix :
         {RodMatrices::conduction, RodMatrices::heat_exchange})
      add(matrix, cell, Field::temperature, Field::temperature, cell_matrix);
  }



  std::unique_ptr<const RodMatrices>
  RodCells::make() const
  {
    // The sizes of equal cells differ by the rounding of their vertices.
    const double rounding =
      4. * std::numeric_limits<double>::epsilon() * layout.n_cells;
    return std::make_unique<const RodMatrices>(
      layout,
      rounding,
      [this](const RodMatrices::Matrix matrix,
             const unsigned int        cell,
             const unsigned int        i,
             const unsigned int        j) {
        return values[place(matrix, cell, i, j)];
      });
  }
} // namespace ThermoContact
