// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/multigrid/band_factors.h>

#include <algorithm>

namespace ThermoContact
{
  BandFactors::BandFactors(const unsigned int n, const unsigned int band)
    : n(n)
    , band(band)
    , columns(std::size_t(n) * (band + 1))
  {}



  void
  BandFactors::factorize(const double smallest)
  {
    std::vector<double> least(n);
    for (unsigned int j = 0; j < n; ++j)
      least[j] = smallest * entry(j, j);
    for (unsigned int j = 0; j < n; ++j)
      {
        const unsigned int end = std::min(n, j + band + 1);
        if (entry(j, j) < least[j])
          entry(j, j) = least[j];
        if (smallest == 0. && !(entry(j, j) > 0.))
          throw ComputationError(
            "a matrix of multigrid is not positive\n"
            "  remedy:  check the coefficients of section Model, the mesh and "
            "Time/Step size for extreme values");
        const double inverse = 1. / entry(j, j);
        for (unsigned int k = j + 1; k < end; ++k)
          if (const double factor = inverse * entry(k, j); factor != 0.)
            for (unsigned int i = k; i < end; ++i)
              entry(i, k) -= factor * entry(i, j);
        for (unsigned int i = j + 1; i < end; ++i)
          entry(i, j) *= inverse;
      }
  }



  void
  BandFactors::solve(std::vector<double> &x) const
  {
    for (unsigned int j = 0; j < n; ++j)
      {
        const double *const column = &columns[std::size_t(j) * band];
        for (unsigned int i = j + 1; i < std::min(n, j + band + 1); ++i)
          x[i] -= column[i] * x[j];
      }
    for (unsigned int j = n; j-- > 0;)
      {
        const double *const column = &columns[std::size_t(j) * band];
        double              sum    = x[j] / column[j];
        for (unsigned int i = j + 1; i < std::min(n, j + band + 1); ++i)
          sum -= column[i] * x[i];
        x[j] = sum;
      }
  }
} // namespace ThermoContact
