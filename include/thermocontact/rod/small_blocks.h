// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_rod_small_blocks_h
#define thermocontact_rod_small_blocks_h

#include <array>
#include <cmath>

namespace ThermoContact
{
  /** Blocks of one to three fields, by rows; and their columns. */
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

  /** Cofactors of rows and columns next to these, in cyclic order. */
  inline double
  cofactor(const Small<9> &a, const unsigned int row, const unsigned int column)
  {
    const unsigned int r = (row + 1) % 3, s = (row + 2) % 3;
    const unsigned int c = (column + 1) % 3, d = (column + 2) % 3;
    return a[3 * r + c] * a[3 * s + d] - a[3 * r + d] * a[3 * s + c];
  }

  inline Small<9>
  inverse(const Small<9> &a)
  {
    Small<9> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        result[3 * j + i] = cofactor(a, i, j);
    const double q =
      1. / (a[0] * result[0] + a[1] * result[3] + a[2] * result[6]);
    for (double &entry : result)
      entry *= q;
    return result;
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

  inline Small<9>
  operator*(const Small<9> &a, const Small<9> &b)
  {
    Small<9> result{};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          result[3 * i + j] += a[3 * i + k] * b[3 * k + j];
    return result;
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

  inline void
  subtract_product(Small<3> &y, const Small<9> &a, const Small<3> &x)
  {
    for (unsigned int i = 0; i < 3; ++i)
      y[i] -= a[3 * i] * x[0] + a[3 * i + 1] * x[1] + a[3 * i + 2] * x[2];
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


  inline Small<3>
  product(const Small<9> &a, const Small<3> &x)
  {
    Small<3> y;
    for (unsigned int i = 0; i < 3; ++i)
      y[i] = a[3 * i] * x[0] + a[3 * i + 1] * x[1] + a[3 * i + 2] * x[2];
    return y;
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

  inline double
  cancellation(const Small<9> &a)
  {
    double terms = 0., sum = 0.;
    for (unsigned int j = 0; j < 3; ++j)
      {
        const unsigned int c = (j + 1) % 3, d = (j + 2) % 3;
        terms += std::abs(a[j]) * (std::abs(a[3 + c] * a[6 + d]) +
                                   std::abs(a[3 + d] * a[6 + c]));
        sum += a[j] * cofactor(a, 0, j);
      }
    return terms / std::abs(sum);
  }
} // namespace ThermoContact

#endif
