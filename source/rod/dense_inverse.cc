// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/rod/dense_inverse.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Gauss-Jordan, in place; false for a pivot of zero. */
    bool
    eliminate(std::vector<double> &a, const unsigned int n)
    {
      std::vector<unsigned int> pivots(n);
      for (unsigned int k = 0; k < n; ++k)
        {
          double *const column = &a[k * n];
          pivots[k]            = k;
          for (unsigned int i = k + 1; i < n; ++i)
            if (std::abs(column[i]) > std::abs(column[pivots[k]]))
              pivots[k] = i;
          if (!(std::abs(column[pivots[k]]) > 0.))
            return false;
          for (unsigned int j = 0; j < n; ++j)
            std::swap(a[j * n + k], a[j * n + pivots[k]]);
          const double inverse = 1. / column[k];
          column[k]            = 1.;
          for (unsigned int j = 0; j < n; ++j)
            a[j * n + k] *= inverse;
          for (unsigned int j = 0; j < n; ++j)
            {
              const double factor = a[j * n + k];
              for (unsigned int i = 0; i < n && j != k; ++i)
                if (i != k)
                  a[j * n + i] -= factor * column[i];
            }
          for (unsigned int i = 0; i < n; ++i)
            if (i != k)
              column[i] *= -inverse;
        }
      for (unsigned int k = n; k-- > 0;)
        if (pivots[k] != k)
          std::swap_ranges(&a[k * n], &a[k * n] + n, &a[pivots[k] * n]);
      return true;
    }



    /** Largest row of $AB-1$, sums of absolute values. */
    double
    residual(const std::vector<double> &a,
             const std::vector<double> &b,
             const unsigned int         n)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          double sum = 0.;
          for (unsigned int j = 0; j < n; ++j)
            {
              double entry = i == j ? -1. : 0.;
              for (unsigned int k = 0; k < n; ++k)
                entry += a[k * n + i] * b[j * n + k];
              sum += std::abs(entry);
            }
          if (!(sum <= largest))
            largest = sum;
        }
      return largest;
    }
  } // namespace



  double
  invert(std::vector<double> &a, const unsigned int n)
  {
    // rows of different fields have different units
    std::vector<double> scales(n, 0.);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        scales[i] = std::max(scales[i], std::abs(a[j * n + i]));
    for (const double scale : scales)
      if (!(scale > 0.) || !std::isfinite(scale))
        return infinity;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        a[j * n + i] /= scales[i];
    const std::vector<double> scaled(a);
    if (!eliminate(a, n))
      return infinity;
    const double error = residual(scaled, a, n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        a[j * n + i] /= scales[j];
    return error / std::numeric_limits<double>::epsilon();
  }
} // namespace ThermoContact
