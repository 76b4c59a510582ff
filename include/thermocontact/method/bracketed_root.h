// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_bracketed_root_h
#define thermocontact_method_bracketed_root_h

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <utility>

namespace ThermoContact
{
  /**
   * The two numbers next to a change of sign of @p function, by the method of
   * Alefeld, Potra and Shi (TOMS 748): the first on the side of @p low, the
   * second on that of @p high; nearly always neighbours among the
   * floating-point numbers.
   *
   * @param low,high a bracket: the signs there differ, or one of the values is
   *   zero
   */
  template <typename Function>
  std::pair<double, double>
  bracketed_root(const Function &function, const double low, const double high)
  {
    const auto are_neighbours = [](const double a, const double b) {
      return std::nextafter(a, b) >= b;
    };
    std::uintmax_t max_evaluations = 200;
    return boost::math::tools::toms748_solve(
      function, low, high, are_neighbours, max_evaluations);
  }
} // namespace ThermoContact

#endif
