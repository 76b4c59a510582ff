// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_shares_h
#define thermocontact_base_shares_h

#include <vector>

namespace ThermoContact
{
  /**
   * Whole numbers in proportion to weights: each at least 1, together @p n or,
   * if that is less, the number of the weights.
   */
  std::vector<unsigned int>
  shares(const std::vector<double> &weights, const unsigned int n);
} // namespace ThermoContact

#endif
