// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_direct_solver_h
#define thermocontact_space_direct_solver_h

#include <thermocontact/base/types.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_solver.h>

namespace ThermoContact
{
  /**
   * A matrix and its sparse LU factors (Amesos KLU, gathered on one rank).
   * Factorised once at construction.
   */
  class DirectSolver
  {
  public:
    /** @throw ComputationError if the matrix cannot be factorised. */
    explicit DirectSolver(SparseMatrix &&matrix);

    /** Back-substitution $x = A^{-1} b$, both without ghosts. */
    template <typename VectorType>
    void
    solve(VectorType &x, const VectorType &b);

    const SparseMatrix &
    matrix() const
    {
      return matrix_;
    }

  private:
    const SparseMatrix             matrix_;
    SolverControl                  control;
    TrilinosWrappers::SolverDirect solver;
  };
} // namespace ThermoContact

#endif
