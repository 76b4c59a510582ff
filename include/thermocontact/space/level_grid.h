// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_level_grid_h
#define thermocontact_space_level_grid_h

#include <thermocontact/input/parameters.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <optional>
#include <vector>

namespace ThermoContact
{
  /** A function of one variable at a point. */
  struct ValueAndSlope
  {
    double value;
    double slope;
  };



  /** The polynomial that is 1 at node @p i of @p degree + 1 and 0 at others. */
  ValueAndSlope
  lagrange(const double      *nodes,
           const unsigned int degree,
           const unsigned int i,
           const double       x);



  /** A point of a cell with a pair of its basis functions. */
  struct BasisProduct
  {
    double        x, weight; ///< of the rule of Gauss
    unsigned int  i, j;      ///< nodes of the pair
    ValueAndSlope of_i, of_j;
  };

  /**
   * Calls @p visit(BasisProduct) for each point of the rule of Gauss with
   * @p degree + 1 points in each cell, and each pair of the cell's basis
   * functions: the sum of weight * f(of_i, of_j) is the integral of f over the
   * axis, exact for products of the functions and of their slopes.
   *
   * @param nodes of an axis in rising order, @p degree + 1 to a cell, of which
   *   neighbours share one
   */
  template <typename Visit>
  void
  visit_products(const std::vector<double> &nodes,
                 const unsigned int         degree,
                 const Visit               &visit)
  {
    const dealii::QGauss<1> rule(degree + 1);
    for (unsigned int first = 0; first + 1 < nodes.size(); first += degree)
      for (unsigned int q = 0; q < rule.size(); ++q)
        for (unsigned int i = 0; i <= degree; ++i)
          for (unsigned int j = 0; j <= degree; ++j)
            {
              const double size = nodes[first + degree] - nodes[first];
              const double x    = nodes[first] + rule.point(q)[0] * size;
              visit(BasisProduct{x,
                                 rule.weight(q) * size,
                                 first + i,
                                 first + j,
                                 lagrange(&nodes[first], degree, i, x),
                                 lagrange(&nodes[first], degree, j, x)});
            }
  }



  /**
   * The nodes of a level of multigrid: positions along the body times the same
   * positions in all directions across it. Cells of an axis begin at each
   * degree()-th one. Numbered along the last direction first.
   */
  template <int dim>
  class LevelGrid
  {
  public:
    using Index = std::array<unsigned int, dim>;

    /** The nodes of a body. */
    explicit LevelGrid(const MeshParameters &mesh);

    /**
     * Two cells become one where they are shortest, whatever the direction, so
     * that cells become cubes, and later as wide as a slender body and a few
     * times as long; above degree 2 the cells remain and have degree 2. The
     * nodes are some of those there were. Null: no node can be left out.
     */
    std::optional<LevelGrid>
    coarsened() const;

    /** Of the polynomials on a cell. */
    unsigned int
    degree() const
    {
      return degree_;
    }

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
    unsigned int                       degree_;
  };
} // namespace ThermoContact

#endif
