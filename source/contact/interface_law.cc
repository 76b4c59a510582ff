// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/contact/contact_law.h>
#include <thermocontact/contact/interface_law.h>
#include <thermocontact/method/bracketed_root.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Of the law at -x; zero stays positive. */
    NodalPressure
    reversed(const NodalPressure &p)
    {
      return {0. - p.pressure, {p.tangent.compliance, 0. - p.tangent.offset}};
    }



    /** Of the law at x - @p shift. */
    NodalPressure
    shifted(const NodalPressure &p, const double shift)
    {
      return {p.pressure, {p.tangent.compliance, p.tangent.offset + shift}};
    }



    AffineLaw
    tangent(const double stiffness, const double x, const double pressure)
    {
      return stiffness > 0. ?
               AffineLaw{1. / stiffness, x - pressure / stiffness} :
               AffineLaw();
    }
  } // namespace



  NodalPressure
  TwoSided::resolve(const double z, const double r) const
  {
    const NodalPressure by_front = front.resolve(z - front_shift, r);
    return by_front.pressure != 0. ?
             shifted(by_front, front_shift) :
             reversed(shifted(rear.resolve(-z - rear_shift, r), rear_shift));
  }



  double
  Damped::velocity_at_touch() const
  {
    return tau > 0. ? -start / tau : start >= 0. ? -infinity : infinity;
  }



  double
  Damped::factor_at_touch() const
  {
    return law.velocity_factor(velocity_at_touch());
  }



  double
  Damped::pressure(const double v) const
  {
    const double s = penetration(v);
    return s > 0.  ? law.pressure(s) * law.velocity_factor(v) :
           is_held ? -law.pressure(-s) * factor_at_touch() :
                     0.;
  }



  double
  Damped::stiffness(const double v) const
  {
    const double s = penetration(v);
    if (s > 0.)
      {
        const double elastic = law.pressure(s);
        const double factor  = law.velocity_factor(v);
        return factor > 0. ?
                 tau * factor / law.tangent(elastic) + law.damping() * elastic :
                 0.;
      }
    return is_held ? tau * factor_at_touch() / law.tangent(law.pressure(-s)) :
                     0.;
  }



  double
  Damped::local_pressure(const double z, const double r) const
  {
    if (law.damping() == 0.)
      {
        const double s = penetration(z);
        return s >= 0. ? law.resolve(s, tau * r).pressure :
               is_held ? -law.resolve(-s, tau * r).pressure :
                         0.;
      }
    const double touch = velocity_at_touch();
    const double low   = std::max(touch, -1. / law.damping());
    if (!(z > low))
      {
        const double factor = factor_at_touch();
        if (!is_held || !(z < touch) || factor == 0.)
          return 0.;
        return -factor *
               law.resolve(tau * (touch - z), tau * r * factor).pressure;
      }
    const auto excess = [&](const double v) { return v + r * pressure(v) - z; };
    // 1 - c (1/c) may be rounding, which a hard obstacle takes for contact
    if (excess(low) >= 0.)
      return (z - low) / r;
    const auto [v, above] = bracketed_root(excess, low, z);
    // of the two the one that loses less by the rounding of v, also next to
    // the velocity at which the pressure begins
    return r * (pressure(above) - pressure(v)) > above - v ? (z - v) / r :
                                                             pressure(v);
  }



  NodalPressure
  Damped::resolve(const double z, const double r) const
  {
    // the line of the dashpot only tilts the plane
    const double d       = law.dashpot();
    const double free    = z / (1. + r * d);
    const double elastic = local_pressure(free, r / (1. + r * d));
    const double v       = free - r / (1. + r * d) * elastic;
    const double p       = elastic + d * v;
    if (d > 0. && !is_held)
      {
        const double touch = velocity_at_touch();
        if (z <= touch || (v >= touch && p <= 0.))
          return {};
        if (v < touch) // its force at the first touch would throw the node back
          return {(z - touch) / r, {0., touch}};
      }
    const double k = stiffness(v) + d;
    // where rounding alone is stiff the graph is vertical
    return {p, k == 0. && p != 0. ? AffineLaw{0., v} : tangent(k, v, p)};
  }



  double
  Mean::pressure(const double s) const
  {
    return law.mean_pressure(start, s) -
           law.mean_pressure(rear_start, rear_start - (s - start));
  }



  NodalPressure
  Mean::resolve(const double z, const double r) const
  {
    // grows with s, since the potential is convex
    const auto excess = [&](const double s) { return s + r * pressure(s) - z; };
    const double p    = pressure(z);
    const double other = z - r * p;
    if (other == z)
      return {p, {}};
    const auto [below, above] =
      bracketed_root(excess, std::min(other, z), std::max(other, z));
    const double p_below = pressure(below);
    const double steep   = r * (pressure(above) - p_below);
    const double change  = below - start;
    const double at_end =
      law.pressure(below) - law.pressure(rear_start - change);
    const double stiffness =
      change != 0. ? std::max(0., (at_end - p_below) / change) : 0.;
    const double found = steep > above - below ? (z - below) / r : p_below;
    return {found, tangent(stiffness, below, found)};
  }



  NodalPressure
  NodeLaw::resolve(const double z, const double r) const
  {
    if (law == nullptr)
      return {};
    if (is_in_velocity)
      {
        // the other obstacle sees a velocity that is smaller by
        const double of_front = front_rate - local_rate();
        const double of_rear  = local_rate();
        const double at_front = penetration_of(1, start) + tau * of_front;
        const double at_rear  = penetration_of(-1, start) + tau * of_rear;
        const Damped front(law_of(1), at_front, tau, is_held);
        const Damped rear(law_of(-1), at_rear, tau, is_held);
        return is_held ? (side > 0 ? front.resolve(z, r) :
                                     reversed(rear.resolve(-z, r))) :
                         TwoSided(front, rear, of_front, of_rear).resolve(z, r);
      }
    if (mean_from)
      {
        const double front = penetration_of(1, *mean_from);
        const double rear  = penetration_of(-1, *mean_from);
        return side > 0 ? Mean(*law, front, rear).resolve(z, r) :
                          reversed(Mean(*law, rear, front).resolve(-z, r));
      }
    if (is_held || std::isinf(play))
      {
        const bool        is_in_front = is_held ? z >= 0. : side > 0;
        const ContactLaw &local       = law_of(side);
        return is_in_front ? local.resolve(z, r) :
                             reversed(local.resolve(-z, r));
      }
    return TwoSided(law_of(1),
                    law_of(-1),
                    side > 0 ? 0. : play,
                    side > 0 ? play : 0.)
      .resolve(z, r);
  }



  double
  NodeLaw::face(const int new_side, const double position)
  {
    if (new_side == side)
      return position;
    side = new_side;
    return position - side * play;
  }



  bool
  NodeLaw::is_open(const double x) const
  {
    if (law == nullptr || !law->is_active())
      return true;
    const double s = position(x);
    return !is_held && penetration_of(1, s) <= 0. &&
           penetration_of(-1, s) <= 0.;
  }



  bool
  NodeLaw::is_in_contact(const double position, const double pressure) const
  {
    return pressure != 0. ||
           (law_of(penetration_slope(position)).can_be_silent() &&
            penetration(position) > 0.);
  }



  double
  NodeLaw::pressure_at(const double position, const double velocity) const
  {
    if (is_held)
      return side *
             law_of(side).held_pressure(side * position,
                                        side * (velocity - local_rate()));
    double pressure = 0.;
    for (const int sign : {1, -1})
      pressure +=
        sign * law_of(sign).damped_pressure(penetration_of(sign, position),
                                            sign * (velocity - rate_of(sign)));
    return pressure;
  }



  double
  NodeLaw::elastic_pressure(const double position) const
  {
    return law_of(1).pressure(penetration_of(1, position)) -
           law_of(-1).pressure(penetration_of(-1, position));
  }



  double
  NodeLaw::continued_pressure(const double position) const
  {
    return std::isinf(play) ?
             std::copysign(law->pressure(std::abs(position)), position) :
             elastic_pressure(position);
  }



  namespace
  {
    /** Factors (1 + c v) by which a pressure is divided without loss. */
    constexpr double smallest_factor = 0.5;



    /** elastic_pressure() of one obstacle, with what is positive into it. */
    double
    elastic_part(const ContactLaw &law,
                 const double      pressure,
                 const double      s,
                 const double      v,
                 const double      rounding)
    {
      const double of_law = law.pressure(s);
      const double factor = law.velocity_factor(v);
      if (factor < smallest_factor)
        return of_law;
      if (pressure == 0.)
        return v > 0. ? 0. : of_law;
      const double value = (pressure - law.dashpot() * v) / factor;
      return std::abs(law.penetration(value) - s) <= rounding ? value : of_law;
    }
  } // namespace



  double
  NodeLaw::elastic_pressure(const double position,
                            const double velocity,
                            const double pressure,
                            const double rounding) const
  {
    double elastic = 0.;
    for (const int sign : {1, -1})
      elastic += sign * elastic_part(law_of(sign),
                                     std::max(sign * pressure, 0.),
                                     penetration_of(sign, position),
                                     sign * (velocity - rate_of(sign)),
                                     rounding);
    return elastic;
  }



  double
  NodeLaw::numerical_dissipation(const double position,
                                 const double displacement,
                                 const double way,
                                 const double old_pressure,
                                 const double pressure) const
  {
    const int sign = sign_of(pressure);
    return law_of(sign).numerical_dissipation(sign * (displacement -
                                                      (sign > 0 ? way : 0.)),
                                              penetration_of(sign, position),
                                              sign * old_pressure,
                                              sign * pressure);
  }



  double
  NodeLaw::distance_to_branch(const double z,
                              const double rate,
                              const double lead) const
  {
    double     distance = infinity;
    const auto look     = [&](const double value, const double value_rate) {
      // towards the obstacle from outside, or back to it from within
      if (value * value_rate < 0.)
        distance = std::min(distance, std::max(-value / value_rate, lead));
    };
    look(penetration_of(1, z), rate);
    if (std::isfinite(play))
      look(penetration_of(-1, z), -rate);
    return distance;
  }



  double
  NodeLaw::position_of_pressure(const double pressure) const
  {
    const double s = law_under(pressure).penetration(pressure); // odd
    return is_held || pressure == 0. ? s : obstacle(pressure > 0. ? 1 : -1) + s;
  }



  AffineLaw
  NodeLaw::tangent_of_pressure(const double pressure) const
  {
    const ContactLaw &own        = law_under(pressure);
    const double      compliance = own.tangent(pressure);
    if (std::isinf(compliance))
      return {};
    // zero to the last digit if the law is linear
    const double curved = own.penetration(pressure) - compliance * pressure;
    return {compliance,
            is_held || pressure == 0. ?
              curved :
              obstacle(pressure > 0. ? 1 : -1) + curved};
  }
} // namespace ThermoContact
