// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_level_lines_h
#define thermocontact_multigrid_level_lines_h

#include <thermocontact/multigrid/level_transfer.h>
#include <thermocontact/space/level_matrix.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The stiffness (conduction) of the nodes of a level along lines in the
   * direction of the body, each component by itself, of elements of degree 1.
   * Ranks have whole lines, in turn.
   */
  template <int dim, typename Number>
  struct LevelLines
  {
    /** No lines. */
    LevelLines() = default;

    /**
     * @param stiffness the diagonal of the level, a fifth of which is the least
     *   that the lines have: the heat exchange is there alone
     * @param values what its local part has
     */
    LevelLines(const LevelMatrix<dim, Number>     &matrix,
               const LevelGrid<dim>               &grid,
               const Field::Block                  field,
               const LevelVector<Number>          &stiffness,
               const std::vector<NodalValue<dim>> &values);

    /** From one node of a line to the next one in what follows. */
    unsigned int n_components = 0;

    /** Of vectors of the level, with ghosts for the lines of a rank. */
    std::shared_ptr<const Utilities::MPI::Partitioner> partitioner;

    /** Local entries of such vectors, line by line. */
    std::vector<unsigned int> entries;

    std::vector<Number> diagonal;
    std::vector<Number> coupling; ///< with the node before; 0: there is none
  };



  /** Factors of the lines of a stage block, doc/discretisation.md section 8. */
  template <int dim, typename Number>
  class LineFactors
  {
  public:
    /**
     * @param lines borrowed
     * @param stiffness its factor
     * @param rest of the diagonal; infinite where values are prescribed, which
     *   become 0
     */
    LineFactors(const LevelLines<dim, Number> &lines,
                const double                   stiffness,
                const Vector                  &rest);

    /** In place: right-hand side to solution. Collective. */
    void
    solve(LevelVector<Number> &values) const;

  private:
    const LevelLines<dim, Number> &lines;
    std::vector<Number>            multipliers; ///< and zeros at the end
    std::vector<Number>            inverse_pivots;
    mutable std::vector<Number>    scratch; ///< zeros at both ends
    mutable LevelVector<Number>    on_lines;
  };
} // namespace ThermoContact

#endif
