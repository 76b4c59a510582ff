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
     * of vmult(). Where there is no neighbour, values are zero.
     */
    template <typename Visit>
    void
    visit_entries(const Field::Block field,
                  const double       mass_factor,
                  const double       stiffness_factor,
                  const Visit       &visit) const
    {
      if (field == Field::temperature)
        visit_blocks<1>(field, mass_factor, stiffness_factor, visit);
      else
        visit_blocks<dim>(field, mass_factor, stiffness_factor, visit);
    }

  private:
    /** A node itself, and neighbours with larger numbers. */
    static constexpr unsigned int n_neighbours = ((dim == 2 ? 9 : 27) + 1) / 2;

    const unsigned int                     n_nodes;
    std::array<unsigned int, n_neighbours> offsets; ///< of their numbers

    /** For the neighbours of all nodes: of a component; of each field, blocks.
     */
    std::vector<Number>                mass;
    std::array<std::vector<Number>, 2> stiffness;

    static unsigned int
    n_components(const Field::Block field)
    {
      return field == Field::temperature ? 1 : dim;
    }

    template <unsigned int n, typename Visit>
    void
    visit_blocks(const Field::Block field,
                 const Number       mass_factor,
                 const Number       stiffness_factor,
                 const Visit       &visit) const
    {
      const Number *block = stiffness[field].data();
      const Number *m     = mass.data();
      for (unsigned int node = 0; node < n_nodes; ++node)
        for (unsigned int k = 0; k < n_neighbours; ++k, ++m, block += n * n)
          if (const unsigned int other = node + offsets[k]; other < n_nodes)
            for (unsigned int c = 0; c < n; ++c)
              for (unsigned int e = k == 0 ? c : 0; e < n; ++e)
                visit(other * n + e,
                      node * n + c,
                      stiffness_factor * block[c * n + e] +
                        (c == e ? mass_factor * *m : Number()));
    }

    /** The integrals over the cell above a node in all directions. */
    void
    add_cell(const Scene                          &scene,
             const Geometry<dim>                  &geometry,
             const LevelGrid<dim>                 &grid,
             const typename LevelGrid<dim>::Index &first,
             const Quadrature<dim>                &rule);
  };
} // namespace ThermoContact

#endif
