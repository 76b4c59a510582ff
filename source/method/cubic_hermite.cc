// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/method/bracketed_root.h>
#include <thermocontact/method/cubic_hermite.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  CubicHermite::CubicHermite(const double s0,
                             const double slope0,
                             const double s1,
                             const double slope1)
    : s0(s0)
    , slope0(slope0)
    , s1(s1)
    , slope1(slope1)
    , quadratic(3. * (s1 - s0) - 2. * slope0 - slope1)
    , cubic(2. * (s0 - s1) + slope0 + slope1)
  {}



  double
  CubicHermite::value(const double x) const
  {
    return x == 1. ? s1 : s0 + x * (slope0 + x * (quadratic + x * cubic));
  }



  double
  CubicHermite::slope(const double x) const
  {
    return x == 1. ? slope1 : slope0 + x * (2. * quadratic + x * 3. * cubic);
  }



  double
  CubicHermite::zero_near_end() const
  {
    double x = 1.;
    for (unsigned int i = 0; i < 10; ++i)
      if (const double rate = slope(x); rate != 0.)
        x -= value(x) / rate;
    return std::abs(x - 1.) <= 0.5 ? x : 1.;
  }



  double
  CubicHermite::first_zero(const double tolerable_dip) const
  {
    // the extrema divide the interval into pieces where s is monotone
    std::array<double, 4> points = {{0., 1., 1., 1.}};
    unsigned int          n      = 1;
    const double discriminant    = quadratic * quadratic - 3. * cubic * slope0;
    if (discriminant > 0.)
      {
        const double q =
          -(quadratic + std::copysign(std::sqrt(discriminant), quadratic));
        double x1 = cubic != 0. ? q / (3. * cubic) : infinity;
        double x2 = q != 0. ? slope0 / q : infinity;
        if (x1 > x2)
          std::swap(x1, x2);
        for (const double x : {x1, x2})
          if (x > 0. && x < 1.)
            points[n++] = x;
      }

    bool is_positive = s0 >= 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double low    = points[i];
        const double high   = i + 1 < n ? points[i + 1] : 1.;
        const double s_high = value(high);
        if (!is_positive)
          {
            is_positive = s_high > 0.;
            continue; // rising: no zero that counts
          }
        if (s_high >= 0. || (high < 1. && s_high >= -tolerable_dip))
          continue;
        if (value(low) < 0.)
          return low; // in a dip that is tolerated, which does not end
        // zero itself is not negative
        return bracketed_root(
                 [this](const double x) {
                   const double s = value(x);
                   return s == 0. ? std::numeric_limits<double>::min() : s;
                 },
                 low,
                 high)
          .second;
      }
    return is_positive ? infinity : 0.;
  }
} // namespace ThermoContact
