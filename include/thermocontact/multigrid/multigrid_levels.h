// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_multigrid_levels_h
#define thermocontact_multigrid_multigrid_levels_h

#include <thermocontact/multigrid/level_products.h>
#include <thermocontact/space/body.h>

#include <array>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /** What a level knows of one field whatever the length of a stage. */
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

    /** Heat exchange with the obstacle on coarser levels, row by row. */
    LevelVector<Number> exchange;

    /** What a V-cycle works with, of one stage length after the other. */
    mutable LevelVector<Number> right;
    mutable LevelVector<Number> solution;
    mutable LevelVector<Number> residual;
    mutable LevelVector<Number> update;
  };



  /**
   * The body on coarser grids, as LevelGrid makes them, until there are few
   * nodes. Each level computes its products without matrices. All but the
   * finest are whole on every rank.
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

    const LevelProducts<dim, Number> &
    products(const unsigned int level) const
    {
      return *levels[level].products;
    }

    const LevelField<dim, Number> &
    field(const unsigned int level, const Field::Block field) const
    {
      return levels[level].fields[field];
    }

    const Scene &
    scene() const
    {
      return body.scene;
    }

    /** Products of the coarsest level, whose entries make its matrices. */
    const LevelProducts<dim, double> &
    coarse_products() const
    {
      return *coarse_products_;
    }

    /** Rows of the matrix of the coarsest level, and its bandwidth. */
    unsigned int
    n_coarse_rows(const Field::Block field) const
    {
      return levels[0].grid.n_nodes() * n_components(field);
    }

    unsigned int
    coarse_bandwidth(const Field::Block field) const
    {
      return (levels[0].grid.bandwidth() + 1) * n_components(field) - 1;
    }

  private:
    struct Level
    {
      LevelGrid<dim>                                    grid;
      std::unique_ptr<const LevelProducts<dim, Number>> products;
      std::array<LevelField<dim, Number>, 2>            fields;
    };

    const Body<dim>   &body;
    std::vector<Level> levels;

    std::unique_ptr<const LevelProducts<dim, double>> coarse_products_;

    static unsigned int
    n_components(const Field::Block field)
    {
      return field == Field::temperature ? 1 : dim;
    }

    void
    make_field(Level &level, const Field::Block field) const;

    /** The transfer, and what the coarser level has from the finer one. */
    void
    connect(Level &coarse, Level &fine, const Field::Block field) const;
  };
} // namespace ThermoContact

#endif
