// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Quadratic forms of the matrices of a rod.

#include <thermocontact/rod/fixed_degree.h>
#include <thermocontact/rod/rod_matrices.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /**
     * $\sum x\cdot Ax$ over the linear cells of a run. A stiffness is a sum of
     * squares of differences, the mass of one point to a cell of sums: as such
     * the energy of a displacement that is large beside its strain, or of a
     * velocity that alternates, keeps its digits.
     */
    template <typename Value>
    double
    linear_form(const RodMatrices::Run &run, const double *a, const Value &x)
    {
      const double LL = a[0], LR_RL = a[1] + a[2], RR = a[3];
      const double size = 0.5 * std::abs(LR_RL), sign = LR_RL < 0. ? -1. : 1.;
      const double rounding = 4. * std::numeric_limits<double>::epsilon();
      double       sum      = 0.;
      if (std::max(std::abs(LL - size), std::abs(RR - size)) <= rounding * size)
        {
#pragma omp simd reduction(+ : sum)
          for (unsigned int i = run.begin; i < run.end; ++i)
            {
              const double joint = x(i + 1) + sign * x(i);
              sum += joint * joint;
            }
          return size * sum;
        }
#pragma omp simd reduction(+ : sum)
      for (unsigned int i = run.begin; i < run.end; ++i)
        {
          const double left = x(i), right = x(i + 1);
          sum += right * (RR * right + LR_RL * left) + LL * left * left;
        }
      return sum;
    }



    /** Cells of any degree. */
    template <unsigned int fixed_degree, typename Value>
    double
    form_of_cells(const RodLayout        &layout,
                  const RodMatrices::Run &run,
                  const double           *a,
                  const bool              is_of_differences,
                  const double           *of_constant,
                  const Value            &x)
    {
      const unsigned int p   = fixed_degree > 0 ? fixed_degree : layout.degree;
      const unsigned int n   = p + 1;
      double             sum = 0.;
      for (unsigned int cell = run.begin; cell < run.end; ++cell)
        {
          const unsigned int first = cell * p + 1;
          const double       left  = x(layout.left_vertex(cell));
          const double       zero  = is_of_differences ? left : 0.;
          for (unsigned int j = is_of_differences; j < n; ++j)
            {
              const double *const column  = a + j * n;
              double              product = column[0] * (left - zero);
              for (unsigned int i = 0; i < p; ++i)
                product += column[i + 1] * (x(first + i) - zero);
              sum += product * (j == 0 ? left : x(first + j - 1) - zero);
            }
          if (is_of_differences && of_constant != nullptr)
            {
              // (d + c) A (d + c) with a constant c
              double of_left = of_constant[0] * left;
              for (unsigned int i = 0; i < p; ++i)
                of_left += of_constant[i + 1] * (2. * x(first + i) - left);
              sum += left * of_left;
            }
        }
      return sum;
    }



    template <typename Value>
    double
    sum_of_forms(const RodMatrices        &matrices,
                 const RodMatrices::Matrix matrix,
                 const Value              &x)
    {
      const RodLayout &layout = matrices.layout();
      return with_fixed_degree(layout.degree, [&](const auto degree) {
        double sum = 0.;
        for (const RodMatrices::Run &run : matrices.runs())
          {
            const double *const a = matrices.entries(run, matrix);
            if constexpr (degree.value == 1)
              sum += linear_form(run, a, x);
            else
              sum +=
                form_of_cells<degree.value>(layout,
                                            run,
                                            a,
                                            matrices.is_of_differences(run,
                                                                       matrix),
                                            matrices.of_constant(run, matrix),
                                            x);
          }
        return sum;
      });
    }
  } // namespace



  double
  RodMatrices::form(const Matrix matrix, const double *x) const
  {
    return sum_of_forms(*this, matrix, [x](const unsigned int i) {
      return x[i];
    });
  }



  double
  RodMatrices::form_of_difference(const Matrix  matrix,
                                  const double *x,
                                  const double *y) const
  {
    return sum_of_forms(*this, matrix, [x, y](const unsigned int i) {
      return x[i] - y[i];
    });
  }
} // namespace ThermoContact
