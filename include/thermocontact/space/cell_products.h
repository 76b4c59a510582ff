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
   * LevelMatrix;
   * to the rounding of @p Number, float for preconditioners. For meshes whose
   * cells are boxes along the axes, as all of a Discretization are.
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

    /** The Laplacian of the mesh, of each component of a field. */
    void
    laplacian(const Field::Block         field,
              LevelVector<Number>       &y,
              const LevelVector<Number> &x) const;

    /** @p heat $=Du$. */
    void
    divergence(LevelVector<Number> &heat, const LevelVector<Number> &u) const;

    /** @p momentum $=D^T\theta$. */
    void
    thermal_stress(LevelVector<Number>       &momentum,
                   const LevelVector<Number> &theta) const;

    /** @p y $=Lx$, the heat exchange of lateral faces. */
    void
    lateral_exchange(LevelVector<Number>       &y,
                     const LevelVector<Number> &x) const;

    /**
     * @p y $=Sx$ at the nodes of the contact end, for @p x that is zero at all
     * others, by the cells at that end alone.
     */
    void
    contact_stiffness(LevelVector<Number>       &y,
                      const LevelVector<Number> &x) const;

    /** The diagonal of the matrix of vmult(). Collective. */
    LevelVector<Number>
    diagonal(const Field::Block field,
             const double       mass,
             const double       stiffness) const;

    LevelVector<Number>
    laplacian_diagonal(const Field::Block field) const;

    /** That of contact_stiffness(), at the nodes of the contact end. */
    LevelVector<Number>
    contact_stiffness_diagonal() const;

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

    /** What a sum over the points of cells has. */
    struct Factors
    {
      double mass;
      double stiffness;
      bool   is_of_mesh = false; ///< a Laplacian: no weights, no material
      bool   is_at_end  = false; ///< of the cells at the contact end alone
    };

    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    const Discretization<dim> &discretization;
    const Geometry<dim>       &geometry;
    const Material            &material;
    const unsigned int         n;       ///< nodes in one direction
    const unsigned int         n_nodes; ///< of a cell
    const bool                 has_lumped_mass;

    /** Of the nodes of a cell, which are numbered by vertices, lines, ... */
    std::vector<unsigned int> lexicographic;
    /** From a component of a node to the next one, by lexicographic order. */
    std::vector<unsigned int> strides;

    std::vector<Batch>        batches; ///< those at the contact end last
    unsigned int              first_at_end = 0;
    std::array<FieldCells, 2> fields;

    using OnGrid = LevelMatrix<dim, Number>;

    /** In place of sums over cells, of degree 1 on one rank; else null. */
    std::unique_ptr<const OnGrid> on_grid;

    /**
     * Values of basis functions at quadrature points (q, i) and the transpose,
     * derivatives of the polynomials of the points there (q, r) and the
     * transpose, and weights of the points of a cell; all lanes are the same.
     */
    AlignedVector<Number> values, values_transposed;
    AlignedVector<Number> derivatives, derivatives_transposed;
    AlignedVector<Number> weights;

    /** Products of values and derivatives of a basis function, (i, q). */
    enum Square : unsigned int
    {
      of_value,
      of_both,
      of_derivative
    };
    std::array<AlignedVector<Number>, 3> squares;

    /** Weight and strain per displacement in the rows of points of a batch. */
    AlignedVector<Number> radial;

    mutable AlignedVector<Number> scratch;

    unsigned int
    n_components(const Field::Block field) const
    {
      return field == Field::temperature ? 1 : dim;
    }

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

    void
    make_grid_products(const Scene &scene);

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
     * What differs in the cells at the contact end and at lateral faces: the
     * heat exchange through these faces, and contact nodes without mass (C1.1).
     * Their rows are zero, not a difference that is: in short stages they have
     * nothing but stiffness, which is smaller than the rounding of a mass.
     */
    void
    collect_faces(const Scene &scene);

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

    /**
     * @p y = what @p kernel(static number of nodes in one direction, or 0)
     * adds from @p x with ghosts.
     */
    template <typename Kernel>
    void
    sum_up(LevelVector<Number>       &y,
           const LevelVector<Number> &x,
           const Kernel              &kernel) const;

    unsigned int
    first_batch(const Factors &factors) const
    {
      return factors.is_at_end ? first_at_end : 0;
    }

    /** Of a point of the cells of a batch; @p is_of_mesh: without radius. */
    Lanes<Number>
    weight(const unsigned int batch,
           const unsigned int q,
           const bool         is_of_mesh = false) const;

    /** Strain across the mesh per displacement along y. */
    Lanes<Number>
    hoop(const unsigned int batch, const unsigned int q) const;

    template <int n_static>
    void
    add_cells(const Field::Block         field,
              const Factors             &factors,
              LevelVector<Number>       &y,
              const LevelVector<Number> &x) const;

    template <int n_static>
    void
    scalar_on_cells(const Field::Block         field,
                    const unsigned int         component,
                    const Factors             &factors,
                    LevelVector<Number>       &y,
                    const LevelVector<Number> &x) const;

    template <int n_static, bool is_radial>
    void
    momentum_on_cells(const Factors             &factors,
                      LevelVector<Number>       &y,
                      const LevelVector<Number> &x) const;

    template <int n_static>
    void
    divergence_on_cells(LevelVector<Number>       &heat,
                        const LevelVector<Number> &u) const;

    template <int n_static>
    void
    thermal_stress_on_cells(LevelVector<Number>       &momentum,
                            const LevelVector<Number> &theta) const;

    /** That of add_cells(), or of the Laplacian. */
    void
    add_diagonal(const Field::Block   field,
                 const Factors       &factors,
                 LevelVector<Number> &y) const;
  };
} // namespace ThermoContact

#endif
