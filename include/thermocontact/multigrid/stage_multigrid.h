// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_multigrid_h
#define thermocontact_multigrid_stage_multigrid_h

#include <thermocontact/multigrid/multigrid_levels.h>
#include <thermocontact/space/direct_solver.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/trilinos_precondition.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /** The degrees of freedom at the contact end that a stage changes. */
  struct ContactRows
  {
    /** Added to the diagonal: springs of an elastic obstacle; or empty. */
    Vector springs;

    /** 1 where a rigid obstacle prescribes the velocity, else 0; or empty. */
    Vector held;
  };



  /**
   * The block of one field of the stage matrix (M.15) on one level, without
   * matrix: $M+\tau(K+kB)$ or $bM_u+\tau\zeta S_\zeta+\tau^2S$, with springs at
   * contact nodes. Rows and columns of degrees of freedom whose rate is
   * prescribed are those of the identity.
   */
  template <int dim>
  class StageBlock : public Subscriptor
  {
  public:
    StageBlock(const MultigridLevels<dim> &levels,
               const unsigned int          level,
               const Field::Block          field,
               const double                tau);

    void
    vmult(Vector &y, const Vector &x) const;

    /** Diagonal, 1 for prescribed ones. */
    Vector
    diagonal() const;

    types::global_dof_index
    m() const
    {
      return scratch.size();
    }

    /** Asked for by deal.II where there is no diagonal; here there is one. */
    double
    el(const types::global_dof_index, const types::global_dof_index) const
    {
      Assert(false, ExcNotImplemented());
      return 0.;
    }

    /** Takes over springs and held nodes of this level. */
    void
    set_contact(const ContactRows &rows);

    /** Zero for all prescribed degrees of freedom. */
    void
    zero_prescribed(Vector &vector) const;

  private:
    const MultigridLevels<dim> &levels;
    const unsigned int          level;
    const Field::Block          field;
    const double                tau;
    std::vector<unsigned int>   prescribed; ///< local entries

    /** Local entries with the stiffness of their springs. */
    std::vector<std::pair<unsigned int, double>> springs;

    mutable Vector scratch;
  };



  /**
   * One V-cycle for the block of a field of the stage matrix: a preconditioner.
   * Chebyshev smoothers of degree 3 with the diagonal (2 for heat), the factors
   * of a matrix on the coarsest level. Symmetric and, between two calls of
   * set_contact(), always the same.
   */
  template <int dim>
  class StageMultigrid
  {
  public:
    /** @param levels borrowed */
    StageMultigrid(const MultigridLevels<dim> &levels,
                   const Field::Block          field,
                   const double                tau);

    /**
     * @param rows of the finest level; null: no contact. The largest eigenvalues
     *   stay those without contact.
     */
    void
    set_contact(const ContactRows *rows);

    /** @p z = one V-cycle for @p r. */
    void
    vmult(Vector &z, const Vector &r) const;

    /** Products on the finest level that one cycle takes. */
    unsigned int
    n_products() const;

  private:
    using Smoother =
      PreconditionChebyshev<StageBlock<dim>, Vector, DiagonalMatrix<Vector>>;

    /** Of all levels but the coarsest. */
    struct Level
    {
      std::unique_ptr<StageBlock<dim>>        block;
      std::shared_ptr<DiagonalMatrix<Vector>> inverse_diagonal;
      std::unique_ptr<Smoother>               smoother;
    };

    const MultigridLevels<dim> &levels;
    const Field::Block          field;
    const double                tau;
    std::vector<Level>          fine; ///< level l is fine[l - 1]

    std::unique_ptr<SparseMatrix>                      coarse_matrix;
    std::unique_ptr<DirectSolver>                      coarse_solver;
    std::unique_ptr<TrilinosWrappers::PreconditionAMG> coarse_amg;
    std::vector<unsigned int> coarse_prescribed; ///< local entries

    void
    set_coarse(const ContactRows *rows);

    /** Solves approximately on a level: right to solution. */
    void
    cycle(const unsigned int level) const;
  };
} // namespace ThermoContact

#endif
