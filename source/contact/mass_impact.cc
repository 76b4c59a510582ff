// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/mass_impact.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Impacts of a step that are told; bounces that last longer go on. */
    constexpr unsigned int max_impacts = 1000;



    /**
     * When a mass at @p s<=0 with this velocity and acceleration reaches the
     * surface; infinite: never. One that is there and does not move away is at
     * once.
     */
    double
    time_to_surface(const double s, const double v, const double a)
    {
      if (s >= 0. && (v > 0. || (v == 0. && a > 0.)))
        return 0.;
      // s + v t + a t^2/2 = 0; the first root behind the start
      if (a == 0.)
        return v > 0. ? -s / v : infinity;
      const double square = v * v - 2. * a * s;
      if (square < 0.)
        return infinity;
      const double root = std::sqrt(square);
      if (v >= 0.)
        return v + root > 0. ? -2. * s / (v + root) : infinity;
      return a > 0. ? (root - v) / a : infinity;
    }
  } // namespace



  MassImpacts
  follow_masses(const MassPath &path)
  {
    const double a = path.acceleration, e = path.restitution;
    double       s = path.penetration, v = path.velocity, t = 0.;
    MassImpacts  result{s, v, 0., 0., false, 0., {}};
    const auto   rest_until_end = [&]() {
      result.penetration = result.velocity = 0.;
      result.is_closed                     = true;
      result.change                        = -path.velocity - a * path.size;
      return result;
    };
    if (path.is_closed)
      {
        if (a >= 0. && v >= 0.)
          return rest_until_end();
        result.change_time = 0.; // drawn away
      }
    while (result.impacts.size() < max_impacts)
      {
        const double to_surface = time_to_surface(s, v, a);
        if (!(t + to_surface < path.size))
          break;
        t += to_surface;
        const double arriving = std::max(0., v + a * to_surface);
        s                     = 0.;
        v                     = -e * arriving;
        result.loss += 0.5 * (arriving * arriving - v * v);
        // all that follow, the last one in no time
        const double bounces = a > 0. && e < 1. ? -2. * v / (a * (1. - e)) :
                               arriving == 0.   ? 0. :
                                                  infinity;
        if (a > 0. &&
            t + bounces < path.size * (1. + Tolerances::rounding_of_data))
          {
            result.loss += 0.5 * v * v;
            result.change_time = t + bounces;
            if (arriving > 0.)
              result.impacts.push_back({t, arriving});
            return rest_until_end();
          }
        result.impacts.push_back({t, arriving});
        if (v == 0. && a <= 0.)
          break; // leaves with what draws it
      }
    if (result.impacts.size() == max_impacts && a > 0.)
      {
        result.loss += 0.5 * v * v;
        result.change_time = t; // as good as at rest
        return rest_until_end();
      }
    const double left  = path.size - t;
    result.penetration = std::min(0., s + left * (v + 0.5 * a * left));
    result.velocity    = v + a * left;
    result.change      = result.velocity - path.velocity - a * path.size;
    return result;
  }
} // namespace ThermoContact
