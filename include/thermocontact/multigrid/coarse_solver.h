// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_coarse_solver_h
#define thermocontact_multigrid_coarse_solver_h

#include <thermocontact/space/direct_solver.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/lac/trilinos_precondition.h>

#include <memory>

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
   * The coarsest level of a V-cycle: a matrix and its sparse factors or, if it
   * has none, one cycle of algebraic multigrid. Symmetric for a symmetric
   * matrix, and the same whenever it is made for the same matrix.
   */
  template <int dim>
  class CoarseSolver
  {
  public:
    /**
     * @param space of the matrix
     * @param has_factors else a cycle of algebraic multigrid
     * @throw ComputationError if the matrix cannot be factorised
     */
    CoarseSolver(const DoFHandler<dim> &space,
                 const Field::Block     field,
                 SparseMatrix         &&matrix,
                 const bool             has_factors);

    void
    solve(Vector &x, const Vector &b) const;

    const SparseMatrix &
    matrix() const
    {
      return factors ? factors->matrix() : *unfactorized;
    }

  private:
    std::unique_ptr<DirectSolver>                      factors;
    std::unique_ptr<const SparseMatrix>                unfactorized;
    std::unique_ptr<TrilinosWrappers::PreconditionAMG> cycle; ///< refers to it

    void
    make_cycle(const DoFHandler<dim> &space, const Field::Block field);
  };



  /** @p matrix with springs, and with held rows and columns of the identity. */
  SparseMatrix
  with_contact(const SparseMatrix &matrix, const ContactRows &rows);
} // namespace ThermoContact

#endif
