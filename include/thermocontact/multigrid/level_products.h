// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_products_h
#define thermocontact_multigrid_level_products_h

#include <thermocontact/multigrid/lanes.h>
#include <thermocontact/multigrid/level_transfer.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/matrix_free_operator.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <functional>
#include <vector>

namespace ThermoContact
{
  /** The same values, owned ones alone, as numbers of another type. */
  template <typename To, typename From>
  void
  copy_values(LevelVector<To> &to, const LevelVector<From> &from)
  {
    std::copy(from.begin(), from.end(), to.begin());
  }



  /**
   * Products with the stage matrices of one level, to the rounding of
   * @p Number, float for preconditioners, with several cells at a time in the
   * lanes of SIMD instructions. For grids whose cells are boxes along the axes,
   * as all of a Discretization are.
   */
  template <int dim, typename Number>
  class LevelProducts
  {
  public:
    /**
     * Of the body, as a MatrixFreeOperator computes them.
     *
     * @param products of the same mesh; all references are borrowed
     */
    LevelProducts(const Scene                   &scene,
                  const Discretization<dim>     &discretization,
                  const LevelGrid<dim>          &grid,
                  const MatrixFreeOperator<dim> &products);

    /**
     * Of a coarser grid, without heat exchange and with a consistent mass:
     * a coarse contact node stands for nodes with mass, too; without,
     * residuals of those would move it without resistance in a short stage.
     */
    LevelProducts(const Scene               &scene,
                  const Discretization<dim> &discretization,
                  const LevelGrid<dim>      &grid);

    /** A vector of zeros with the ghosts that products need. */
    LevelVector<Number>
    make_vector(const Field::Block field) const
    {
      return fields[field].prototype;
    }

    /** Those of a field that this rank owns. */
    std::vector<LevelNode<dim>>
    nodes(const Field::Block field) const;

    /**
     * @p y = (@p mass M + @p stiffness (K + k B)) @p x, or with $M_u$ and $S$.
     * Without constraints. Collective.
     */
    void
    vmult(const Field::Block         field,
          const double               mass,
          const double               stiffness,
          LevelVector<Number>       &y,
          const LevelVector<Number> &x) const;

    /**
     * Calls @p visit(row, column, value) for the entries of all cells, to be
     * added up; of a coarser grid.
     */
    void
    visit_entries(const Field::Block field,
                  const double       mass,
                  const double       stiffness,
                  const std::function<void(unsigned int, unsigned int, Number)>
                    &visit) const;

    static constexpr unsigned int n_lanes = 16 / sizeof(Number);

  private:
    using Batched = Lanes<Number>;

    /** A cell: of the grid, and of the mesh if it is that of the body. */
    struct Box
    {
      std::array<unsigned int, dim>                  index;
      typename DoFHandler<dim>::active_cell_iterator cell;
    };

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

    /**
     * Values of basis functions at quadrature points (q, i) and the transpose,
     * derivatives of the polynomials of the points there (q, r) and the
     * transpose; all lanes are the same.
     */
    struct Line
    {
      AlignedVector<Number> values, values_transposed;
      AlignedVector<Number> derivatives, derivatives_transposed;
    };

    const Geometry<dim>         &geometry;
    const Material              &material;
    const LevelGrid<dim>         grid;
    const MatrixFreeSpaces<dim> *spaces;  ///< of the body; else null
    const LineSizes              sizes;   ///< nodes of a cell
    const unsigned int           n_nodes; ///< of a cell
    const bool                   has_lumped_mass;

    /** From a component of a node to the next one, by lexicographic order. */
    std::vector<unsigned int> strides;

    std::vector<Box>          boxes; ///< of the lanes of all batches
    std::vector<Batch>        batches;
    std::array<FieldCells, 2> fields;
    std::array<Line, 2>       lines;   ///< along, across
    AlignedVector<Number>     weights; ///< of the points of a cell

    /** Weight and strain per displacement in the rows of points of a batch. */
    AlignedVector<Number> radial;

    mutable AlignedVector<Number> scratch;

    LineMatrices<Number>
    matrices(const AlignedVector<Number> Line::*which) const
    {
      return {{Batched::in((lines[0].*which).begin()),
               Batched::in((lines[1].*which).begin())}};
    }

    void
    tabulate();

    /** What both constructors do once there are boxes in batches. */
    void
    set_up();

    void
    compute_strides();

    /** Batches of cells, which fill their last lanes once more. */
    void
    add_batches(const std::vector<Box> &cells, const bool has_axial_mass);

    void
    compute_radial();

    void
    collect_at_end(const Field::Block       field,
                   const ContactCells<dim> &contact_cells);

    Point<dim>
    corner_of(const Box &box) const;

    /** Sides of a box. */
    Tensor<1, dim>
    size_of(const Box &box) const;

    /** Lexicographic numbers of the nodes of a cell by direction. */
    std::array<unsigned int, dim>
    node_index(const Box &box, const unsigned int node) const;

    /** Positions of the nodes of a cell, in lexicographic order. */
    std::vector<unsigned int>
    positions_in(const Field::Block field, const Box &box) const;

    std::vector<unsigned int>
    local_positions(const Field::Block field, const Cell &cell) const;

    /** @tparam n_along,n_across nodes of a cell; 0: of any number */
    template <int n_along, int n_across>
    void
    add_cells(const Field::Block         field,
              const double               mass,
              const double               stiffness,
              LevelVector<Number>       &y,
              const LevelVector<Number> &x) const;

    /** Replaces values in the cells of a batch by the products. */
    template <int n_along, int n_across>
    void
    heat_on_cells(const unsigned int batch,
                  const double       mass,
                  const double       conduction,
                  Batched           *theta) const;

    template <int n_along, int n_across, bool is_radial>
    void
    momentum_on_cells(const unsigned int batch,
                      const double       mass,
                      const double       stiffness,
                      Batched           *values_at) const;

    template <int n_along, int n_across>
    void
    on_cells(const Field::Block field,
             const unsigned int batch,
             const double       mass,
             const double       stiffness,
             Batched           *values_at) const
    {
      if (field == Field::temperature)
        heat_on_cells<n_along, n_across>(batch, mass, stiffness, values_at);
      else if (dim == 2 && !radial.empty())
        momentum_on_cells<n_along, n_across, dim == 2>(batch,
                                                       mass,
                                                       stiffness,
                                                       values_at);
      else
        momentum_on_cells<n_along, n_across, false>(batch,
                                                    mass,
                                                    stiffness,
                                                    values_at);
    }
  };
} // namespace ThermoContact

#endif
