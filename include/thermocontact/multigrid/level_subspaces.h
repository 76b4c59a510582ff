// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_subspaces_h
#define thermocontact_multigrid_level_subspaces_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/geometry.h>
#include <thermocontact/space/lanes.h>
#include <thermocontact/space/level_grid.h>
#include <thermocontact/space/level_operator.h>

#include <array>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /** A function of one variable, by its values and slopes at nodes. */
  struct Spline
  {
    unsigned int               first_node;
    std::vector<ValueAndSlope> at_nodes;

    /** Of squares of the function, its slope and curvature; f f''. */
    double square, square_of_slope, square_of_curvature, with_curvature;
  };



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



  /** The elements of one axis of a grid. */
  struct AxisElements
  {
    AxisElements(const std::vector<double> &nodes, const unsigned int degree);

    unsigned int degree;
    unsigned int n_nodes;

    /**
     * Symmetric matrices; of node i with node i - k at i (degree + 1) + k.
     */
    std::vector<double> mass, stiffness;

    /** A basis of the continuously differentiable functions. */
    std::vector<Spline> splines;

    /** Values at nodes by factors of splines, of @p of (value and slope). */
    template <typename Number, typename Of>
    Band<Number>
    splines_at_nodes(const Of &of) const;

  private:
    void
    make_splines(const std::vector<double> &nodes);
  };



  /**
   * What smoothers correct on its own in the displacements of a level,
   * doc/discretisation.md section 8: each component along each line of nodes in
   * its direction, and flows without dilatation, the curls of products of
   * splines.
   *
   * Ranks do it for planes of one direction each, one of them in two
   * dimensions, with whole vectors.
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
     * @param values what its local part has
     */
    LevelSubspaces(const LevelGrid<dim>               &grid,
                   const Material                     &material,
                   const LevelVector<Number>          &prototype,
                   const std::vector<NodalValue<dim>> &values);

  private:
    template <int, typename>
    friend class SubspaceFactors;

    /**
     * Planes of nodes along the axes @p a and @p b. As many as @p width next to
     * each other are treated together: a node has as many places there.
     */
    struct Plane
    {
      unsigned int a, b, across;
      bool         has_lines_along_b; ///< or those along @p a alone
      std::size_t  n_places;
    };

    static constexpr unsigned int width = dim == 3 ? Lanes<float>::n_lanes : 1;

    const Material                   &material;
    const std::array<AxisElements, 2> axes; ///< along, across
    const unsigned int                n_nodes;
    std::array<unsigned int, 3>       shape;   ///< nodes in each direction
    std::array<unsigned int, 3>       strides; ///< of nodes
    std::vector<Plane>                planes;  ///< of this rank

    /** With whole vectors. */
    std::shared_ptr<const Utilities::MPI::Partitioner> partitioner;

    /** Local entries of such vectors, component by component. */
    std::vector<unsigned int> entries;

    /** Values and slopes of the splines of an axis at its nodes. */
    struct AxisBands
    {
      Band<Number> value, slope, value_transposed, slope_transposed;
    };

    std::array<AxisBands, 2> bands;

    const AxisElements &
    axis(const unsigned int direction) const
    {
      return axes[direction > 0];
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
     * @param rest of the diagonal: mass and springs, at most
     *   Tolerances::stiffest_spring, where values are held and become 0
     */
    SubspaceFactors(const LevelSubspaces<dim, Number> &spaces,
                    const double                       stiffness,
                    const Vector                      &rest);

    /** In place: right-hand side to corrections. Collective. */
    void
    apply(LevelVector<Number> &vector) const;

  private:
    using Plane = typename LevelSubspaces<dim, Number>::Plane;

    struct Lines
    {
      std::vector<Number> inverse_pivots;
      std::vector<Number> multipliers; ///< with nodes before, place by place
    };

    struct OfPlane
    {
      Lines               along_a, along_b;
      std::vector<Number> inverse_energies;
    };

    const LevelSubspaces<dim, Number> &spaces;
    std::vector<OfPlane>               factors;

    mutable std::vector<Number>                  from, to;      ///< by nodes
    mutable std::array<std::vector<Number>, 2>   values, flows; ///< of planes
    mutable std::vector<Number>                  half;
    mutable std::unique_ptr<LevelVector<Number>> whole; ///< of several ranks

    /** Calls @p visit(place, node) for the nodes of planes @p first to ... */
    template <typename Visit>
    void
    visit_places(const Plane       &plane,
                 const unsigned int first,
                 const Visit       &visit) const;

    void
    factorize(const Plane               &plane,
              const bool                 is_along_a,
              const double               stiffness,
              const std::vector<double> &rest,
              Lines                     &lines) const;

    void
    compute_energies(const Plane               &plane,
                     const double               stiffness,
                     const std::vector<double> &rest,
                     std::vector<Number>       &inverse) const;

    void
    apply(const Plane &plane, const OfPlane &factors) const;
  };
} // namespace ThermoContact

#endif
