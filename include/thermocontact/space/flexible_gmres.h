// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_flexible_gmres_h
#define thermocontact_space_flexible_gmres_h

#include <thermocontact/base/types.h>

#include <deal.II/lac/la_parallel_block_vector.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /**
   * GMRES with a preconditioner from the right that may differ from one
   * iteration to the next, as it does by rounding if it computes in single
   * precision (Saad 1993). The directions it returns are kept, in single
   * precision, and it is the rounded ones that the matrix is applied to: the
   * residual that is estimated is that of the solution to the rounding of
   * double precision. Starts at zero, which costs no product.
   */
  class FlexibleGmres
  {
  public:
    /** @param max_directions that are kept before it starts again */
    explicit FlexibleGmres(const unsigned int max_directions);

    struct Result
    {
      unsigned int n_iterations;
      double       residual; ///< estimate of its norm
    };

    /**
     * Improves the solution of $Ax=b$ from zero until the estimate of the
     * residual is below a tolerance. Collective.
     *
     * @param matrix,preconditioner objects with vmult(BlockVector &y, const
     *   BlockVector &x)
     * @param max_iterations the result is above the tolerance if more were
     *   needed
     */
    template <typename Matrix, typename Preconditioner>
    Result
    solve(const Matrix         &matrix,
          const Preconditioner &preconditioner,
          const double          tolerance,
          const unsigned int    max_iterations,
          const BlockVector    &b,
          BlockVector          &x);

  private:
    using SingleVector = LinearAlgebra::distributed::BlockVector<float>;

    /** A direction, each field over its largest entry. */
    struct Direction
    {
      SingleVector          values;
      std::array<double, 2> scales;
    };

    const unsigned int       max_directions;
    std::vector<BlockVector> basis;
    std::vector<Direction>   directions;
    BlockVector              residual, direction; ///< to work with
    double                   residual_norm = 0.;

    /** Rotated columns of the Hessenberg matrix, and the rotations. */
    std::vector<std::vector<double>>   columns;
    std::vector<std::array<double, 2>> rotations;
    std::vector<double>                projected; ///< right-hand side

    /** Rounds the present direction and keeps it. */
    void
    keep_direction();

    /** Makes its product with the matrix orthogonal to the basis. */
    void
    orthogonalize(const unsigned int j);

    /** Rotates the last column; @return the norm of the residual. */
    double
    rotate(const unsigned int j);

    /** Adds the best combination of the first @p n directions to @p x. */
    void
    add_solution(const unsigned int n, BlockVector &x) const;

    /** Begins with the residual of that norm. */
    void
    start(const double norm);

    /** The residual over its norm is the next vector of the basis. */
    void
    extend_basis();
  };



  template <typename Matrix, typename Preconditioner>
  FlexibleGmres::Result
  FlexibleGmres::solve(const Matrix         &matrix,
                       const Preconditioner &preconditioner,
                       const double          tolerance,
                       const unsigned int    max_iterations,
                       const BlockVector    &b,
                       BlockVector          &x)
  {
    residual.reinit(b, true);
    residual = b;
    direction.reinit(b, true);
    x = 0.;
    Result result{0, residual.l2_norm()};
    while (result.residual > tolerance && result.n_iterations < max_iterations)
      {
        start(result.residual);
        unsigned int n = 0;
        for (; n < max_directions && result.residual > tolerance &&
               result.n_iterations < max_iterations;
             ++n, ++result.n_iterations)
          {
            extend_basis();
            preconditioner.vmult(direction, basis[n]);
            keep_direction();
            matrix.vmult(residual, direction);
            orthogonalize(n);
            result.residual = rotate(n);
          }
        add_solution(n, x);
        // they would add to what is there while a step is written
        basis.clear();
        directions.clear();
        if (result.residual > tolerance)
          {
            matrix.vmult(residual, x);
            residual.sadd(-1., 1., b);
            result.residual = residual.l2_norm();
          }
      }
    residual.reinit(0);
    direction.reinit(0);
    return result;
  }
} // namespace ThermoContact

#endif
