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
#include <map>
#include <utility>
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
    /** First entries of the nodes of a grid in vectors of the fields. */
    using Entries = std::array<std::vector<unsigned int>, 2>;

    /**
     * @param of_body null: of a coarser level, whose vectors have the
     *   components of a node together. Else where the body has its values for
     *   add(): a lumped mass is left out, and that of axial displacements in
     *   the last cells where contact nodes have none.
     */
    LevelMatrix(const Scene          &scene,
                const Geometry<dim>  &geometry,
                const LevelGrid<dim> &grid,
                const Entries        *of_body = nullptr);

    LevelVector<Number>
    make_vector(const Field::Block field) const override;

    void
    vmult(const Field::Block         field,
          const double               mass,
          const double               stiffness,
          LevelVector<Number>       &y,
          const LevelVector<Number> &x) const override;

    LevelVector<Number>
    diagonal(const Field::Block field,
             const double       mass,
             const double       stiffness) const override;

    /** No entries of vmult() are farther from the diagonal. */
    unsigned int
    band(const Field::Block field) const;

    /** Operators of vmult(), $D$, $D^T$ and the Laplacian of the mesh. */
    enum Operator : unsigned int
    {
      heat,
      momentum,
      divergence,
      thermal_stress,
      laplacian
    };

    static Operator
    of(const Field::Block field)
    {
      return field == Field::temperature ? heat : momentum;
    }

    /**
     * Adds the product.
     *
     * @param stiffness factor of all that is no mass
     * @param replaces @p y is the product alone, whatever it was
     */
    void
    add(const Operator op,
        const double   mass,
        const double   stiffness,
        Number        *y,
        const Number  *x,
        const bool     replaces = false) const;

    /** True if the entries of the nodes are all of a vector of a field. */
    bool
    covers(const Field::Block field, const std::size_t n_entries) const
    {
      return grid.n_nodes() * n_components<dim>(field) == n_entries;
    }

    /** On the diagonal of a component. */
    double
    diagonal_entry(const Operator                        op,
                   const unsigned int                    row,
                   const typename LevelGrid<dim>::Index &index,
                   const double                          mass,
                   const double                          stiffness) const;

    const LevelGrid<dim> grid;

  private:
    /** Banded matrices of a direction, integrals of basis functions. */
    enum Kind : unsigned int
    {
      nothing,
      mass_of_all,
      mass_of_axial,
      gradients,  ///< of both
      normal,     ///< stress by strain along the direction
      gradient,   ///< of the second one
      of_test,    ///< of the first one
      dilatation, ///< of the second one, with strain across the mesh
      of_test_dilatation,
      mass_of_mesh, ///< without the weight of a geometry
      gradients_of_mesh,
      n_kinds
    };

    /** The entry of node i with node i + k - degree at [k][i]. */
    using Banded = std::vector<std::vector<double>>;

    /** A component times a matrix along the body, or those of a stage. */
    struct Line
    {
      unsigned int column;
      Kind         kind;
      Kind         mass; ///< nothing: one matrix alone
      double       factor;
    };

    /** A line times matrices across the body. */
    struct Term
    {
      unsigned int line;
      double       factor; ///< of one matrix alone
      Kind         kind;   ///< along y
    };

    /** The terms of an operator. */
    struct Sum
    {
      std::vector<Line> lines;

      /** By rows and the matrix along the last direction. */
      std::map<std::pair<unsigned int, Kind>, std::vector<Term>> terms;
    };

    static constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;

    /** Each component by four matrices, in make_sums(). */
    static constexpr unsigned int max_lines = 4 * dim;

    const unsigned int degree;
    const unsigned int width; ///< of the bands
    Entries            entries;
    const unsigned int n_plane; ///< nodes of a plane across the body
    const unsigned int length;  ///< of a plane, filled up
    const std::size_t  stride;  ///< of planes, with room for neighbours

    std::array<std::array<Banded, n_kinds>, 2> axes; ///< along, across
    std::array<Sum, laplacian + 1>             sums;

    /** Those across, for each node of a plane; see coefficient(). */
    mutable AlignedVector<Number> coefficients;

    /** Planes; zero between them and where they are filled up. */
    mutable AlignedVector<Number> scratch;

    /** Place of the first one in @p coefficients. */
    std::size_t
    coefficient(const unsigned int direction, const Kind kind) const
    {
      return std::size_t((direction - 1) * n_kinds + kind) * width * length;
    }

    /** Of a line: an entry of its matrix. */
    double
    along(const Line        &line,
          const double       mass,
          const double       stiffness,
          const unsigned int k,
          const unsigned int i) const
    {
      const double entry = axes[0][line.kind][k][i];
      return line.mass == nothing ? entry :
                                    stiffness * line.factor * entry +
                                      mass * axes[0][line.mass][k][i];
    }

    double
    scale(const Line &line, const Term &term, const double stiffness) const
    {
      return line.mass == nothing ? stiffness * term.factor : 1.;
    }

    void
    integrate(const Geometry<dim> &geometry,
              const Material      &material,
              const bool           is_across,
              const bool           has_massless_nodes);

    /** Makes the planes for add(); once. */
    void
    prepare_planes() const;

    void
    make_sums(const Material &material, const bool has_mass);

    /** add() with bands of a known width. */
    template <unsigned int width>
    void
    add_planes(const Operator op,
               const double   mass,
               const double   stiffness,
               Number        *y,
               const Number  *x,
               const bool     replaces) const;
  };
} // namespace ThermoContact

#endif
