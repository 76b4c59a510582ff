// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_transfer_h
#define thermocontact_multigrid_level_transfer_h

#include <thermocontact/multigrid/level_grid.h>
#include <thermocontact/space/cell_products.h>

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

    struct Entry
    {
      unsigned int            first; ///< of the coarse vector
      std::array<Number, dim> place; ///< from there, in parts of the cell
    };

    std::vector<Entry>                  entries;
    std::array<unsigned int, n_corners> corners; ///< from the first one
    MPI_Comm                            communicator = MPI_COMM_SELF;

    /** Bit d: whether it is the upper one along direction d. */
    static bool
    is_upper(const unsigned int corner, const unsigned int d)
    {
      return (corner >> d & 1U) != 0;
    }

    static Number
    weight(const Entry &entry, const unsigned int corner)
    {
      Number weight = 1;
      for (unsigned int d = 0; d < dim; ++d)
        weight *= is_upper(corner, d) ? entry.place[d] : 1 - entry.place[d];
      return weight;
    }
  };
} // namespace ThermoContact

#endif
