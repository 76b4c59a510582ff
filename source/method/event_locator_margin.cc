// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/event_locator.h>

namespace ThermoContact
{
  CubicHermite
  EventLocator::margin(const ContactValues &from,
                       const ContactValues &next,
                       const unsigned int   node) const
  {
    if (is_margin_pressure())
      {
        const double p0 = from.pressure[node], p1 = next.pressure[node];
        return CubicHermite(p0, p1 - p0, p1, p1 - p0);
      }
    const double sign = mode_ == ContactMode::closed ? 1. : -1.;
    const double size = next.time - from.time;
    double       s0   = sign * from.penetration[node];
    double       s1   = sign * next.penetration[node];
    if (mode_ == ContactMode::closed && nodes != NodeOrder::inertial &&
        law.damping() == 0.)
      {
        // the same with the digits that a stiff obstacle needs; the pressures
        // that a damped one has here are those of the penetrations, and
        // between two stops there is none
        s0 = law.penetration(from.pressure[node]);
        s1 = law.penetration(next.pressure[node]);
      }
    if (!has_velocity)
      return CubicHermite(s0, s1 - s0, s1, s1 - s0);
    return CubicHermite(s0,
                        sign * size * from.velocity[node],
                        s1,
                        sign * size * next.velocity[node]);
  }



  double
  EventLocator::change_of_velocity(const CubicHermite &s,
                                   const double        from,
                                   const double        to,
                                   const double        size) const
  {
    if (nodes != NodeOrder::inertial || is_margin_pressure())
      return 0.;
    const double change = (s.slope(to) - s.slope(from)) / size;
    return mode_ == ContactMode::closed ? change : -change;
  }
} // namespace ThermoContact
