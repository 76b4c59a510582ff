// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_conjugate_gradients_h
#define thermocontact_space_conjugate_gradients_h

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <string>

namespace ThermoContact
{
  /**
   * Solves a symmetric positive definite system.
   *
   * @param what of which it is the solution, for the message
   * @param x out
   * @param preconditioner with vmult(), symmetric
   * @param tolerance residual relative to @p b
   * @return number of iterations
   * @throw ComputationError if that is not reached in @p max_iterations
   */
  template <typename VectorType, typename Matrix, typename Preconditioner>
  unsigned int
  conjugate_gradients(const std::string    &what,
                      const Matrix         &matrix,
                      VectorType           &x,
                      const VectorType     &b,
                      const Preconditioner &preconditioner,
                      const double          tolerance,
                      const unsigned int    max_iterations = 100000)
  {
    x                 = 0.;
    const double size = b.l2_norm();
    if (size == 0.)
      return 0;
    dealii::SolverControl control(max_iterations,
                                  tolerance * size,
                                  false,
                                  false);
    try
      {
        dealii::SolverCG<VectorType>(control).solve(matrix,
                                                    x,
                                                    b,
                                                    preconditioner);
        return control.last_step();
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        throw ComputationError(text(
          what,
          ": conjugate gradients reached a relative residual of ",
          significant(control.last_value() / size, few_digits),
          " instead of ",
          significant(tolerance, few_digits),
          " in ",
          control.last_step(),
          " iterations\n  remedy:  Solver/Linear solver = direct, or cells "
          "that are cubes"));
      }
  }
} // namespace ThermoContact

#endif
