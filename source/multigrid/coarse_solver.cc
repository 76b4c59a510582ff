// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/multigrid/coarse_solver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ThermoContact
{
  CoarseSolver::CoarseSolver(const unsigned int n_rows,
                             const unsigned int bandwidth)
    : n(n_rows)
    , width(std::min(bandwidth, n_rows - 1))
    , rows(std::size_t(n_rows) * (width + 1), 0.)
  {}



  void
  CoarseSolver::add(const unsigned int row_number,
                    const unsigned int column,
                    const double       value)
  {
    if (column <= row_number)
      const_cast<double *>(row(row_number))[column] += value;
  }



  void
  CoarseSolver::hold(const unsigned int held)
  {
    const auto entry = [this](const unsigned int i, const unsigned int j) {
      return const_cast<double *>(row(i)) + j;
    };
    for (unsigned int j = held - std::min(held, width); j < held; ++j)
      *entry(held, j) = 0.;
    for (unsigned int i = held + 1; i < std::min(n, held + width + 1); ++i)
      *entry(i, held) = 0.;
    *entry(held, held) = 1.;
  }



  void
  CoarseSolver::factorise()
  {
    for (unsigned int i = 0; i < n; ++i)
      {
        double            *own   = const_cast<double *>(row(i));
        const unsigned int first = i - std::min(i, width);
        for (unsigned int j = first; j <= i; ++j)
          {
            const double *other = row(j);
            double        sum   = own[j];
            for (unsigned int k = std::max(first, j - std::min(j, width));
                 k < j;
                 ++k)
              sum -= own[k] * other[k];
            if (j < i)
              own[j] = sum / other[j];
            else if (sum > 0.)
              own[i] = std::sqrt(sum);
            else
              throw ComputationError(
                text("the coarsest level of multigrid is not positive in row ",
                     i,
                     "\n  remedy:  check the coefficients of section Model, "
                     "the mesh and Time/Step size for extreme values"));
          }
      }
  }



  void
  CoarseSolver::solve(std::vector<double> &x) const
  {
    for (unsigned int i = 0; i < n; ++i)
      {
        const double *own = row(i);
        for (unsigned int j = i - std::min(i, width); j < i; ++j)
          x[i] -= own[j] * x[j];
        x[i] /= own[i];
      }
    for (unsigned int i = n; i-- > 0;)
      {
        const double *own = row(i);
        x[i] /= own[i];
        for (unsigned int j = i - std::min(i, width); j < i; ++j)
          x[j] -= own[j] * x[i];
      }
  }
} // namespace ThermoContact
