// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_grid_h
#define thermocontact_multigrid_level_grid_h

#include <thermocontact/input/parameters.h>

#include <array>
#include <optional>
#include <vector>

namespace ThermoContact
{
  /** Cells and polynomials in one direction. */
  struct GridAxis
  {
    unsigned int        degree;
    std::vector<double> ends; ///< of the cells, ascending

    unsigned int
    n_cells() const
    {
      return ends.size() - 1;
    }

    unsigned int
    n_nodes() const
    {
      return degree * n_cells() + 1;
    }

    /** The shortest cell over the degree. */
    double
    shortest() const;

    /** Gauss-Lobatto points of all cells. */
    std::vector<double>
    nodes() const;

    /**
     * Half the degree if its distance of nodes is no larger than @p length;
     * with degree 1, neighbours joined whose sum is not.
     */
    GridAxis
    coarsened(const double length) const;
  };



  /**
   * The boxes and nodes of a level: the product of an axis along the body and
   * of the same axis in all directions across it. Nodes are numbered along the
   * last direction first.
   */
  template <int dim>
  class LevelGrid
  {
  public:
    /** Of a body. */
    explicit LevelGrid(const MeshParameters &mesh);

    /**
     * The next coarser grid: what is shortest doubles first, whatever its
     * direction, so that cells become cubes and smoothers need not treat
     * directions apart. Null: there is none.
     */
    std::optional<LevelGrid>
    coarsened() const;

    const GridAxis &
    axis(const unsigned int direction) const
    {
      return axes[direction > 0];
    }

    unsigned int
    n_nodes() const;

    unsigned int
    number_of_node(const std::array<unsigned int, dim> &index) const;

    /** The largest difference of the numbers of two nodes of a cell. */
    unsigned int
    bandwidth() const;

  private:
    std::array<GridAxis, 2> axes; ///< along, across
  };
} // namespace ThermoContact

#endif
