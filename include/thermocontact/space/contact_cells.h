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
   * What differs in the cells at the contact end and at lateral faces, for
   * products without matrices: the heat exchange through these faces, and
   * contact nodes without mass (C1.1). Small dense matrices of each cell;
   * values of a cell are in lexicographic order, component by component, as in
   * FEEvaluation.
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
      return is_at_end[batch];
    }

    /** True if it has lateral faces that exchange heat. */
    bool
    exchange_laterally(const unsigned int batch) const
    {
      return !lateral_exchange[batch].empty();
    }

    /** Adds @p factor times $L$ to @p y. */
    void
    add_lateral_exchange(const unsigned int             batch,
                         const double                   factor,
                         const VectorizedArray<double> *x,
                         VectorizedArray<double>       *y) const
    {
      add(lateral_exchange[batch], factor, x, y);
    }

    /** Adds @p factor times $kB+L$ to @p y. */
    void
    add_heat_exchange(const unsigned int             batch,
                      const double                   factor,
                      const VectorizedArray<double> *x,
                      VectorizedArray<double>       *y) const
    {
      add(heat_exchange[batch], factor, x, y);
      add_lateral_exchange(batch, factor, x, y);
    }

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
                   VectorizedArray<double>       *y) const
    {
      add(axial_mass[batch], factor, x, y);
    }

    /**
     * Calls @p visit(cell, nodes, matrix) for the matrices of a field: those of
     * heat exchange, or of the axial mass, between some nodes of a cell.
     *
     * @param cells of the same mesh
     */
    template <typename Visit>
    void
    visit_matrices(const Field::Block     field,
                   const MatrixFree<dim> &cells,
                   const Visit           &visit) const
    {
      const auto visit_all = [&](const Matrices &matrices) {
        for (unsigned int batch = 0; batch < matrices.size(); ++batch)
          for (const LaneMatrix &of_cell : matrices[batch])
            visit(cells.get_cell_iterator(batch, of_cell.lane),
                  of_cell.nodes,
                  of_cell.matrix);
      };
      if (field == Field::displacement)
        visit_all(axial_mass);
      else
        {
          visit_all(heat_exchange);
          visit_all(lateral_exchange);
        }
    }

  private:
    /** A matrix between some nodes of a cell of a batch. */
    struct LaneMatrix
    {
      unsigned int              lane; ///< the cell's place in its batch
      std::vector<unsigned int> nodes;
      FullMatrix<double>        matrix;
    };

    using Matrices = std::vector<std::vector<LaneMatrix>>; ///< of all batches

    std::vector<bool> is_at_end; ///< batches
    Matrices          heat_exchange;
    Matrices          lateral_exchange;
    Matrices          axial_mass;

    void
    add(const std::vector<LaneMatrix> &matrices,
        const double                   factor,
        const VectorizedArray<double> *x,
        VectorizedArray<double>       *y) const;
  };
} // namespace ThermoContact

#endif
