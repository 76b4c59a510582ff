// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_cell_products_h
#define thermocontact_space_cell_products_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/cell_matrices.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/lanes.h>
#include <thermocontact/space/level_matrix.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * Products with the matrices (D1.5) of a body without constraints: cell by
   * cell, by sums over one direction after the other and with several cells at
   * a time in the lanes of SIMD instructions; of degree 1 on one rank by
   * LevelMatrix. To the rounding of @p Number, float for preconditioners. For
   * meshes whose cells are boxes along the axes, as all of a Discretization
   * are.
   *
   * Vectors come from Discretization::make_vector() or make_vector(); @p y is
   * replaced. Products are collective.
   */
  template <int dim, typename Number>
  class CellProducts : public LevelOperator<Number>
  {
  public:
    /** Both references are borrowed. */
    CellProducts(const Scene &scene, const Discretization<dim> &discretization);

    LevelVector<Number>
    make_vector(const Field::Block field) const override;

    /** @p y = (@p mass M + @p stiffness (K + kB + L)) @p x, or $M_u$ and $S$. */
    void
    vmult(const Field::Block         field,
          const double               mass,
          const double               stiffness,
          LevelVector<Number>       &y,
          const LevelVector<Number> &x) const override;

    /** @p y += the same. */
    void
    add(const Field::Block         field,
        const double               mass,
        const double               stiffness,
        LevelVector<Number>       &y,
        const LevelVector<Number> &x) const;

    /** The Laplacian of the mesh, of each component of a field. */
    void
    laplacian(const Field::Block         field,
              LevelVector<Number>       &y,
              const LevelVector<Number> &x) const;

    /** @p heat += @p factor $Du$. */
    void
    add_divergence(const double               factor,
                   LevelVector<Number>       &heat,
                   const LevelVector<Number> &u) const;

    /** @p momentum += @p factor $D^T\theta$. */
    void
    add_thermal_stress(const double               factor,
                       LevelVector<Number>       &momentum,
                       const LevelVector<Number> &theta) const;

    /** @p y += @p factor $Lx$, the heat exchange of lateral faces. */
    void
    add_lateral_exchange(const double               factor,
                         LevelVector<Number>       &y,
                         const LevelVector<Number> &x) const;

    /**
     * The part of @p y $=Sx$ by the cells at the contact end: all of it at its
     * nodes, and for @p x that is zero at all others.
     */
    void
    contact_stiffness(LevelVector<Number>       &y,
                      const LevelVector<Number> &x) const;

    /**
     * @p y += @p factor $(S_\zeta-S)$ @p x, $S_\zeta=\Pi^TS\Pi$ (C6.1), by the
     * cells at the contact end alone; nothing where contact nodes are viscous.
     */
    void
    add_contact_viscosity(const double               factor,
                          LevelVector<Number>       &y,
                          const LevelVector<Number> &x) const;

    /** The diagonal of the matrix of vmult(). Collective. */
    LevelVector<Number>
    diagonal(const Field::Block field,
             const double       mass,
             const double       stiffness) const override;

    LevelVector<Number>
    laplacian_diagonal(const Field::Block field) const;

    static constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;

  private:
    /** Cells that are treated together; arrays of lanes are aligned. */
    struct alignas(THERMOCONTACT_LANE_BYTES) Batch
    {
      std::array<std::array<Number, n_lanes>, dim> inverse_size;
      std::array<Number, n_lanes>                  volume;
      unsigned int                                 n_cells; ///< lanes in use
      bool has_axial_mass; ///< false: contact nodes without mass are there
    };

    /** Entries of a matrix at local positions. */
    struct Entry
    {
      unsigned int row;
      unsigned int column;
      Number       value;
    };

    /** A field in the cells. */
    struct FieldCells
    {
      /** Positions of the first component, nodes by nodes of the batches. */
      std::vector<unsigned int> positions;

      /** $kB$, or the axial mass of cells with contact nodes without mass. */
      std::vector<Entry> at_end;

      /** $L$. */
      std::vector<Entry> at_sides;

      LevelVector<Number> prototype;
      LevelVector<Number> lumped_mass; ///< or empty
    };

    /** The terms of a sum over the points of cells. */
    struct Factors
    {
      double mass;
      double stiffness;
      bool   is_at_end = false; ///< of the cells at the contact end alone

      /** On which heat and Laplacian act. */
      Field::Block field     = Field::temperature;
      unsigned int component = 0;
    };

    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    const Discretization<dim> &discretization;
    const Geometry<dim>       &geometry;
    const Material            &material;
    const unsigned int         n;       ///< nodes in one direction
    const unsigned int         n_nodes; ///< of a cell
    const bool                 has_lumped_mass;
    const bool                 has_elastic_contact_nodes;
    const bool                 is_by_planes; ///< of degree 1 on one rank

    /** Of the nodes of a cell, which are numbered by vertices, lines, ... */
    std::vector<unsigned int> lexicographic;
    /** From a component of a node to the next one, by lexicographic order. */
    std::vector<unsigned int> strides;

    std::vector<Batch>        batches; ///< those at the contact end last
    unsigned int              first_at_end = 0;
    std::array<FieldCells, 2> fields;
    std::vector<Entry>        extension; ///< $\Pi$ at contact nodes of the rank

    using OnGrid   = LevelMatrix<dim, Number>;
    using Operator = typename OnGrid::Operator;

    /** For diagonals, and in place of sums over cells if is_by_planes. */
    std::unique_ptr<const OnGrid> on_grid;

    /**
     * Values of basis functions at quadrature points (q, i) and the transpose,
     * derivatives of the polynomials of the points there (q, r) and the
     * transpose, and weights of the points of a cell; all lanes are the same.
     */
    AlignedVector<Number> values, values_transposed;
    AlignedVector<Number> derivatives, derivatives_transposed;
    AlignedVector<Number> weights;

    /** Weight and strain per displacement in the rows of points of a batch. */
    AlignedVector<Number> radial;

    mutable AlignedVector<Number> scratch;

    /** $\Pi x$ and $S\Pi x$. */
    mutable LevelVector<Number> extended_scratch, pushed_scratch;

    /** Of a degree of freedom of the whole system in the local part. */
    unsigned int
    position(const Field::Block field, const types::global_dof_index dof) const
    {
      return fields[field].prototype.get_partitioner()->global_to_local(
        dof - discretization.first_dof(field));
    }

    void
    tabulate();

    void
    compute_strides();

    /** The cells of a rank, those at the contact end last. */
    std::vector<std::vector<Cell>>
    make_batches(const bool has_massless_nodes);

    void
    compute_radial(const std::vector<std::vector<Cell>> &cells);

    void
    compute_positions(const Field::Block                    field,
                      const std::vector<std::vector<Cell>> &cells);

    /** Positions of the nodes of a cell, in lexicographic order. */
    std::vector<unsigned int>
    local_positions(const Field::Block field, const Cell &cell) const;

    /**
     * The differences of cells at the contact end and at lateral faces: the
     * heat exchange through these faces, and contact nodes without mass (C1.1).
     * Their rows are zero, not a difference that is: in short stages they have
     * nothing but stiffness, which is smaller than the rounding of a mass.
     */
    void
    collect_faces(const Scene &scene);

    void
    collect_extension();

    /** Before collect_faces(), which has that of contact nodes without mass. */
    void
    collect_lumped_mass(const Field::Block                    field,
                        const std::vector<std::vector<Cell>> &cells);

    /** Calls @p visit(row, column, value) for what collect_faces() has found. */
    template <typename Visit>
    void
    visit_faces(const Field::Block field,
                const double       mass,
                const double       stiffness,
                const Visit       &visit) const;

    /** Adds to @p y what @p add does from @p x with ghosts. */
    template <typename Add>
    void
    add_up(LevelVector<Number>       &y,
           const LevelVector<Number> &x,
           const Add                 &add) const;

    /** add(), or what @p replaces all of @p y, in planes that cover it. */
    void
    add_all(const Field::Block         field,
            const double               mass,
            const double               stiffness,
            LevelVector<Number>       &y,
            const LevelVector<Number> &x,
            const bool                 replaces) const;

    /** Adds a product without faces. */
    void
    add_product(const Operator             op,
                const Factors             &factors,
                LevelVector<Number>       &y,
                const LevelVector<Number> &x,
                const bool                 replaces = false) const;

    /** The same by cells. */
    void
    add_cells(const Operator             op,
              const Factors             &factors,
              LevelVector<Number>       &y,
              const LevelVector<Number> &x) const;

    /** With a number of nodes in one direction; 0: any. */
    template <int n_static>
    void
    add_cells_of(const Operator             op,
                 const Factors             &factors,
                 LevelVector<Number>       &y,
                 const LevelVector<Number> &x) const;

    bool
    is_weighted(const Operator op) const
    {
      return op != OnGrid::laplacian && !radial.empty();
    }

    /** Derivatives of components, or of their test functions, in a product. */
    enum class Derivatives
    {
      none,
      own, ///< along the direction of each component
      all
    };

    /**
     * Adds to @p n_to components what @p at_point(point, values, gradients, q)
     * makes of @p n_from components at quadrature point q, in their place.
     */
    template <int         n_static,
              int         n_from,
              Derivatives of_from,
              int         n_to,
              Derivatives of_to,
              typename AtPoint>
    void
    sum_over_cells(const Operator             op,
                   const Factors             &factors,
                   LevelVector<Number>       &y,
                   const LevelVector<Number> &x,
                   const AtPoint             &at_point) const;

    /** @param mass,stiffness 0 and 1 of the Laplacian */
    void
    add_diagonal(const Operator       op,
                 const double         mass,
                 const double         stiffness,
                 const Field::Block   field,
                 LevelVector<Number> &y) const;
  };



  /** Makes the products of a body; null for a rod. Both references are
   * borrowed. */
  template <int dim>
  std::unique_ptr<const CellProducts<dim, double>>
  make_cell_products(const Scene               &scene,
                     const Discretization<dim> &discretization)
  {
    if constexpr (dim > 1)
      return std::make_unique<const CellProducts<dim, double>>(scene,
                                                               discretization);
    return nullptr;
  }
} // namespace ThermoContact

#endif
