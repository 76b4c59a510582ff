// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
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



    double
    time_to_surface(const MassMotion &at)
    {
      return std::isinf(at.penetration) ?
               infinity :
               time_to_surface(at.penetration, at.velocity, at.acceleration);
    }



    void
    fly(MassMotion &at, const double time)
    {
      at.penetration += time * (at.velocity + 0.5 * at.acceleration * time);
      at.velocity += at.acceleration * time;
    }
  } // namespace



  MassImpacts
  follow_masses(const MassPath &path)
  {
    const double e     = path.restitution;
    MassMotion   front = path.front, rear = path.rear;
    double       t = 0.;
    MassImpacts  result{front.penetration, front.velocity, 0., 0., 0, 0., {}};
    const auto   rest_until_end = [&](const int side) {
      const MassMotion &at = side > 0 ? path.front : path.rear;
      result.held_at       = side;
      result.change = side * (-at.velocity - at.acceleration * path.size);
      result.penetration = result.velocity = 0.; // of one in front
      return result;
    };
    if (path.held_at != 0)
      {
        const MassMotion &at = path.held_at > 0 ? front : rear;
        if (at.acceleration >= 0. && at.velocity >= 0.)
          return rest_until_end(path.held_at);
        result.change_time = 0.; // drawn away
      }
    while (true)
      {
        const double to_front   = time_to_surface(front);
        const double to_rear    = time_to_surface(rear);
        const int    side       = to_rear < to_front ? -1 : 1;
        MassMotion  &at         = side > 0 ? front : rear;
        MassMotion  &other      = side > 0 ? rear : front;
        const double a          = at.acceleration;
        const double to_surface = std::min(to_front, to_rear);
        if (!(t + to_surface < path.size))
          break;
        if (result.impacts.size() == max_impacts)
          {
            if (std::isfinite(rear.penetration))
              throw ComputationError(
                text("a rigid mass meets its two stops ",
                     max_impacts,
                     " times in a step\n  remedy:  a smaller Time/Step size"));
            if (!(a > 0.))
              break;
            result.loss += 0.5 * at.velocity * at.velocity;
            result.change_time = t; // as good as at rest
            return rest_until_end(side);
          }
        t += to_surface;
        const double arriving = std::max(0., at.velocity + a * to_surface);
        fly(other, to_surface);
        at.penetration = 0.;
        at.velocity    = -e * arriving;
        other.velocity += (1. + e) * arriving;
        result.loss += 0.5 * (arriving * arriving - at.velocity * at.velocity);
        // all that follow, the last one in no time; the first is the longest
        const bool returns =
          a > 0. && -2. * at.velocity / a <= time_to_surface(other);
        const double bounces = a > 0. && e < 1. ?
                                 -2. * at.velocity / (a * (1. - e)) :
                               arriving == 0. ? 0. :
                                                infinity;
        if (returns &&
            t + bounces < path.size * (1. + Tolerances::rounding_of_data))
          {
            result.loss += 0.5 * at.velocity * at.velocity;
            result.change_time = t + bounces;
            if (arriving > 0.)
              result.impacts.push_back({t, arriving, side});
            return rest_until_end(side);
          }
        result.impacts.push_back({t, arriving, side});
      }
    const double left = path.size - t, a = path.front.acceleration;
    result.penetration =
      std::min(0.,
               front.penetration + left * (front.velocity + 0.5 * a * left));
    result.velocity = front.velocity + a * left;
    result.change   = result.velocity - path.front.velocity - a * path.size;
    return result;
  }
} // namespace ThermoContact
