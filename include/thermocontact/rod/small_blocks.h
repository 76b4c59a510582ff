// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_rod_small_blocks_h
#define thermocontact_rod_small_blocks_h

#include <array>
#include <cmath>

namespace ThermoContact
{
  /** Blocks of one or two fields, by rows; and their columns. */
  template <std::size_t n>
  using Small = std::array<double, n>;

  inline Small<1>
  inverse(const Small<1> &a)
  {
    return {{1. / a[0]}};
  }

  inline Small<4>
  inverse(const Small<4> &a)
  {
    const double q = 1. / (a[0] * a[3] - a[1] * a[2]);
    return {{a[3] * q, -a[1] * q, -a[2] * q, a[0] * q}};
  }

  inline Small<1>
  operator*(const Small<1> &a, const Small<1> &b)
  {
    return {{a[0] * b[0]}};
  }

  inline Small<4>
  operator*(const Small<4> &a, const Small<4> &b)
  {
    return {{a[0] * b[0] + a[1] * b[2],
             a[0] * b[1] + a[1] * b[3],
             a[2] * b[0] + a[3] * b[2],
             a[2] * b[1] + a[3] * b[3]}};
  }

  template <std::size_t n>
  void
  subtract(Small<n> &a, const Small<n> &b)
  {
    for (unsigned int i = 0; i < n; ++i)
      a[i] -= b[i];
  }

  /** @p y $-=$ @p a @p x. */
  inline void
  subtract_product(Small<1> &y, const Small<1> &a, const Small<1> &x)
  {
    y[0] -= a[0] * x[0];
  }

  inline void
  subtract_product(Small<2> &y, const Small<4> &a, const Small<2> &x)
  {
    y[0] -= a[0] * x[0] + a[1] * x[1];
    y[1] -= a[2] * x[0] + a[3] * x[1];
  }

  inline Small<1>
  product(const Small<1> &a, const Small<1> &x)
  {
    return {{a[0] * x[0]}};
  }

  inline Small<2>
  product(const Small<4> &a, const Small<2> &x)
  {
    return {{a[0] * x[0] + a[1] * x[1], a[2] * x[0] + a[3] * x[1]}};
  }



  /**
   * How much larger the terms of a determinant are than itself; infinite or NaN
   * if it vanishes.
   */
  inline double
  cancellation(const Small<1> &a)
  {
    return std::abs(a[0]) / std::abs(a[0]);
  }

  inline double
  cancellation(const Small<4> &a)
  {
    return (std::abs(a[0] * a[3]) + std::abs(a[1] * a[2])) /
           std::abs(a[0] * a[3] - a[1] * a[2]);
  }
} // namespace ThermoContact

#endif
