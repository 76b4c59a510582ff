// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_coarse_solver_h
#define thermocontact_multigrid_coarse_solver_h

#include <vector>

namespace ThermoContact
{
  /**
   * The coarsest level of a V-cycle: a symmetric positive matrix with a band,
   * and its Cholesky factor, whole on every rank.
   */
  class CoarseSolver
  {
  public:
    /**
     * @param n_rows of a matrix of zeros
     * @param bandwidth the largest difference of a row and a column
     */
    CoarseSolver(const unsigned int n_rows, const unsigned int bandwidth);

    /** Adds to an entry; those above the diagonal are ignored. */
    void
    add(const unsigned int row, const unsigned int column, const double value);

    /** A row and column of the identity. */
    void
    hold(const unsigned int row);

    /** @throw ComputationError if the matrix is not positive */
    void
    factorise();

    /** The solution in place of the right-hand side. */
    void
    solve(std::vector<double> &x) const;

  private:
    const unsigned int  n;
    const unsigned int  width;
    std::vector<double> rows; ///< the band left of the diagonal, and that

    /** Points to column 0 of a row, which need not be in the band. */
    const double *
    row(const unsigned int i) const
    {
      return rows.data() + std::ptrdiff_t(i) * width + width;
    }
  };
} // namespace ThermoContact

#endif
