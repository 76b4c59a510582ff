// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_rod_dense_inverse_h
#define thermocontact_rod_dense_inverse_h

#include <vector>

namespace ThermoContact
{
  /**
   * @p a, by columns, becomes its inverse, by Gauss-Jordan elimination with
   * pivots from the columns, its rows scaled to the same size before.
   *
   * @return the largest sum of a row of |A inverse - 1|, rows scaled so, in
   *   units of rounding; infinite without inverse, when @p a is of no use
   */
  double
  invert(std::vector<double> &a, const unsigned int n);
} // namespace ThermoContact

#endif
