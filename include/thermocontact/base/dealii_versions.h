// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_dealii_versions_h
#define thermocontact_base_dealii_versions_h

#include <deal.II/base/config.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/point.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/mapping.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <map>

/**
 * @file
 *
 * The versions of deal.II are those of the systems that have a package of
 * it, 9.4.1 (Debian 12), 9.5.1 (Ubuntu 24.04) and 9.6.2 (Debian 13), and those
 * that have been released since, to 9.8, which users install by hand. All
 * sources use what each of them has and none declares deprecated; where there
 * is nothing of that kind, the choice stands here.
 */
namespace ThermoContact
{
  /**
   * Constraints of no degree of freedom yet, that can be of those in @p relevant.
   *
   * @param owned by this process, which 9.6 and later ask for
   */
  inline dealii::AffineConstraints<double>
  make_unconstrained(const dealii::IndexSet &owned,
                     const dealii::IndexSet &relevant)
  {
#if DEAL_II_VERSION_GTE(9, 6, 0)
    return dealii::AffineConstraints<double>(owned, relevant);
#else
    static_cast<void>(owned);
    return dealii::AffineConstraints<double>(relevant);
#endif
  }



  /**
   * Calls @p read with the column and the value of each entry in @p row of
   * @p matrix, which this process owns.
   */
  template <typename Read>
  void
  read_row(const dealii::TrilinosWrappers::SparseMatrix &matrix,
           const dealii::types::global_dof_index         row,
           const Read                                   &read)
  {
#if DEAL_II_VERSION_GTE(9, 6, 0)
    const auto end = matrix.end(row);
    for (auto entry = matrix.begin(row); entry != end; ++entry)
      read(entry->column(), entry->value());
#else
    // Iterators set up arrays of the whole width at each row.
    const auto &entries     = matrix.trilinos_matrix();
    int         n_entries   = 0;
    double     *row_values  = nullptr;
    int        *row_columns = nullptr;
    entries.ExtractMyRowView(
      entries.LRID(static_cast<dealii::TrilinosWrappers::types::int_type>(row)),
      n_entries,
      row_values,
      row_columns);
    for (int i = 0; i < n_entries; ++i)
      read(entries.ColMap().GID64(row_columns[i]), row_values[i]);
#endif
  }



  /** The nodes of the degrees of freedom of this process's cells. */
  template <int dim>
  std::map<dealii::types::global_dof_index, dealii::Point<dim>>
  support_points(const dealii::Mapping<dim>    &mapping,
                 const dealii::DoFHandler<dim> &dof_handler)
  {
#if DEAL_II_VERSION_GTE(9, 5, 0)
    return dealii::DoFTools::map_dofs_to_support_points(mapping, dof_handler);
#else
    std::map<dealii::types::global_dof_index, dealii::Point<dim>> points;
    dealii::DoFTools::map_dofs_to_support_points(mapping, dof_handler, points);
    return points;
#endif
  }
} // namespace ThermoContact

#endif
