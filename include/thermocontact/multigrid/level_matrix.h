// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_matrix_h
#define thermocontact_multigrid_level_matrix_h

#include <thermocontact/multigrid/level_grid.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/lanes.h>
#include <thermocontact/space/level_operator.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /**
   * The stage matrices of a coarser level, of the elements of its grid, whole
   * on every rank. Without heat exchange, and with a consistent mass: a
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
     * Calls @p visit(row, column, value) for all entries of the matrix of
     * vmult().
     */
    template <typename Visit>
    void
    visit_entries(const Field::Block field,
                  const double       mass,
                  const double       stiffness,
                  const Visit       &visit) const
    {
      const unsigned int n = n_components(field);
      for (const Kind &kind : kinds)
        for (const Neighbour &neighbour : kind.neighbours)
          for (const unsigned int line : kind.lines)
            for (unsigned int node = 0; node < n_line; ++node)
              for (unsigned int k = 0; k < reach; ++k)
                for (unsigned int c = 0; c < n; ++c)
                  for (unsigned int e = 0; e < n; ++e)
                    if (node + k >= degree && node + k < n_line + degree)
                      visit((line * n_line + node) * n + c,
                            ((line + neighbour.offset) * n_line + node + k -
                             degree) *
                                n +
                              e,
                            stiffness * kind.stiffness[field][index(
                                          n, neighbour.number, c, k, e, node)] +
                              (c == e ?
                                 mass * kind.mass[index(
                                          1, neighbour.number, 0, k, 0, node)] :
                                 0.));
    }

  private:
    /** A line beside another one, or that one itself. */
    struct Neighbour
    {
      unsigned int number; ///< digits to the base of @p reach
      int          offset; ///< of its number among the lines
    };

    /**
     * Lines of nodes along the last direction that have the same cells around
     * them, and so the same entries of the matrices: those of a node with the
     * nodes around it, node by node and zero where there is none.
     */
    struct Kind
    {
      std::vector<unsigned int>          lines;
      std::vector<Neighbour>             neighbours;
      std::vector<Number>                mass; ///< as of one component
      std::array<std::vector<Number>, 2> stiffness;
    };

    static constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;

    const unsigned int degree;
    const unsigned int reach;  ///< nodes that a node is coupled with on a line
    const unsigned int n_line; ///< nodes of a line
    const unsigned int n_lines;
    const unsigned int length; ///< of a line whose end is filled up
    std::vector<Kind>  kinds;

    /** Filled up lines of factors and product, component by component. */
    mutable std::vector<Number> of_stiffness, of_mass, sums;

    static unsigned int
    n_components(const Field::Block field)
    {
      return field == Field::temperature ? 1 : dim;
    }

    /**
     * Place in Kind of the entry of the component @p c of a node of a line with
     * the component @p e of the node @p k - degree places farther in a line
     * beside.
     */
    std::size_t
    index(const unsigned int n_components,
          const unsigned int neighbour,
          const unsigned int c,
          const unsigned int k,
          const unsigned int e,
          const unsigned int node) const
    {
      return (((std::size_t(neighbour) * n_components + c) * reach + k) *
                n_components +
              e) *
               length +
             node;
    }

    /** The matrices of the cells around a line. */
    template <typename CellOf>
    void
    add_cells(const LevelGrid<dim> &grid,
              const CellOf         &cell_of,
              Kind                 &kind) const;

    /** Calls @p visit(entry of a vector, place in filled up lines). */
    template <unsigned int n, typename Visit>
    void
    visit_values(const Visit &visit) const;

    template <unsigned int n>
    void
    multiply(const Field::Block         field,
             const double               mass,
             const double               stiffness,
             LevelVector<Number>       &y,
             const LevelVector<Number> &x) const;
  };
} // namespace ThermoContact

#endif
