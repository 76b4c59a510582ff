// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_level_grid_h
#define thermocontact_space_level_grid_h

#include <thermocontact/input/parameters.h>

#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <vector>

namespace ThermoContact
{
  /**
   * The nodes of a level of multigrid: positions along the body times the same
   * positions in all directions across it. Numbered along the last direction
   * first.
   */
  template <int dim>
  class LevelGrid
  {
  public:
    using Index = std::array<unsigned int, dim>;

    /** Those of a body. */
    explicit LevelGrid(const MeshParameters &mesh);

    /**
     * Each second node left out where they are nearest to each other, whatever
     * the direction; where has_lines(), distances across the body alone count.
     * Cells become cubes. Null: no node can be left out.
     */
    std::optional<LevelGrid>
    coarsened() const;

    /**
     * Nodes are nearer to each other along the body than across it, so that
     * smoothers solve for lines of them, LevelLines.
     */
    bool
    has_lines() const;

    /** Ascending. */
    const std::vector<double> &
    positions(const unsigned int direction) const
    {
      return axes[direction > 0];
    }

    unsigned int
    n_nodes() const;

    /** From a node to the next one along a direction. */
    Index
    strides() const;

    Index
    index(unsigned int node) const;

    dealii::Point<dim>
    node(const Index &index) const;

    /** Of the node at a point, to rounding. */
    unsigned int
    number(const dealii::Point<dim> &node) const;

  private:
    std::array<std::vector<double>, 2> axes; ///< along, across
  };
} // namespace ThermoContact

#endif
