// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_rod_cells_h
#define thermocontact_space_rod_cells_h

#include <thermocontact/rod/rod_matrices.h>
#include <thermocontact/space/discretization.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * Collects the matrices of the cells of a rod in one process while they are
   * assembled. Not the assembled ones: in a row of those the parts of two cells
   * cannot be told apart, and cells that differ by rounding could not be
   * treated as the same without forces on a rod that does not move.
   */
  class RodCells
  {
  public:
    /** @param discretization borrowed */
    explicit RodCells(const Discretization<1> &discretization);

    /**
     * False if cells or nodes are not numbered from one end to the other as
     * RodLayout says.
     */
    bool
    is_in_order() const;

    /**
     * Adds the rows of a field and the columns of another one of the matrix of
     * a cell, in the numbering of the finite element.
     */
    void
    add(const RodMatrices::Matrix matrix,
        const unsigned int        cell,
        const Field::Block        row_field,
        const Field::Block        column_field,
        const FullMatrix<double> &cell_matrix);

    /** Adds both diagonal blocks. */
    void
    add_diagonal(const RodMatrices::Matrix of_temperature,
                 const RodMatrices::Matrix of_displacement,
                 const unsigned int        cell,
                 const FullMatrix<double> &cell_matrix);

    /** Adds a heat exchange to the conduction. */
    void
    add_exchange(const unsigned int        cell,
                 const FullMatrix<double> &cell_matrix);

    std::unique_ptr<const RodMatrices>
    make() const;

  private:
    const Discretization<1> &discretization;
    const RodLayout          layout;

    /** Matrix by matrix, cell by cell, column by column. */
    std::vector<double> values;

    std::size_t
    place(const unsigned int matrix,
          const unsigned int cell,
          const unsigned int i,
          const unsigned int j) const;
  };
} // namespace ThermoContact

#endif
