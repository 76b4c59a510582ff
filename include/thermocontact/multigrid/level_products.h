// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_products_h
#define thermocontact_multigrid_level_products_h

#include <thermocontact/multigrid/level_operator.h>
#include <thermocontact/multigrid/level_transfer.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/matrix_free_operator.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /**
   * Products with the stage matrices of a body as a MatrixFreeOperator
   * computes them, to the rounding of @p Number, float for preconditioners,
   * with several cells at a time in the lanes of SIMD instructions. For meshes
   * whose cells are boxes along the axes, as all of a Discretization are.
   */
  template <int dim, typename Number>
  class LevelProducts : public LevelOperator<Number>
  {
  public:
    /** @param products of the same mesh; all references are borrowed */
    LevelProducts(const Scene                   &scene,
                  const Discretization<dim>     &discretization,
                  const MatrixFreeOperator<dim> &products);

    LevelVector<Number>
    make_vector(const Field::Block field) const override;

    void
    vmult(const Field::Block         field,
          const double               mass,
          const double               stiffness,
          LevelVector<Number>       &y,
          const LevelVector<Number> &x) const override;

    /** Of the local part of a vector. */
    std::vector<NodalValue<dim>>
    nodal_values(const Field::Block field) const;

    static constexpr unsigned int n_lanes = 16 / sizeof(Number);

  private:
    /** Cells that are treated together; arrays of lanes are aligned. */
    struct alignas(16) Batch
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

      LevelVector<Number> prototype;
      LevelVector<Number> lumped_mass; ///< or empty
    };

    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    const MatrixFreeSpaces<dim> &spaces;
    const Geometry<dim>         &geometry;
    const Material              &material;
    const unsigned int           n;       ///< nodes in one direction
    const unsigned int           n_nodes; ///< of a cell
    const bool                   has_lumped_mass;

    /** From a component of a node to the next one, by lexicographic order. */
    std::vector<unsigned int> strides;

    std::vector<Batch>        batches;
    std::array<FieldCells, 2> fields;

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

    void
    tabulate();

    void
    compute_strides();

    /** The cells of a rank, those with the same lack of mass together. */
    std::vector<std::vector<Cell>>
    make_batches(const bool has_massless_nodes);

    void
    compute_radial(const std::vector<std::vector<Cell>> &cells);

    void
    compute_positions(const Field::Block                    field,
                      const std::vector<std::vector<Cell>> &cells);

    void
    collect_at_end(const Field::Block       field,
                   const ContactCells<dim> &contact_cells);

    /** @tparam n_static nodes in one direction; 0: of any number */
    template <int n_static>
    void
    add_cells(const Field::Block         field,
              const double               mass,
              const double               stiffness,
              LevelVector<Number>       &y,
              const LevelVector<Number> &x) const;

    template <int n_static>
    void
    heat_on_cells(const double               mass,
                  const double               conduction,
                  LevelVector<Number>       &y,
                  const LevelVector<Number> &x) const;

    template <int n_static, bool is_radial>
    void
    momentum_on_cells(const double               mass,
                      const double               stiffness,
                      LevelVector<Number>       &y,
                      const LevelVector<Number> &x) const;

    /** Positions of the nodes of a cell, in lexicographic order. */
    std::vector<unsigned int>
    local_positions(const Field::Block field, const Cell &cell) const;
  };
} // namespace ThermoContact

#endif
