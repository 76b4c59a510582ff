// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/space/direct_solver.h>

#include <string>

namespace ThermoContact
{
  DirectSolver::DirectSolver(SparseMatrix &&matrix)
    : matrix_(std::move(matrix))
    , control(1, 0., false, false) // its log costs as much as the solve
    , solver(control)
  {
    try
      {
        solver.initialize(matrix_);
      }
    catch (const ExceptionBase &)
      {
        throw ComputationError(
          "the sparse factorisation (KLU) of a matrix of size " +
          std::to_string(matrix_.m()) +
          " failed: it is singular in floating point\n  remedy:  check the "
          "coefficients of section Model, the mesh and Time/Step size for "
          "extreme values");
      }
  }



  template <typename VectorType>
  void
  DirectSolver::solve(VectorType &x, const VectorType &b)
  {
    solver.solve(x, b);
  }



  template void
  DirectSolver::solve(Vector &, const Vector &);
  template void
  DirectSolver::solve(SystemVector &, const SystemVector &);
} // namespace ThermoContact
