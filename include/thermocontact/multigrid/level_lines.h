// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_lines_h
#define thermocontact_multigrid_level_lines_h

#include <thermocontact/multigrid/level_transfer.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/geometry.h>

#include <vector>

namespace ThermoContact
{
  /**
   * The entries of the stiffness (conduction) of a level between the nodes of
   * lines along the body, each component by itself: the largest ones where
   * cells are shorter along the body than across it. Of the nodes of a rank.
   */
  template <int dim, typename Number>
  struct LevelLines
  {
    /** No lines. */
    LevelLines() = default;

    /**
     * @param values what the local part of a vector has
     * @param diagonal of the stiffness
     */
    LevelLines(const LevelGrid<dim>               &grid,
               const std::vector<NodalValue<dim>> &values,
               const Field::Block                  field,
               const Material                     &material,
               const Geometry<dim>                &geometry,
               const LevelVector<Number>          &diagonal);

    unsigned int n_components = 0;
    unsigned int width = 0; ///< nodes before one that it has entries with

    /** Local entries of vectors, line by line; components of a node together.
     */
    std::vector<unsigned int> order;

    /**
     * Of nodes with those before them, the next one first: of each
     * n_components; 0 where there is none.
     */
    std::vector<Number> couplings;
  };



  /**
   * Factors LDL^T of a stage block without all entries but those of its lines
   * and the diagonal.
   */
  template <int dim, typename Number>
  class LineFactors
  {
  public:
    /** @param lines borrowed; other parameters as StageBlock::line_factors() */
    LineFactors(const LevelLines<dim, Number> &lines,
                const double                   stiffness,
                const LevelVector<Number>     &inverse_diagonal);

    /** In place: right-hand side to solution. */
    void
    solve(LevelVector<Number> &values) const;

  private:
    const LevelLines<dim, Number> &lines;
    std::vector<Number>            multipliers;    ///< as LevelLines::couplings
    std::vector<Number>            inverse_pivots; ///< zero for prescribed ones
    mutable std::vector<Number>    scratch;

    template <unsigned int n_components>
    void
    solve_components(Number *values) const;
  };
} // namespace ThermoContact

#endif
