// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_multigrid_levels_h
#define thermocontact_multigrid_multigrid_levels_h

#include <thermocontact/multigrid/level_products.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/matrix_free_operator.h>

#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

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
    MGTwoLevelTransfer<dim, LevelVector<Number>> transfer;

    /** Diagonals of mass and stiffness (conduction). */
    LevelVector<Number> mass;
    LevelVector<Number> stiffness;

    /** What a V-cycle works with, of one stage length after the other. */
    mutable LevelVector<Number> right;
    mutable LevelVector<Number> solution;
    mutable LevelVector<Number> residual;
    mutable LevelVector<Number> update;

    /** For the coarsest, whose system is solved in double precision. */
    mutable Vector coarse_right;
    mutable Vector coarse_solution;
  };



  /**
   * The body on coarser spaces: half the degree as long as there is one, then
   * half the cells, until the number of cells in some direction is odd. Each
   * level but the coarsest computes its products without matrices; the coarsest
   * has matrices. Where that does not converge there is one coarse level, the
   * body itself with factors.
   *
   * @tparam Number of vectors: a preconditioner needs few digits, and float
   *   has half the size and twice the lanes
   */
  template <int dim, typename Number>
  class MultigridLevels
  {
  public:
    /**
     * @param body borrowed; it is the finest level
     * @param has_factors_of_body instead of coarser spaces
     */
    explicit MultigridLevels(const Body<dim> &body,
                             const bool       has_factors_of_body = false);

    /** Whether the coarsest level has factors of a matrix of so many rows. */
    bool
    is_factorised(const types::global_dof_index n_rows) const;

    bool
    has_factors_of_body() const
    {
      return has_factors_of_body_;
    }

    /** The coarsest one is 0. */
    unsigned int
    n_levels() const
    {
      return levels.size();
    }

    const Discretization<dim> &
    discretization(const unsigned int level) const
    {
      return *levels[level].discretization;
    }

    /** Not of the coarsest level. */
    const LevelProducts<dim, Number> &
    products(const unsigned int level) const
    {
      return *levels[level].products;
    }

    const MatrixFreeSpaces<dim> &
    spaces(const unsigned int level) const
    {
      return *levels[level].spaces;
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

    /** The matrices of the coarsest level. */
    const ThermoviscoelasticOperator<dim> &
    coarse_operator() const
    {
      return *coarse_operator_;
    }

  private:
    struct Level
    {
      std::unique_ptr<const Scene>                 own_scene;
      std::unique_ptr<const Discretization<dim>>   own_discretization;
      std::unique_ptr<const MatrixFreeSpaces<dim>> own_spaces;

      std::unique_ptr<const LevelProducts<dim, Number>> products;

      const Discretization<dim>             *discretization = nullptr;
      const MatrixFreeSpaces<dim>           *spaces         = nullptr;
      std::array<LevelField<dim, Number>, 2> fields;
    };

    const Body<dim>                                       &body;
    const bool                                             has_factors_of_body_;
    std::vector<Level>                                     levels;
    std::unique_ptr<const ThermoviscoelasticOperator<dim>> coarse_operator_;

    void
    make_level(const Parameters &parameters, Level &level) const;

    void
    make_coarse_vectors(Level &level) const;

    void
    make_vectors(Level &level) const;

    void
    compute_diagonals(Level                         &level,
                      const Scene                   &scene,
                      const MatrixFreeOperator<dim> &products) const;

    void
    connect(const Level &coarse, Level &fine) const;
  };
} // namespace ThermoContact

#endif
