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
    /** How a node depends on those of the coarse grid along one direction: on
     * one at its place, or on all of the cell there. */
    struct Stencil
    {
      unsigned int          n_nodes;
      std::array<Number, 3> weights;
    };

    /** A node of the finer level. */
    struct Entry
    {
      unsigned int first;                 ///< of its nodes in the coarse vector
      std::array<unsigned int, dim> rows; ///< of components in the fine vector
    };

    /** Entries with the same stencils, one behind the other. */
    struct Run
    {
      unsigned int                  end; ///< behind its entries
      std::array<unsigned int, dim> stencils;
    };

    /** The stencils of a run: lines of nodes, which are neighbours in the
     * coarse vector, along the last direction. */
    struct Lines
    {
      unsigned int                n_lines = 0;
      std::array<unsigned int, 9> offsets; ///< to @p first
      std::array<Number, 9>       weights;
      Stencil                     along;
    };

    std::vector<Stencil>        stencils;
    std::vector<Run>            runs;
    std::vector<Entry>          entries;
    std::array<unsigned int, 3> strides{}; ///< to the next node of the grid
    unsigned int                n_components;
    MPI_Comm                    communicator = MPI_COMM_SELF;

    void
    sum_over_ranks(LevelVector<Number> &coarse) const;

    Lines
    lines_of(const Run &run, const bool is_diagonal) const;

    /**
     * Calls @p visit(n, n_along, lines, begin, end) for the entries of each run,
     * with constants of the compiler for the components and the nodes of a
     * line.
     */
    template <typename Visit>
    void
    visit_runs(const bool is_diagonal, const Visit &visit) const;
  };
} // namespace ThermoContact

#endif
