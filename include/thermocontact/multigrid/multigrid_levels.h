// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_multigrid_levels_h
#define thermocontact_multigrid_multigrid_levels_h

#include <thermocontact/multigrid/level_subspaces.h>
#include <thermocontact/multigrid/level_transfer.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/level_matrix.h>

#include <array>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /** One field on a level, the same for all lengths of a stage. */
  template <int dim, typename Number>
  struct LevelField
  {
    /** From the next coarser level; of all but the coarsest. */
    LevelTransfer<dim, Number> transfer;

    /** Local entries of prescribed rates, zero in all vectors. */
    std::vector<unsigned int> prescribed;

    /** Diagonals of mass and stiffness (conduction). */
    LevelVector<Number> mass;
    LevelVector<Number> stiffness;

    /** Of displacements, or null. */
    std::unique_ptr<const LevelSubspaces<dim, Number>> subspaces;

    /**
     * Heat exchange with the obstacle, row by row, that products leave out: of
     * the temperature on coarser levels; of displacements empty.
     */
    LevelVector<Number> exchange;

    /** Vectors of V-cycles, of one stage length after the other. */
    mutable LevelVector<Number> right;
    mutable LevelVector<Number> solution;
    mutable LevelVector<Number> residual;
    mutable LevelVector<Number> update;
  };



  /**
   * The body on coarser grids, as LevelGrid makes them, until there are few
   * nodes. The body computes its products without matrices; all other levels
   * are whole on every rank.
   *
   * @tparam Number of vectors: a preconditioner needs few digits, and float
   *   has half the size and twice the lanes
   */
  template <int dim, typename Number>
  class MultigridLevels
  {
  public:
    /** @param body borrowed; it is the finest level */
    explicit MultigridLevels(const Body<dim> &body);

    /** The coarsest one is 0. */
    unsigned int
    n_levels() const
    {
      return levels.size();
    }

    const LevelOperator<Number> &
    products(const unsigned int level) const
    {
      return *levels[level].products;
    }

    const LevelField<dim, Number> &
    field(const unsigned int level, const Field::Block field) const
    {
      return levels[level].fields[field];
    }

    bool
    has_field(const Field::Block field) const
    {
      return body.discretization.has_field(field);
    }

    /** Smoothers of displacements correct in LevelSubspaces. */
    bool
    has_subspaces() const
    {
      return LevelSubspaces<dim, Number>::are_for(
        body.scene, body.discretization.geometry());
    }

    const Scene &
    scene() const
    {
      return body.scene;
    }

    /** Of the coarsest level, for its factors. */
    const LevelMatrix<dim, double> &
    coarse_matrix() const
    {
      return *coarse_matrix_;
    }

  private:
    struct Level
    {
      std::unique_ptr<const LevelOperator<Number>> products;
      std::array<LevelField<dim, Number>, 2>       fields;
    };

    const Body<dim>   &body;
    std::vector<Level> levels;

    std::unique_ptr<const LevelMatrix<dim, double>> coarse_matrix_;

    /**
     * @param grid of the level
     * @param values of the local part of a vector
     */
    void
    make_field(const LevelOperator<Number>        &products,
               const LevelGrid<dim>               &grid,
               const std::vector<NodalValue<dim>> &values,
               const Field::Block                  field,
               LevelField<dim, Number>            &of_field) const;

    /**
     * The transfer from a grid to the next finer level, and what the field on
     * the grid has from there.
     */
    void
    connect(const LevelGrid<dim>               &grid,
            const std::vector<NodalValue<dim>> &fine_values,
            const unsigned int                  level,
            const Field::Block                  field);
  };
} // namespace ThermoContact

#endif
