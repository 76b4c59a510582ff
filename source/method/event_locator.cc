// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/event_locator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    const double infinity = std::numeric_limits<double>::infinity();

    bool
    any_in_contact(const ContactValues &values)
    {
      return std::any_of(values.pressure.begin(),
                         values.pressure.end(),
                         [](const double p) { return p > 0.; });
    }



    /** The node that contact changes first or last. */
    unsigned int
    foremost(const ContactValues &values)
    {
      return std::max_element(values.displacement.begin(),
                              values.displacement.end()) -
             values.displacement.begin();
    }
  } // namespace



  EventLocator::EventLocator(const ContactLaw  &law,
                             const bool         is_active,
                             const ContactNodes nodes,
                             const double       tolerance)
    : law(law)
    , is_active(is_active)
    , nodes(nodes)
    , tolerance(tolerance)
    , mode_(ContactMode::unilateral)
    , is_in_contact(false)
    , was_switched(false)
    , max_displacement(0.)
    , max_pressure(0.)
  {}



  ContactMode
  EventLocator::mode_of(const ContactValues &values) const
  {
    if (!is_active)
      return ContactMode::unilateral;
    const auto is_closed = [](const double p) { return p > 0.; };
    if (std::all_of(values.pressure.begin(), values.pressure.end(), is_closed))
      return ContactMode::closed;
    return any_in_contact(values) ? ContactMode::unilateral : ContactMode::open;
  }



  void
  EventLocator::start(const ContactValues       &initial,
                      std::vector<ContactEvent> &events)
  {
    present       = initial;
    mode_         = mode_of(initial);
    is_in_contact = false;
    was_switched  = false;
    events.clear();
    max_displacement = max_pressure = 0.;
    add_to_scales(initial);
    if (any_in_contact(initial))
      add_event(initial.time,
                true,
                nodes == ContactNodes::of_static_body ?
                  std::numeric_limits<double>::quiet_NaN() :
                  initial.velocity[foremost(initial)],
                events);
  }



  CubicHermite
  EventLocator::margin(const ContactValues &next, const unsigned int node) const
  {
    if (mode_ == ContactMode::closed && law.compliance == 0.)
      {
        const double p0 = present.pressure[node], p1 = next.pressure[node];
        return CubicHermite(p0, p1 - p0, p1, p1 - p0);
      }
    const double sign = mode_ == ContactMode::closed ? -1. : 1.;
    const double size = next.time - present.time;
    double       s0   = sign * (law.gap - present.displacement[node]);
    double       s1   = sign * (law.gap - next.displacement[node]);
    if (mode_ == ContactMode::closed && nodes != ContactNodes::with_mass)
      {
        // the same with the digits that a stiff obstacle needs
        s0 = law.compliance * present.pressure[node];
        s1 = law.compliance * next.pressure[node];
      }
    if (nodes == ContactNodes::of_static_body)
      return CubicHermite(s0, s1 - s0, s1, s1 - s0);
    return CubicHermite(s0,
                        -sign * size * present.velocity[node],
                        s1,
                        -sign * size * next.velocity[node]);
  }



  bool
  EventLocator::is_near(const double      s,
                        const double      rate,
                        const BodyScales &scales) const
  {
    if (mode_ == ContactMode::closed && law.compliance == 0.)
      return std::abs(s) <= 0.1 * tolerance * max_pressure;
    // what the floating-point numbers of displacement and time can tell apart
    const bool   has_mass = nodes == ContactNodes::with_mass;
    const double largest  = mode_ == ContactMode::closed && !has_mass ?
                              law.compliance * max_pressure :
                              max_displacement;
    const double rounding = 4e-15 * (largest + std::abs(present.time * rate));
    // A miss of an elastic obstacle by s costs the energy s^2 / (2 epsilon); a
    // node without mass that lets the pressure s / epsilon go at once costs
    // s^2 / (2 epsilon^2) at most.
    const double compliance =
      has_mass ? law.compliance : law.compliance * std::min(law.compliance, 1.);
    const double smallest_scale =
      law.compliance > 0. ?
        std::min(max_displacement, std::sqrt(2. * compliance * scales.energy)) :
        max_displacement;
    const bool has_small_impulse =
      has_mass && s * s <= 0.2 * law.compliance * std::abs(rate) * tolerance *
                             scales.momentum;
    return has_small_impulse ||
           std::abs(s) <= 0.01 * tolerance * smallest_scale + rounding;
  }



  void
  EventLocator::add_to_scales(const ContactValues &values)
  {
    for (unsigned int i = 0; i < values.displacement.size(); ++i)
      {
        max_displacement =
          std::max(max_displacement, std::abs(values.displacement[i]));
        max_pressure = std::max(max_pressure, values.pressure[i]);
      }
  }



  EventLocator::Finding
  EventLocator::examine(const ContactValues &next,
                        const bool           is_aimed,
                        const BodyScales    &scales)
  {
    add_to_scales(next);
    const double size         = next.time - present.time;
    double       zero         = infinity;
    unsigned int node         = 0;    // that changes first or is nearest to it
    bool         ends_near    = true; // where it ends beyond a zero
    bool         is_near_zero = false;
    bool         all_change   = true; // at the end or before it
    bool         starts_near  = false;
    bool         all_start    = true;
    const double resolution   = 4e-15 * present.time / size;
    for (unsigned int i = 0; i < next.displacement.size(); ++i)
      {
        const CubicHermite s  = margin(next, i);
        const double       s1 = s.value(1.);
        const double       dip =
          mode_ == ContactMode::closed && law.compliance == 0. ?
                  0. :
                  0.01 * tolerance * max_displacement;
        double node_zero = s.first_zero(dip);
        if (node_zero <= resolution || (s.value(0.) == 0. && node_zero < 1e-9))
          node_zero = 0.;
        const bool starts_here =
          node_zero == 0. || (node_zero < 0.1 && s.slope(0.) < 0. &&
                              is_near(s.value(0.), s.slope(0.) / size, scales));
        starts_near |= starts_here;
        all_start &= starts_here;
        if (node_zero < zero ||
            (zero == infinity && s1 < margin(next, node).value(1.)))
          node = i;
        zero                    = std::min(zero, node_zero);
        const bool is_node_near = is_near(s1, s.slope(1.) / size, scales);
        ends_near &= s1 >= 0. || is_node_near;
        is_near_zero |= is_node_near;
        all_change &= s1 < 0. || is_node_near;
      }

    if (starts_near)
      return {Finding::at_start, present.time + zero * size, all_start, node};
    if (zero < infinity)
      {
        const bool is_last = is_aimed ? ends_near : ends_near && zero > 0.9;
        if (is_last && is_near_zero)
          return {Finding::at_end, next.time, all_change, node};
        return {Finding::within, present.time + zero * size};
      }
    if (is_aimed && is_near_zero)
      return {Finding::at_end, next.time, all_change, node};
    return {Finding::nothing, 0.};
  }



  void
  EventLocator::add_event(const double               time,
                          const bool                 begins,
                          const double               velocity,
                          std::vector<ContactEvent> &events)
  {
    const double earliest = events.empty() ? 0. : events.back().time;
    events.push_back({std::max(time, earliest),
                      begins ? ContactEvent::begin : ContactEvent::end,
                      velocity});
    is_in_contact = begins;
  }



  void
  EventLocator::hold_nothing()
  {
    mode_ = ContactMode::unilateral;
  }



  void
  EventLocator::switch_at_start(const double               time,
                                std::vector<ContactEvent> &events)
  {
    if (was_switched)
      {
        events.pop_back();
        is_in_contact = !is_in_contact;
        hold_nothing();
        return;
      }
    const bool begins = mode_ == ContactMode::open;
    add_event(time, begins, present.velocity[foremost(present)], events);
    mode_        = begins ? ContactMode::closed : ContactMode::open;
    was_switched = true;
  }



  void
  EventLocator::accept(const ContactValues       &next,
                       const Finding             &finding,
                       std::vector<ContactEvent> &events)
  {
    if (mode_ == ContactMode::unilateral)
      {
        const bool touches = any_in_contact(next);
        if (is_in_contact != touches)
          {
            // A closed rigid obstacle holds the gap at zero, up to rounding,
            // so that the root is an end of the step. Contact changes the
            // velocity within it: that of the free side counts.
            const unsigned int old_node = foremost(present);
            const double       gap0 = law.gap - present.displacement[old_node];
            const unsigned int node = foremost(next);
            const double       gap1 = law.gap - next.displacement[node];
            const double fraction   = gap0 == gap1 ? 1. : gap0 / (gap0 - gap1);
            add_event(present.time + std::min(std::max(fraction, 0.), 1.) *
                                       (next.time - present.time),
                      touches,
                      touches ? present.velocity[old_node] :
                                next.velocity[node],
                      events);
          }
        mode_ = mode_of(next);
      }
    else if (finding.kind == Finding::at_end)
      {
        const bool   begins = mode_ == ContactMode::open;
        const double zero   = margin(next, finding.node).zero_near_end();
        // contact begins with the first node and ends with the last
        if (begins || finding.is_of_all_nodes)
          add_event(present.time + zero * (next.time - present.time),
                    begins,
                    next.velocity[finding.node],
                    events);
        mode_ = !finding.is_of_all_nodes ? ContactMode::unilateral :
                begins                   ? ContactMode::closed :
                                           ContactMode::open;
      }
    was_switched = false;
    present      = next;
  }



  CubicHermite::CubicHermite(const double s0,
                             const double slope0,
                             const double s1,
                             const double slope1)
    : s0(s0)
    , slope0(slope0)
    , s1(s1)
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
    return slope0 + x * (2. * quadratic + x * 3. * cubic);
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
        double       low    = points[i];
        const double end    = i + 1 < n ? points[i + 1] : 1.;
        double       high   = end;
        const double s_high = value(high);
        if (!is_positive)
          {
            is_positive = s_high > 0.;
            continue; // rising: no zero that counts
          }
        if (s_high >= 0. || (high < 1. && s_high >= -tolerable_dip))
          continue;
        for (unsigned int j = 0; j < 60; ++j)
          {
            const double middle               = 0.5 * (low + high);
            (value(middle) < 0. ? high : low) = middle;
          }
        return high;
      }
    return is_positive ? infinity : 0.;
  }
} // namespace ThermoContact
