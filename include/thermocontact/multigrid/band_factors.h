// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_band_factors_h
#define thermocontact_multigrid_band_factors_h

#include <vector>

namespace ThermoContact
{
  /** A symmetric positive matrix with a band, and its factors $LDL^T$. */
  class BandFactors
  {
  public:
    /** Zeros; entries are between rows no farther apart than @p band. */
    BandFactors(const unsigned int n, const unsigned int band);

    /** Of the matrix or of L and D: of a row and a column not behind it. */
    double &
    entry(const unsigned int row, const unsigned int column)
    {
      return columns[std::size_t(column) * band + row];
    }

    /**
     * In place.
     *
     * @param smallest of its diagonal, what a pivot is at least; 0: no bound
     * @throw ComputationError if there is none and the matrix is not positive
     */
    void
    factorize(const double smallest = 0.);

    /** In place: right-hand side to solution. */
    void
    solve(std::vector<double> &x) const;

  private:
    const unsigned int  n;
    const unsigned int  band;
    std::vector<double> columns; ///< from the diagonal down, behind each other
  };
} // namespace ThermoContact

#endif
