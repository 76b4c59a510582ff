// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_transfer_h
#define thermocontact_multigrid_level_transfer_h

#include <thermocontact/base/types.h>
#include <thermocontact/multigrid/level_grid.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /** A vector of one field on a level of a V-cycle. */
  template <typename Number>
  using LevelVector = LinearAlgebra::distributed::Vector<Number>;

  /** Where the values of a node are in the vector of a field. */
  template <int dim>
  struct LevelNode
  {
    unsigned int                  position; ///< of the first component
    unsigned int                  stride;   ///< to the next component
    std::array<unsigned int, dim> index;    ///< in the grid
  };



  /**
   * From a grid to the next finer one, whose nodes have its nodes among them.
   * Vectors of the coarse grid are whole on every rank.
   */
  template <int dim, typename Number>
  class LevelTransfer
  {
  public:
    /** @param nodes owned by this rank, of the finer grid */
    void
    reinit(const LevelGrid<dim>         &coarse,
           const LevelGrid<dim>         &fine,
           std::vector<LevelNode<dim>> &&nodes,
           const unsigned int            n_components,
           const MPI_Comm                communicator);

    /** Adds the values of a coarse vector at the nodes of the finer grid. */
    void
    prolongate_and_add(LevelVector<Number>       &fine,
                       const LevelVector<Number> &coarse) const;

    /** The transpose, in place of @p coarse. Collective. */
    void
    restrict_to(LevelVector<Number>       &coarse,
                const LevelVector<Number> &fine) const;

    /** The values at the nodes that both have. Collective. */
    void
    inject(LevelVector<Number> &coarse, const LevelVector<Number> &fine) const;

  private:
    /** What nodes of the finer axis take from the coarse one. */
    struct Axis
    {
      std::vector<unsigned int> first; ///< coarse nodes
      std::vector<Number>       weights;
      unsigned int              n_weights; ///< of a node
    };

    std::array<Axis, 2>           axes; ///< along, across
    std::array<unsigned int, dim> strides;
    std::vector<LevelNode<dim>>   nodes;
    unsigned int                  n_components = 0;
    MPI_Comm                      communicator = MPI_COMM_SELF;

    /** Calls @p visit(coarse entry, weight) for what a node takes. */
    template <typename Visit>
    void
    visit_weights(const LevelNode<dim> &node, const Visit &visit) const;

    void
    sum_over_ranks(LevelVector<Number> &coarse) const;
  };
} // namespace ThermoContact

#endif
