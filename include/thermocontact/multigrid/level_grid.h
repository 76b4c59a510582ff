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

    /** The shortest and the longest cell over the degree. */
    double
    shortest() const;

    double
    longest() const;

    /** Gauss-Lobatto points of all cells. */
    std::vector<double>
    nodes() const;

    /**
     * Neighbours joined whose sum is no longer than @p length; a degree above 1
     * halved instead. If it is halved where cells are longer than @p across, the
     * shortest distance in the other direction, which has to be coarser first,
     * the nodes are cells of degree 1.
     */
    GridAxis
    coarsened(const double length, const double across) const;
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
