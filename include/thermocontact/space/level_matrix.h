// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_level_matrix_h
#define thermocontact_space_level_matrix_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/geometry.h>
#include <thermocontact/space/lanes.h>
#include <thermocontact/space/level_grid.h>
#include <thermocontact/space/level_operator.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /**
   * The matrices (D1.5) of the elements of a grid, of degree 1 or 2: sums of
   * products of banded matrices of its directions, by which they are
   * multiplied, plane across the body by plane. Without heat exchange and
   * constraints.
   *
   * As LevelOperator of a coarser level, whole on every rank and with a
   * consistent mass: a coarse contact node stands for nodes with mass, too;
   * without, residuals of those would move it without resistance in a short
   * stage.
   */
  template <int dim, typename Number>
  class LevelMatrix : public LevelOperator<Number>
  {
  public:
    /** Of a coarser level; vectors have the components of a node together. */
    LevelMatrix(const Scene          &scene,
                const Geometry<dim>  &geometry,
                const LevelGrid<dim> &grid);

    /** First entries of the nodes of a grid in vectors of the fields. */
    using Entries = std::array<std::vector<unsigned int>, 2>;

    /**
     * Of a body, for add() alone: a lumped mass left out, and that of axial
     * displacements in the last cells where contact nodes have none.
     */
    LevelMatrix(const Scene          &scene,
                const Geometry<dim>  &geometry,
                const LevelGrid<dim> &grid,
                Entries               entries);

    LevelVector<Number>
    make_vector(const Field::Block field) const override;

    void
    vmult(const Field::Block         field,
          const double               mass,
          const double               stiffness,
          LevelVector<Number>       &y,
          const LevelVector<Number> &x) const override;

    /** Those of vmult(), and $D$ and $D^T$. */
    enum Operator : unsigned int
    {
      heat,
      momentum,
      divergence,
      thermal_stress
    };

    /** Adds the product. @param mass,stiffness 0 and 1 for $D$ and $D^T$ */
    void
    add(const Operator op,
        const double   mass,
        const double   stiffness,
        Number        *y,
        const Number  *x) const;

    /**
     * Calls @p visit(row, column, value) for all entries of the matrix of
     * vmult() on a coarser level.
     */
    template <typename Visit>
    void
    visit_entries(const Field::Block field,
                  const double       mass,
                  const double       stiffness,
                  const Visit       &visit) const
    {
      const unsigned int      n        = n_components(field);
      const std::vector<Term> of_field = terms(of(field));
      for (unsigned int node = 0; node < grid.n_nodes(); ++node)
        for (int k = 0; k < power_of(width, dim); ++k)
          {
            const auto                    place = grid.index(node);
            int                           other = node;
            std::array<unsigned int, dim> neighbour; // from the first one on
            bool                          is_there = true;
            for (unsigned int d = 0; d < dim; ++d)
              {
                neighbour[d] = k / power_of(width, d) % width;
                is_there =
                  is_there && place[d] + neighbour[d] >= degree &&
                  place[d] + neighbour[d] < grid.positions(d).size() + degree;
                other +=
                  (int(neighbour[d]) - int(degree)) * int(grid.strides()[d]);
              }
            if (!is_there)
              continue;
            std::array<std::array<double, dim>, dim> values{};
            for (const Term &term : of_field)
              {
                double value = term.mass * mass + term.stiffness * stiffness;
                for (unsigned int d = 0; d < dim; ++d)
                  value *= axes[d > 0][term.kinds[d]][neighbour[d]][place[d]];
                values[term.row][term.column] += value;
              }
            for (unsigned int c = 0; c < n; ++c)
              for (unsigned int e = 0; e < n; ++e)
                visit(node * n + c, other * n + e, values[c][e]);
          }
    }

  private:
    /** Banded matrices of a direction, integrals of basis functions. */
    enum Kind : unsigned int
    {
      mass_of_all,
      mass_of_axial,
      gradients,  ///< of both
      normal,     ///< stress by strain along the direction
      gradient,   ///< of the second one
      of_test,    ///< of the first one
      dilatation, ///< of the second one, with strain across the mesh
      of_test_dilatation,
      n_kinds
    };

    /** The entry of node i with node i + k - degree at [k][i]. */
    using Banded = std::vector<std::vector<double>>;

    /** A product of matrices, one for each direction, between components. */
    struct Term
    {
      unsigned int          row;
      unsigned int          column;
      std::array<Kind, dim> kinds;
      double                mass; ///< part of the factor of the mass
      double                stiffness;
    };

    /** Combination of planes of a component along the body, to a buffer. */
    struct Sum
    {
      unsigned int      column;
      std::vector<Term> terms; ///< their first kinds and factors
    };

    /** Product within a plane, from one buffer to another. */
    struct Step
    {
      unsigned int direction;
      Kind         kind;
      unsigned int from;
      unsigned int to;
      bool         is_first; ///< else it is added
    };

    struct Plan
    {
      Field::Block              from, to;
      std::vector<Sum>          sums; ///< to the first buffers
      std::vector<Step>         steps;
      std::vector<unsigned int> rows; ///< buffers of the components
      unsigned int              n_buffers;
    };

    static constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;

    const Material       material;
    const LevelGrid<dim> grid;
    const unsigned int   degree;
    const unsigned int   width; ///< of the bands
    const bool           has_mass;
    const Entries        entries;
    const unsigned int   n_plane; ///< nodes of a plane across the body
    const unsigned int   margin;  ///< between planes, for neighbours
    const unsigned int   length;  ///< of a plane, filled up

    std::array<std::array<Banded, n_kinds>, 2> axes; ///< along, across

    /** Those across, for each node of a plane; see coefficient(). */
    AlignedVector<Number> coefficients;
    std::array<Plan, 4>   plans;

    mutable AlignedVector<Number> planes, buffers;

    static unsigned int
    n_components(const Field::Block field)
    {
      return field == Field::temperature ? 1 : dim;
    }

    static Operator
    of(const Field::Block field)
    {
      return field == Field::temperature ? heat : momentum;
    }

    /** Place of the first one in @p coefficients. */
    std::size_t
    coefficient(const unsigned int direction, const Kind kind) const
    {
      return std::size_t((direction - 1) * n_kinds + kind) * width * length;
    }

    LevelMatrix(const Scene          &scene,
                const Geometry<dim>  &geometry,
                const LevelGrid<dim> &grid,
                Entries               entries,
                const bool            has_mass,
                const bool            has_massless_nodes);

    /** The integrals over the cells of a direction. */
    void
    integrate(const Geometry<dim> &geometry,
              const bool           is_across,
              const bool           has_massless_nodes);

    std::vector<Term>
    terms(const Operator op) const;

    /** add() with bands of a known width. */
    template <unsigned int width>
    void
    add_planes(const Operator op,
               const double   mass,
               const double   stiffness,
               Number        *y,
               const Number  *x) const;

    Plan
    make_plan(const Operator op) const;
  };
} // namespace ThermoContact

#endif
