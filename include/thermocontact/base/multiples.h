// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_multiples_h
#define thermocontact_base_multiples_h

#include <thermocontact/base/tolerances.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  /**
   * Number of the multiple of @p interval that @p time is on, or else of the
   * last one before it.
   */
  inline double
  whole_intervals(const double interval, const double time)
  {
    const double ratio = time / interval;
    return std::floor(ratio +
                      (Tolerances::multiple_slack +
                       Tolerances::rounding_of_ratio * ratio)); // rounding
  }



  /**
   * How many intervals it takes from 0 to @p time: the number of the multiple
   * that it is on, or else of the next one; at least 1 if @p time > 0.
   */
  inline double
  intervals_until(const double interval, const double time)
  {
    if (time <= 0.)
      return 0.;
    const double ratio = time / interval;
    return std::max(1.,
                    std::ceil(ratio - (Tolerances::multiple_slack +
                                       Tolerances::rounding_of_ratio * ratio)));
  }



  /** The multiple of @p interval that comes after @p time. */
  inline double
  next_multiple(const double interval, const double time)
  {
    return (whole_intervals(interval, time) + 1.) * interval;
  }
} // namespace ThermoContact

#endif
