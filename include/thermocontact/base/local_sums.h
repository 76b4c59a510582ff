// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_local_sums_h
#define thermocontact_base_local_sums_h

#include <thermocontact/base/types.h>

#include <algorithm>
#include <array>
#include <vector>

namespace ThermoContact
{
  /**
   * Sums of vectors of one layout without ghosts, in one pass over the entries
   * of this process. For a rod of a hundred unknowns the operations of deal.II,
   * one after the other, cost more than the equations.
   */
  struct Multiple
  {
    double        factor;
    const Vector *vector;
  };



  namespace internal
  {
    template <unsigned int n>
    void
    set_local_sum(double            *y,
                  const double      *base,
                  const Multiple    *multiples,
                  const unsigned int size)
    {
      std::array<double, n>         factors;
      std::array<const double *, n> x;
      for (unsigned int k = 0; k < n; ++k)
        {
          factors[k] = multiples[k].factor;
          x[k]       = multiples[k].vector->begin();
        }
#pragma omp simd
      for (unsigned int i = 0; i < size; ++i)
        {
          double sum = base[i];
          for (unsigned int k = 0; k < n; ++k)
            sum += factors[k] * x[k][i];
          y[i] = sum;
        }
    }
  } // namespace internal



  /** @p y $=$ @p base $+\sum_{k<n}$ factor$_k\,x_k$; @p y may be @p base. */
  inline void
  set_sum(Vector            &y,
          const Vector      &base,
          const Multiple    *multiples,
          const unsigned int n)
  {
    const unsigned int size = y.locally_owned_size();
    AssertDimension(size, base.locally_owned_size());
    // four at a time
    const double *start = base.begin();
    unsigned int  k     = 0;
    for (; k + 4 <= n; k += 4, start = y.begin())
      internal::set_local_sum<4>(y.begin(), start, multiples + k, size);
    switch (n - k)
      {
        case 3:
          internal::set_local_sum<3>(y.begin(), start, multiples + k, size);
          break;
        case 2:
          internal::set_local_sum<2>(y.begin(), start, multiples + k, size);
          break;
        case 1:
          internal::set_local_sum<1>(y.begin(), start, multiples + k, size);
          break;
        default:
          if (start != y.begin())
            std::copy(start, start + size, y.begin());
      }
  }



  /** @p y $=$ @p base $+$ @p factor @p x. */
  inline void
  set_sum(Vector &y, const Vector &base, const double factor, const Vector &x)
  {
    const Multiple multiple = {factor, &x};
    set_sum(y, base, &multiple, 1);
  }



  /** @p y $=$ @p factor $(x-z)$. */
  inline void
  set_difference(Vector       &y,
                 const double  factor,
                 const Vector &x,
                 const Vector &z)
  {
    const double *const a    = x.begin();
    const double *const b    = z.begin();
    double *const       c    = y.begin();
    const unsigned int  size = y.locally_owned_size();
#pragma omp simd
    for (unsigned int i = 0; i < size; ++i)
      c[i] = factor * (a[i] - b[i]);
  }



  /**
   * @p y $=x$, of the same layout. By entries, as set_zero(): the assignments
   * of deal.II clear ghost values too, which from 9.5 on allocates, even where
   * there are none.
   */
  inline void
  set_equal(Vector &y, const Vector &x)
  {
    AssertDimension(y.locally_owned_size(), x.locally_owned_size());
    std::copy(x.begin(), x.end(), y.begin());
  }



  /** @p y $=0$. */
  inline void
  set_zero(Vector &y)
  {
    std::fill(y.begin(), y.end(), 0.);
  }



  // Sums over the entries of this process alone, of vectors without ghosts;
  // entries are positions in its part.

  inline double
  local_sum(const Vector &x)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
      sum += x.begin()[i];
    return sum;
  }

  inline double
  local_product(const Vector &x, const Vector &y)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
      sum += x.begin()[i] * y.begin()[i];
    return sum;
  }

  inline double
  sum_at(const std::vector<unsigned int> &entries, const Vector &x)
  {
    double sum = 0.;
    for (const unsigned int entry : entries)
      sum += x.begin()[entry];
    return sum;
  }

  inline double
  product_at(const std::vector<unsigned int> &entries,
             const Vector                    &x,
             const Vector                    &y)
  {
    double sum = 0.;
    for (const unsigned int entry : entries)
      sum += x.begin()[entry] * y.begin()[entry];
    return sum;
  }
} // namespace ThermoContact

#endif
