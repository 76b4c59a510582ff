// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_bracketed_root_h
#define thermocontact_method_bracketed_root_h

#include <thermocontact/base/exceptions.h>

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
   *   zero. Where rounding has made them the same, or low is not below high,
   *   the answer is the end at which the function is closer to zero, twice.
   * @param at_low,at_high the values there
   * @throw ComputationError if one of them is not a number
   */
  template <typename Function>
  std::pair<double, double>
  bracketed_root(const Function &function,
                 const double    low,
                 const double    high,
                 const double    at_low,
                 const double    at_high)
  {
    const bool is_bracket = low < high && ((at_low <= 0. && at_high >= 0.) ||
                                           (at_low >= 0. && at_high <= 0.));
    if (!is_bracket) // the library would throw
      {
        if (std::isnan(at_low) || std::isnan(at_high))
          throw ComputationError("a contact law or heat exchange is not a "
                                 "number\n  remedy:  a smaller Time/Step size, "
                                 "or another formula");
        const double end = std::abs(at_high) < std::abs(at_low) ? high : low;
        return {end, end};
      }
    const auto are_neighbours = [](const double a, const double b) {
      return std::nextafter(a, b) >= b;
    };
    std::uintmax_t max_evaluations = 198;
    return boost::math::tools::toms748_solve(
      function, low, high, at_low, at_high, are_neighbours, max_evaluations);
  }



  template <typename Function>
  std::pair<double, double>
  bracketed_root(const Function &function, const double low, const double high)
  {
    return bracketed_root(function, low, high, function(low), function(high));
  }
} // namespace ThermoContact

#endif
