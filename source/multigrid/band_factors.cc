// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/band_factors.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  BandFactors::BandFactors(const unsigned int n, const unsigned int band)
    : n(n)
    , band(band)
    , columns(std::size_t(n) * (band + 1))
  {}



  bool
  BandFactors::factorize()
  {
    for (unsigned int j = 0; j < n; ++j)
      {
        const unsigned int end = std::min(n, j + band + 1);
        if (!(entry(j, j) > 0.))
          return false;
        const double root = std::sqrt(entry(j, j));
        for (unsigned int i = j; i < end; ++i)
          entry(i, j) /= root;
        for (unsigned int k = j + 1; k < end; ++k)
          if (const double factor = entry(k, j); factor != 0.)
            for (unsigned int i = k; i < end; ++i)
              entry(i, k) -= factor * entry(i, j);
      }
    return true;
  }



  void
  BandFactors::solve(std::vector<double> &x) const
  {
    for (unsigned int j = 0; j < n; ++j)
      {
        const double *const column = &columns[std::size_t(j) * band];
        x[j] /= column[j];
        for (unsigned int i = j + 1; i < std::min(n, j + band + 1); ++i)
          x[i] -= column[i] * x[j];
      }
    for (unsigned int j = n; j-- > 0;)
      {
        const double *const column = &columns[std::size_t(j) * band];
        double              sum    = x[j];
        for (unsigned int i = j + 1; i < std::min(n, j + band + 1); ++i)
          sum -= column[i] * x[i];
        x[j] = sum / column[j];
      }
  }
} // namespace ThermoContact
