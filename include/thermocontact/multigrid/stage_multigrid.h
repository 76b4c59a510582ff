// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_multigrid_h
#define thermocontact_multigrid_stage_multigrid_h

#include <thermocontact/multigrid/coarse_solver.h>
#include <thermocontact/multigrid/multigrid_levels.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
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
   * Chebyshev smoothers of degree 3 with the diagonal (2 for heat) and a
   * CoarseSolver. Symmetric and, between two calls of set_contact(), always the
   * same.
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
     * The largest eigenvalues stay those without contact; so does its
     * CoarseSolver, which is kept beside that of the last rows. Collective.
     *
     * @param rows of the finest level; null: no contact
     * @param are_as_before the last ones that were not null were the same
     */
    void
    set_contact(const ContactRows *rows, const bool are_as_before = false);

    /** @p z = one V-cycle for @p r. */
    void
    vmult(Vector &z, const Vector &r) const;

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

    std::unique_ptr<CoarseSolver<dim>> coarse_without_contact;
    std::unique_ptr<CoarseSolver<dim>> coarse_with_contact; ///< of present rows
    ContactRows                        coarse_rows;
    bool                               has_contact = false;

    /** Springs and held nodes of all levels; those of the coarsest are kept. */
    void
    set_rows(const ContactRows &rows);

    /** Zero where the coarsest level has prescribed rates. */
    void
    zero_coarse(Vector &vector) const;

    /** Solves approximately on a level: right to solution. */
    void
    cycle(const unsigned int level) const;
  };
} // namespace ThermoContact

#endif
