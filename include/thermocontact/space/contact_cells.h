// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_contact_cells_h
#define thermocontact_space_contact_cells_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>

#include <deal.II/lac/full_matrix.h>

#include <deal.II/matrix_free/matrix_free.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /**
   * What differs in the cells at the contact end, for products without
   * matrices: the heat exchange, and contact nodes without mass (C1.1). Small
   * dense matrices of each cell; values of a cell are in lexicographic order,
   * component by component, as in FEEvaluation.
   */
  template <int dim>
  class ContactCells
  {
  public:
    using Values = AlignedVector<VectorizedArray<double>>;

    ContactCells(const Scene &scene, const Discretization<dim> &discretization);

    /** True if this batch has cells at the contact end. */
    bool
    contain(const unsigned int batch) const
    {
      return !cells_of_batch[batch].empty();
    }

    /** Adds @p factor times $kB$ to @p y. */
    void
    add_heat_exchange(const unsigned int             batch,
                      const double                   factor,
                      const VectorizedArray<double> *x,
                      VectorizedArray<double>       *y) const;

    /**
     * What is left of the axial mass that quadrature gives the cells of a
     * batch: 0 for cells that have that of add_axial_mass() instead, else 1.
     */
    VectorizedArray<double>
    share_of_axial_mass(const unsigned int batch) const;

    /**
     * Adds @p factor times the axial mass of cells whose contact nodes have
     * none; axial component first. Their rows are zero, not a difference that
     * is: in short stages they have nothing but stiffness, which is smaller
     * than the rounding of a mass.
     */
    void
    add_axial_mass(const unsigned int             batch,
                   const double                   factor,
                   const VectorizedArray<double> *x,
                   VectorizedArray<double>       *y) const;

    /**
     * Calls @p visit(cell, matrix) for the matrices of a field: those of heat
     * exchange, or of the axial mass.
     *
     * @param cells of the same mesh
     */
    template <typename Visit>
    void
    visit_matrices(const Field::Block     field,
                   const MatrixFree<dim> &cells,
                   const Visit           &visit) const
    {
      const std::vector<FullMatrix<double>> &matrices =
        field == Field::temperature ? heat_exchange : axial_mass;
      if (!matrices.empty())
        for (unsigned int batch = 0; batch < cells_of_batch.size(); ++batch)
          for (const Cell &cell : cells_of_batch[batch])
            visit(cells.get_cell_iterator(batch, cell.lane),
                  matrices[cell.matrix]);
    }

  private:
    const unsigned int n_nodes; ///< of a cell

    /** A cell at the end: its place in a batch, and that of its matrices. */
    struct Cell
    {
      unsigned int lane;
      unsigned int matrix;
    };

    std::vector<std::vector<Cell>> cells_of_batch;

    std::vector<FullMatrix<double>> heat_exchange;
    std::vector<FullMatrix<double>> axial_mass;

    /** Those of the cells at the end, in the order of their batches. */
    void
    compute_matrices(
      const Scene                                                       &scene,
      const Discretization<dim>                                         &space,
      const std::vector<typename DoFHandler<dim>::active_cell_iterator> &cells);

    void
    add(const FullMatrix<double>      &matrix,
        const double                   factor,
        const unsigned int             lane,
        const VectorizedArray<double> *x,
        VectorizedArray<double>       *y) const;
  };
} // namespace ThermoContact

#endif
