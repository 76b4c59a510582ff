// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_transfer_h
#define thermocontact_multigrid_level_transfer_h

#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/level_grid.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /**
   * Interpolation by the elements of a grid, whose vectors are whole on every
   * rank, at the next finer level, which has its nodes and others.
   */
  template <int dim, typename Number>
  class LevelTransfer
  {
  public:
    /**
     * @param coarse its vectors have the components of a node together
     * @param fine values of the local part of a vector of the finer level
     */
    void
    reinit(const LevelGrid<dim>               &coarse,
           const std::vector<NodalValue<dim>> &fine,
           const unsigned int                  n_components,
           const MPI_Comm                      communicator);

    /** Adds the values of a coarse vector at the nodes of the finer grid. */
    void
    prolongate_and_add(LevelVector<Number>       &fine,
                       const LevelVector<Number> &coarse) const;

    /**
     * The transpose, in place of @p coarse. Collective.
     *
     * @param is_diagonal by the absolute values of the weights, since those of
     *   degree 2 have both signs: of a diagonal what is positive stays so, and
     *   it is no less than the row sums of its product between two transfers
     */
    void
    restrict_to(LevelVector<Number>       &coarse,
                const LevelVector<Number> &fine,
                const bool                 is_diagonal = false) const;

    /** The values of the nodes of the grid, in place of @p coarse. Collective.
     */
    void
    inject_to(LevelVector<Number>       &coarse,
              const LevelVector<Number> &fine) const;

  private:
    /**
     * Of a node between nodes of the coarse grid along some directions, the
     * bits of @p between: it depends on all nodes of the cell there, on one
     * along the others.
     */
    struct Entry
    {
      unsigned int                           between;
      unsigned int                           first; ///< of the coarse vector
      std::array<std::array<Number, 3>, dim> weights;
      std::array<unsigned int, dim> rows; ///< of components in the fine vector
    };

    std::vector<Entry>          entries; ///< by @p between
    std::array<unsigned int, 3> strides; ///< to the next node of the grid
    unsigned int                degree;
    unsigned int                n_components;
    MPI_Comm                    communicator = MPI_COMM_SELF;

    void
    sum_over_ranks(LevelVector<Number> &coarse) const;

    /** Calls @p visit(entry of the coarse vector, weight). */
    template <typename Visit>
    void
    visit_weights(const Entry &entry, const Visit &visit) const
    {
      const auto last = [&](const unsigned int d) {
        return (entry.between >> d & 1U) != 0 ? degree : 0U;
      };
      for (unsigned int i = 0; i <= last(0); ++i)
        for (unsigned int j = 0; j <= last(1); ++j)
          for (unsigned int k = 0; k <= last(2); ++k)
            visit(entry.first + i * strides[0] + j * strides[1] +
                    k * strides[2],
                  entry.weights[0][i] * entry.weights[1][j] *
                    (dim == 3 ? entry.weights[dim - 1][k] : Number(1)));
    }

    template <unsigned int n>
    void
    prolongate(Number *fine, const Number *coarse) const;

    template <unsigned int n>
    void restrict(Number       *coarse,
                  const Number *fine,
                  const bool    is_diagonal) const;
  };
} // namespace ThermoContact

#endif
