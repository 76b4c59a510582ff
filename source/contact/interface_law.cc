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
    return tau > 0. ? -start / tau : start > 0. ? -infinity : infinity;
  }



  double
  Damped::factor_at_touch() const
  {
    return std::max(0., 1. + law.damping() * velocity_at_touch());
  }



  double
  Damped::pressure(const double v) const
  {
    const double s = penetration(v);
    return s > 0.  ? law.damped_pressure(s, v) :
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
        const double factor  = 1. + law.damping() * v;
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
    const double p = local_pressure(z, r);
    const double v = z - r * p;
    const double k = stiffness(v);
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
        const double at_front = front_penetration(start) + tau * of_front;
        const double at_rear  = rear_penetration(start) + tau * of_rear;
        const Damped front(*law, at_front, tau, is_held);
        const Damped rear(*law, at_rear, tau, is_held);
        return is_held ? (side > 0 ? front.resolve(z, r) :
                                     reversed(rear.resolve(-z, r))) :
                         TwoSided(front, rear, of_front, of_rear).resolve(z, r);
      }
    if (mean_from)
      {
        const double front = front_penetration(*mean_from);
        const double rear  = rear_penetration(*mean_from);
        return side > 0 ? Mean(*law, front, rear).resolve(z, r) :
                          reversed(Mean(*law, rear, front).resolve(-z, r));
      }
    if (is_held || std::isinf(play))
      {
        const bool is_in_front = is_held ? z >= 0. : side > 0;
        return is_in_front ? law->resolve(z, r) : reversed(law->resolve(-z, r));
      }
    return TwoSided(*law, *law, side > 0 ? 0. : play, side > 0 ? play : 0.)
      .resolve(z, r);
  }



  double
  NodeLaw::change_side(const double position)
  {
    side = -side;
    return position - side * play;
  }



  bool
  NodeLaw::is_open(const double x) const
  {
    if (law == nullptr || !law->is_active())
      return true;
    const double s = position(x);
    return !is_held && front_penetration(s) <= 0. && rear_penetration(s) <= 0.;
  }



  double
  NodeLaw::pressure_at(const double position, const double velocity) const
  {
    return law->damped_pressure(front_penetration(position),
                                velocity - front_rate) -
           law->damped_pressure(rear_penetration(position), -velocity);
  }



  double
  NodeLaw::position_of_pressure(const double pressure) const
  {
    const double s = law->penetration(pressure); // odd
    return is_held || pressure == 0. ? s : obstacle(pressure > 0. ? 1 : -1) + s;
  }



  AffineLaw
  NodeLaw::tangent_of_pressure(const double pressure) const
  {
    const double compliance = law->tangent(pressure);
    if (std::isinf(compliance))
      return {};
    // zero to the last digit if the law is linear
    const double curved = law->penetration(pressure) - compliance * pressure;
    return {compliance,
            is_held || pressure == 0. ?
              curved :
              obstacle(pressure > 0. ? 1 : -1) + curved};
  }
} // namespace ThermoContact
