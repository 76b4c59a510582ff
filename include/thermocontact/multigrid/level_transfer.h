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
   * Linear interpolation from a grid, whose vectors are whole on every rank, to
   * the next finer level, which has its nodes and others.
   */
  template <int dim, typename Number>
  class LevelTransfer
  {
  public:
    /**
     * @param coarse its vectors have the components of a node together
     * @param fine what the local part of a vector of the finer level has
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

    /** The transpose, in place of @p coarse. Collective. */
    void
    restrict_to(LevelVector<Number>       &coarse,
                const LevelVector<Number> &fine) const;

  private:
    /** Corners of the coarse cell that a node is in. */
    static constexpr unsigned int n_corners = 1U << dim;

    /**
     * Of a node between nodes of the coarse grid along some directions, the
     * bits of @p between; the corners that it depends on differ there alone.
     */
    struct Entry
    {
      unsigned int                  between;
      unsigned int                  first; ///< of the coarse vector
      std::array<Number, dim>       place; ///< from there, in parts of the cell
      std::array<unsigned int, dim> rows;  ///< of components in the fine vector
    };

    std::vector<Entry>                  entries; ///< by @p between
    std::array<unsigned int, n_corners> corners; ///< from the first one
    unsigned int                        n_components;
    MPI_Comm                            communicator = MPI_COMM_SELF;

    /** Calls @p visit(column of the first component, weight) for a node. */
    template <typename Visit>
    void
    visit_weights(const Entry &entry, const Visit &visit) const
    {
      unsigned int corner = 0; // all subsets of the bits
      do
        {
          Number weight = 1;
          for (unsigned int d = 0; d < dim; ++d)
            if ((entry.between >> d & 1U) != 0)
              weight *=
                (corner >> d & 1U) != 0 ? entry.place[d] : 1 - entry.place[d];
          visit(entry.first + corners[corner], weight);
          corner = (corner - entry.between) & entry.between;
        }
      while (corner != 0);
    }

    template <unsigned int n>
    void
    prolongate(Number *fine, const Number *coarse) const;

    template <unsigned int n>
    void restrict(Number *coarse, const Number *fine) const;
  };
} // namespace ThermoContact

#endif
