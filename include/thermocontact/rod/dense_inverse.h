// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_rod_dense_inverse_h
#define thermocontact_rod_dense_inverse_h

#include <vector>

namespace ThermoContact
{
  /**
   * @p a, by columns, becomes its inverse, by Gauss-Jordan elimination with
   * pivots from the columns. Returns the largest residual of a row of it, in
   * units of rounding; infinite without inverse.
   */
  double
  invert(std::vector<double> &a, const unsigned int n);
} // namespace ThermoContact

#endif
