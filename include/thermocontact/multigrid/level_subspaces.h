// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_subspaces_h
#define thermocontact_multigrid_level_subspaces_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/geometry.h>
#include <thermocontact/space/level_grid.h>
#include <thermocontact/space/level_operator.h>

#include <array>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * A matrix of an axis that acts on all lines of an array; as many entries of
   * each row, from a first column.
   */
  template <typename Number>
  struct Band
  {
    unsigned int              n_columns;
    unsigned int              width;
    std::vector<unsigned int> first;
    std::vector<Number>       entries;
  };



  /**
   * The elements of one axis of a grid, and B-splines: a basis of their
   * continuously differentiable functions.
   */
  template <typename Number>
  struct SplineAxis
  {
    SplineAxis(const std::vector<double> &nodes, const unsigned int degree);

    unsigned int degree;
    unsigned int n_nodes;

    /**
     * Symmetric matrices; of node i with node i - k at i (degree + 1) + k.
     */
    std::vector<double> mass, stiffness;

    /** Values and slopes at nodes by factors of splines. */
    Band<Number> value, slope, value_transposed, slope_transposed;

    /** Integrals of products of a spline f. */
    struct Integrals
    {
      double square, square_of_slope, square_of_curvature;
      double with_curvature; ///< f f''
    };

    std::vector<Integrals> integrals;

  private:
    /** Their values and slopes at nodes. */
    void
    make_splines(const std::vector<double> &nodes);
  };



  /**
   * The subspaces that smoothers correct in the displacements of a level,
   * doc/discretisation.md section 8: each component along each line of nodes in
   * its direction, and flows without dilatation, the curls of products of
   * splines.
   *
   * Ranks do it for the lines of one direction each, and flows in the planes of
   * that and the next one, with whole vectors.
   */
  template <int dim, typename Number>
  class LevelSubspaces
  {
  public:
    /** True if smoothers need them: there are such flows, and they are soft. */
    static bool
    are_for(const Scene &scene, const Geometry<dim> &geometry);

    /**
     * @param material borrowed
     * @param prototype of vectors of the level
     * @param values of its local part
     */
    LevelSubspaces(const LevelGrid<dim>               &grid,
                   const Material                     &material,
                   const LevelVector<Number>          &prototype,
                   const std::vector<NodalValue<dim>> &values);

  private:
    template <int, typename>
    friend class SubspaceFactors;

    /**
     * Lines along the axis @p a and planes of @p a and @p b: arrays have nodes
     * or splines of @p a times those of @p b times nodes of @p c. In two
     * dimensions there is one @p c.
     */
    struct Family
    {
      unsigned int a, b, c;

      /** Local entries of whole vectors, of both components. */
      std::vector<unsigned int> of_a, of_b;

      bool has_flows;
    };

    const Material                         &material;
    const std::array<SplineAxis<Number>, 2> axes;     ///< along, across
    std::vector<Family>                     families; ///< of this rank

    /** With whole vectors. */
    std::shared_ptr<const Utilities::MPI::Partitioner> partitioner;

    const SplineAxis<Number> &
    axis(const unsigned int direction) const
    {
      return axes[direction > 0];
    }

    unsigned int
    n_nodes(const unsigned int direction) const
    {
      return direction < dim ? axis(direction).n_nodes : 1;
    }

    /** Diagonal entries of the matrices of a direction. */
    struct Diagonals
    {
      double mass, stiffness;
    };

    Diagonals
    diagonals(const unsigned int direction, const unsigned int node) const
    {
      if (direction == dim)
        return {1., 0.};
      const SplineAxis<Number> &of = axis(direction);
      const unsigned int        at = node * (of.degree + 1);
      return {of.mass[at], of.stiffness[at]};
    }
  };



  /** The inverses of a stage block in these spaces, added up. */
  template <int dim, typename Number>
  class SubspaceFactors
  {
  public:
    /**
     * @param spaces borrowed
     * @param stiffness its factor
     */
    SubspaceFactors(const LevelSubspaces<dim, Number> &spaces,
                    const double                       stiffness);

    /**
     * Makes the parts that depend on the diagonal anew. Collective.
     *
     * @param rest of the diagonal: mass and springs, at most
     *   Tolerances::stiffest_spring, where values are held and become 0
     */
    void
    update(const Vector &rest);

    /** In place: right-hand side to corrections. Collective. */
    void
    apply(LevelVector<Number> &vector) const;

  private:
    using Family = typename LevelSubspaces<dim, Number>::Family;

    struct Factors
    {
      /** Of lines: with the nodes before, place by place. */
      std::vector<Number> multipliers;
      std::vector<Number> inverse_pivots;
      std::vector<Number> inverse_energies; ///< of flows
    };

    const LevelSubspaces<dim, Number> &spaces;
    const double                       stiffness;
    Vector                             rest; ///< whole; -1: not yet
    std::vector<Factors>               factors;

    /** Arrays of a family, that of @p a between zeros; whole vectors. */
    mutable std::vector<Number> values_a, values_b, half, flows, other_flows;
    mutable std::vector<Number> sum;
    mutable std::unique_ptr<LevelVector<Number>> whole; ///< of several ranks

    /** Lines where @p new_rest differs. */
    void
    factorize(const Family &family, const Vector &new_rest, Factors &factors);

    void
    compute_energies(const Family &family, std::vector<Number> &inverse) const;

    /** Adds to #sum. */
    void
    apply(const Family  &family,
          const Factors &factors,
          const Number  *vector) const;
  };
} // namespace ThermoContact

#endif
