// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_rod_fixed_degree_h
#define thermocontact_rod_fixed_degree_h

#include <type_traits>

namespace ThermoContact
{
  /**
   * Calls @p function with the degree as a constant of the compiler, which
   * unrolls the loops over a cell; with 0 for degrees that are not worth it.
   */
  template <typename Function>
  auto
  with_fixed_degree(const unsigned int degree, const Function &function)
  {
    using std::integral_constant;
    switch (degree)
      {
        case 1:
          return function(integral_constant<unsigned int, 1>());
        case 2:
          return function(integral_constant<unsigned int, 2>());
        case 3:
          return function(integral_constant<unsigned int, 3>());
        case 4:
          return function(integral_constant<unsigned int, 4>());
        case 5:
          return function(integral_constant<unsigned int, 5>());
        case 6:
          return function(integral_constant<unsigned int, 6>());
        default:
          return function(integral_constant<unsigned int, 0>());
      }
  }
} // namespace ThermoContact

#endif
