// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_matrix_h
#define thermocontact_multigrid_level_matrix_h

#include <thermocontact/multigrid/level_grid.h>
#include <thermocontact/multigrid/level_operator.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /**
   * The stage matrices of a coarser level, of elements of degree 1 on its grid,
   * whole on every rank. Without heat exchange, and with a consistent mass: a
   * coarse contact node stands for nodes with mass, too; without, residuals of
   * those would move it without resistance in a short stage.
   */
  template <int dim, typename Number>
  class LevelMatrix : public LevelOperator<Number>
  {
  public:
    LevelMatrix(const Scene               &scene,
                const Discretization<dim> &discretization,
                const LevelGrid<dim>      &grid);

    LevelVector<Number>
    make_vector(const Field::Block field) const override;

    void
    vmult(const Field::Block         field,
          const double               mass,
          const double               stiffness,
          LevelVector<Number>       &y,
          const LevelVector<Number> &x) const override;

    /**
     * Calls @p visit(row, column, value) for the lower triangle of the matrix
     * of vmult().
     */
    template <typename Visit>
    void
    visit_entries(const Field::Block field,
                  const double       mass,
                  const double       stiffness,
                  const Visit       &visit) const
    {
      const unsigned int n_components = fields[field].n_components;
      for (unsigned int node = 0; node < n_nodes; ++node)
        for (unsigned int k = 0; k < n_neighbours; ++k)
          if (node + offsets[k] < n_nodes)
            for (unsigned int c = 0; c < n_components; ++c)
              for (unsigned int e = k == 0 ? c : 0; e < n_components; ++e)
                visit((node + offsets[k]) * n_components + e,
                      node * n_components + c,
                      entry(fields[field], node, k, c, e, mass, stiffness));
    }

    /** Of the matrices of a field. */
    unsigned int
    bandwidth(const Field::Block field) const
    {
      return (offsets.back() + 1) * fields[field].n_components - 1;
    }

  private:
    /** A node itself, and neighbours with larger numbers. */
    static constexpr unsigned int n_neighbours = ((dim == 2 ? 9 : 27) + 1) / 2;

    struct FieldEntries
    {
      unsigned int        n_components = 0; ///< 0: there is no such field
      std::vector<Number> stiffness;        ///< blocks of neighbours of nodes
    };

    const unsigned int                     n_nodes;
    std::array<unsigned int, n_neighbours> offsets; ///< of their numbers
    std::vector<Number> mass; ///< of one component, for neighbours of nodes
    std::array<FieldEntries, 2> fields;

    /**
     * Row component @p c of a node, column component @p e of a neighbour.
     * Neighbours that are not there have zeros.
     */
    Number
    entry(const FieldEntries &field,
          const unsigned int  node,
          const unsigned int  neighbour,
          const unsigned int  c,
          const unsigned int  e,
          const Number        mass_factor,
          const Number        stiffness_factor) const;

    /** The integrals over the cell above a node in all directions. */
    void
    add_cell(const Scene                          &scene,
             const Geometry<dim>                  &geometry,
             const LevelGrid<dim>                 &grid,
             const typename LevelGrid<dim>::Index &first,
             const Quadrature<dim>                &rule);

    template <int n_components>
    void
    add_products(const FieldEntries &field,
                 const Number        mass_factor,
                 const Number        stiffness_factor,
                 const Number       *x,
                 Number             *y) const;
  };
} // namespace ThermoContact

#endif
