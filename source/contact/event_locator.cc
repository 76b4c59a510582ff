// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/event_locator.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /** 0 if it cannot be told apart from the start. */
    double
    first_zero(const CubicHermite &s, const double dip, const double resolution)
    {
      const double zero = s.first_zero(dip);
      return zero <= resolution ||
                 (s.value(0.) == 0. && zero < Tolerances::zero_at_start) ?
               0. :
               zero;
    }
  } // namespace



  double
  duration_of_contact(const std::vector<ContactEvent> &events,
                      const std::size_t                i)
  {
    if (events[i].kind == ContactEvent::end)
      for (std::size_t begin = i; begin-- > 0;)
        if (events[begin].contact == events[i].contact)
          return events[i].time - events[begin].time;
    return nan;
  }



  void
  ContactValues::get_node(const unsigned int node, ContactValues &of_node) const
  {
    const auto take = [node](const std::vector<double> &from,
                             std::vector<double>       &to) {
      to.assign(1, from[node]);
    };
    of_node.time = time;
    take(displacement, of_node.displacement);
    take(front.penetration, of_node.front.penetration);
    take(front.velocity, of_node.front.velocity);
    take(rear.penetration, of_node.rear.penetration);
    take(rear.velocity, of_node.rear.velocity);
    take(pressure, of_node.pressure);
  }



  bool
  LocalValues::is_any_in_contact() const
  {
    for (unsigned int i = 0; i < size(); ++i)
      if (is_in_contact(i))
        return true;
    return false;
  }



  unsigned int
  LocalValues::foremost() const
  {
    unsigned int node = 0;
    for (unsigned int i = 1; i < size(); ++i)
      if (penetration(i) > penetration(node))
        node = i;
    return node;
  }



  bool
  LocalValues::are_all_local() const
  {
    for (unsigned int i = 0; i < size(); ++i)
      {
        const double own = penetration(i), opposite = opposite_penetration(i);
        if (opposite > own || (side < 0 && opposite == own))
          return false;
      }
    return true;
  }



  void
  ContactProgress::Scales::add(const LocalValues &local)
  {
    for (unsigned int i = 0; i < local.size(); ++i)
      {
        displacement =
          std::max(displacement, std::abs(local.values.displacement[i]));
        pressure = std::max(pressure, local.pressure(i));
      }
  }



  EventLocator::EventLocator(const ContactLaw &law,
                             const bool        is_active,
                             const NodeOrder   nodes,
                             const double      tolerance,
                             const bool        has_small_changes,
                             const bool        has_velocity,
                             const ContactLaw *rear_law)
    : law(law)
    , rear_law(rear_law)
    , is_active(is_active)
    , nodes(nodes)
    , tolerance(tolerance)
    , has_small_changes(has_small_changes)
    , has_velocity(has_velocity)
  {}



  ContactMode
  EventLocator::mode_of(const ContactValues &values) const
  {
    if (!is_active)
      return ContactMode::unilateral;
    const LocalValues local{values, side}, opposite{values, -side};
    unsigned int      n_closed = 0;
    for (unsigned int i = 0; i < local.size(); ++i)
      n_closed += local.is_in_contact(i);
    return n_closed == local.size() ? ContactMode::closed :
           n_closed > 0 || opposite.is_any_in_contact() ?
                                      ContactMode::unilateral :
                                      mode_without_pressure(values);
  }



  ContactMode
  EventLocator::mode_without_pressure(const ContactValues &values) const
  {
    for (const int at : {1, -1})
      if (const LocalValues local{values, at};
          law_of(at).dashpot() > 0. && local.penetration(local.foremost()) > 0.)
        return ContactMode::unilateral;
    return ContactMode::open;
  }



  double
  EventLocator::way_to_contact(const LocalValues &local,
                               const unsigned int node) const
  {
    const double      s   = local.penetration(node);
    const ContactLaw &own = law_of(local.side);
    return own.dashpot() > 0. && s > 0. ?
             0. - own.held_pressure(s, local.velocity(node)) :
             0. - s;
  }



  void
  EventLocator::start(const ContactValues       &initial,
                      std::vector<ContactEvent> &events)
  {
    const LocalValues front{initial, 1}, rear{initial, -1};
    side    = rear.is_any_in_contact() && !front.is_any_in_contact() ? -1 : 1;
    present = initial;
    mode_   = mode_of(initial);
    is_in_contact = false;
    pending.clear();
    events.clear();
    largest = Scales();
    const LocalValues local{initial, side};
    largest.add(local);
    if (local.is_any_in_contact())
      add_event({initial.time,
                 ContactEvent::begin,
                 !has_velocity ? nan : side * local.velocity(local.foremost()),
                 side},
                events);
  }



  bool
  EventLocator::is_near(const ContactLaw &local_law,
                        const double      s,
                        const double      rate,
                        const Scales     &sizes,
                        const BodyScales &scales) const
  {
    if (is_margin_pressure())
      return std::abs(s) <= 0.1 * tolerance * sizes.pressure;
    // floating-point numbers of displacement and time tell no less apart
    const bool   has_mass = nodes == NodeOrder::inertial;
    const double size     = mode_ == ContactMode::closed && !has_mass ?
                              local_law.penetration(sizes.pressure) :
                              sizes.displacement;
    const double rounding =
      Tolerances::rounding_of_event * (size + std::abs(present.time * rate));
    // A miss by s costs the energy that the obstacle stores at s; a node
    // without mass that lets its pressure go at once costs half its square at
    // most.
    double smallest_scale = sizes.displacement;
    if (!local_law.is_rigid())
      {
        smallest_scale =
          std::min(smallest_scale,
                   local_law.penetration_of_energy(scales.energy));
        if (!has_mass)
          smallest_scale =
            std::min(smallest_scale,
                     local_law.penetration(std::sqrt(2. * scales.energy)));
        else if (local_law.dashpot() > 0.)
          smallest_scale =
            std::min(smallest_scale, scales.momentum / local_law.dashpot());
      }
    const bool has_small_impulse =
      has_small_changes && has_mass && !local_law.is_rigid() &&
      local_law.work_to(std::abs(s), std::abs(rate)) <=
        0.1 * std::abs(rate) * tolerance * scales.momentum;
    return has_small_impulse ||
           std::abs(s) <= allowed_miss(smallest_scale) + rounding;
  }



  std::vector<bool>
  EventLocator::closed_nodes(const ContactValues &values) const
  {
    Scales sizes(largest);
    sizes.add({values, side});
    const double allowed = allowed_miss(sizes.displacement) +
                           Tolerances::rounding_of_event * sizes.displacement;
    const auto is_closed_at = [&](const int at, const unsigned int node) {
      const LocalValues local{values, at};
      return local.is_in_contact(node) || local.penetration(node) >= -allowed;
    };
    std::vector<bool> is_closed;
    for (unsigned int i = 0; i < values.pressure.size(); ++i)
      is_closed.push_back(is_closed_at(1, i) || is_closed_at(-1, i));
    return is_closed;
  }



  EventLocator::Finding
  EventLocator::examine_local(const LocalValues &next,
                              const bool         is_aimed,
                              const BodyScales  &scales) const
  {
    Scales sizes(largest);
    sizes.add(next);
    const ContactLaw &local_law = law_of(next.side);
    const double      size      = next.values.time - present.time;
    double            zero      = infinity;
    unsigned int      node      = 0; // that changes first or is nearest to it
    bool              ends_near = true; // where it ends beyond a zero
    bool              is_near_zero = false;
    bool              all_change   = true; // at the end or before it
    bool              starts_near  = false;
    bool              all_start    = true;
    const double      resolution =
      Tolerances::rounding_of_event * present.time / size;
    const double dip =
      is_margin_pressure() ? 0. : allowed_miss(sizes.displacement);
    for (unsigned int i = 0; i < next.size(); ++i)
      {
        const CubicHermite s         = margin(next, i);
        const double       s1        = s.value(1.);
        const double       node_zero = first_zero(s, dip, resolution);
        const bool         starts_here =
          node_zero == 0. ||
          (node_zero < 0.1 && s.slope(0.) < 0. &&
           is_near(local_law, s.value(0.), s.slope(0.) / size, sizes, scales));
        starts_near |= starts_here;
        all_start &= starts_here;
        if (node_zero < zero ||
            (zero == infinity && s1 < margin(next, node).value(1.)))
          node = i;
        zero = std::min(zero, node_zero);
        const bool is_node_near =
          is_near(local_law, s1, s.slope(1.) / size, sizes, scales) &&
          next.opposite_penetration(i) <= 0.; // past the play
        ends_near &= s1 >= 0. || is_node_near;
        is_near_zero |= is_node_near;
        all_change &= s1 < 0. || is_node_near;
      }

    if (starts_near)
      return {Finding::at_start,
              present.time + zero * size,
              all_start,
              node,
              zero < 1. ?
                change_of_velocity(margin(next, node), 0., zero, size) :
                0.};
    if (zero < infinity)
      {
        const bool is_last = is_aimed ? ends_near : ends_near && zero > 0.9;
        if (is_last && is_near_zero)
          return {Finding::at_end, next.values.time, all_change, node};
        return {Finding::within, present.time + zero * size};
      }
    if (is_aimed && is_near_zero)
      return {Finding::at_end, next.values.time, all_change, node};
    return {};
  }



  void
  EventLocator::add_event(const ContactEvent        &event,
                          std::vector<ContactEvent> &events)
  {
    const double earliest = events.empty() ? 0. : events.back().time;
    events.push_back(event);
    events.back().time = std::max(event.time, earliest);
    is_in_contact      = event.kind == ContactEvent::begin;
  }



  void
  EventLocator::finish_by_law()
  {
    mode_ = ContactMode::unilateral;
  }



  bool
  EventLocator::switch_at_start(const double time,
                                const double change_of_velocity,
                                const int    new_side)
  {
    if (!pending.empty())
      {
        pending.clear();
        finish_by_law();
        return false;
      }
    const bool begins = mode_ == ContactMode::open;
    if (begins)
      {
        side = new_side;
        if (!LocalValues{present, side}.are_all_local())
          {
            finish_by_law();
            return false;
          }
      }
    const LocalValues  local{present, side};
    const unsigned int node = local.foremost();
    pending                 = {{time,
                begins ? ContactEvent::begin : ContactEvent::end,
                                side * (local.velocity(node) + change_of_velocity),
                                side}};
    mode_ = begins ? ContactMode::closed : mode_without_pressure(present);
    return true;
  }



  void
  EventLocator::accept_unilateral(const ContactValues                &next,
                                  const std::optional<ContactChange> &known,
                                  std::vector<ContactEvent>          &events)
  {
    const LocalValues opposite{next, -side};
    if (opposite.is_any_in_contact() &&
        !LocalValues{next, side}.is_any_in_contact())
      {
        if (is_in_contact) // from one obstacle to the other
          {
            const LocalValues left{present, side};
            add_event({present.time,
                       ContactEvent::end,
                       side * left.velocity(left.foremost()),
                       side},
                      events);
          }
        side = -side;
      }
    const LocalValues old{present, side}, local{next, side};
    const bool        touches = local.is_any_in_contact();
    if (is_in_contact != touches)
      {
        // A closed rigid obstacle holds the gap at zero, up to rounding, so
        // that the root is an end of the step. Contact changes the velocity
        // within it: the free side counts.
        const unsigned int  old_node = old.foremost();
        const unsigned int  node     = local.foremost();
        const double        gap0     = way_to_contact(old, old_node);
        const double        gap1     = way_to_contact(local, node);
        const double        fraction = gap0 == gap1 ? 1. : gap0 / (gap0 - gap1);
        const ContactChange change =
          known ?
            *known :
            ContactChange{present.time + std::min(std::max(fraction, 0.), 1.) *
                                           (next.time - present.time),
                          side * (touches ? old.velocity(old_node) :
                                            local.velocity(node))};
        add_event({change.time,
                   touches ? ContactEvent::begin : ContactEvent::end,
                   change.velocity,
                   side},
                  events);
      }
    mode_ = mode_of(next);
  }



  void
  EventLocator::accept(const ContactValues                &next,
                       const Finding                      &finding,
                       std::vector<ContactEvent>          &events,
                       const std::optional<ContactChange> &known)
  {
    for (const ContactEvent &event : pending)
      add_event(event, events);
    pending.clear();
    const ContactMode mode_of_step = mode_;
    if (mode_ == ContactMode::open && finding.kind == Finding::at_end)
      side = finding.obstacle;
    if (mode_ == ContactMode::unilateral)
      accept_unilateral(next, known, events);
    else if (finding.kind == Finding::at_end)
      {
        const LocalValues  local{next, side};
        const bool         begins = mode_ == ContactMode::open;
        const CubicHermite s      = margin(local, finding.node);
        const double       zero   = s.zero_near_end();
        const double       change =
          change_of_velocity(s, 1., zero, next.time - present.time);
        // contact begins with the first node and ends with the last
        if (begins || finding.changes_all_nodes)
          add_event({present.time + zero * (next.time - present.time),
                     begins ? ContactEvent::begin : ContactEvent::end,
                     side * (local.velocity(finding.node) + change),
                     side},
                    events);
        mode_ =
          !finding.changes_all_nodes || (begins && !local.are_all_local()) ?
            ContactMode::unilateral :
          begins ? ContactMode::closed :
                   mode_without_pressure(next);
      }
    has_last = !has_velocity && mode_ == mode_of_step &&
               mode_ != ContactMode::unilateral && next.time > present.time;
    if (has_last)
      last = present;
    present = next;
    largest.add({present, side});
  }



  CubicHermite
  EventLocator::course(const double at_last,
                       const double s0,
                       const double s1,
                       const double end) const
  {
    const double change = s1 - s0;
    if (!has_last)
      return CubicHermite(s0, change, s1, change);
    const double ratio = (present.time - last.time) / (end - present.time);
    const double bend  = (change - (s0 - at_last) / ratio) / (1. + ratio);
    return CubicHermite(s0, change - bend, s1, change + bend);
  }



  CubicHermite
  EventLocator::margin(const LocalValues &next, const unsigned int node) const
  {
    const LocalValues from{present, next.side}, before{last, next.side};
    if (is_margin_pressure())
      {
        const double p0 = from.pressure(node);
        const double p1 =
          next.pressure(node) != 0. ?
            next.pressure(node) :
            law_of(next.side).held_pressure(next.penetration(node),
                                            next.velocity(node));
        return course(has_last ? before.pressure(node) : p0,
                      p0,
                      p1,
                      next.values.time);
      }
    const double sign = mode_ == ContactMode::closed ? 1. : -1.;
    const double size = next.values.time - present.time;
    // the same with the digits that a stiff obstacle needs; the pressures that
    // a damped one has here are those of the penetrations, and between two
    // obstacles, or behind an end of contact, there is none
    const bool is_by_pressure = mode_ == ContactMode::closed &&
                                nodes != NodeOrder::inertial &&
                                !law_of(next.side).is_damped();
    const auto way = [&](const LocalValues &at, const bool is_pressed) {
      return is_pressed ? law_of(next.side).penetration(at.pressure(node)) :
                          sign * at.penetration(node);
    };
    const double s0 = way(from, is_by_pressure);
    const double s1 = way(next, is_by_pressure && next.pressure(node) != 0.);
    if (!has_velocity)
      return course(has_last ? way(before, is_by_pressure) : s0,
                    s0,
                    s1,
                    next.values.time);
    return CubicHermite(s0,
                        sign * size * from.velocity(node),
                        s1,
                        sign * size * next.velocity(node));
  }



  double
  EventLocator::change_of_velocity(const CubicHermite &s,
                                   const double        from,
                                   const double        to,
                                   const double        size) const
  {
    if (nodes != NodeOrder::inertial || is_margin_pressure())
      return 0.;
    // in short steps the interpolant has lost these digits, and the force is
    // constant
    const double change = (size < Tolerances::short_step * present.time ?
                             (to - from) * (s.slope(1.) - s.slope(0.)) :
                             s.slope(to) - s.slope(from)) /
                          size;
    return mode_ == ContactMode::closed ? change : -change;
  }



  void
  EventLocator::release(const ContactValues &stopped)
  {
    present = stopped;
    pending.push_back({pending.back().time,
                       ContactEvent::end,
                       side * LocalValues{stopped, side}.velocity(0),
                       side});
    mode_ = ContactMode::open;
  }



  EventLocator::Finding
  EventLocator::examine(const ContactValues &next,
                        const bool           is_aimed,
                        const BodyScales    &scales) const
  {
    Finding finding  = examine_local({next, side}, is_aimed, scales);
    finding.obstacle = side;
    if (mode_ != ContactMode::open || std::isinf(next.rear.penetration.front()))
      return finding;
    Finding other    = examine_local({next, -side}, is_aimed, scales);
    other.obstacle   = -side;
    const auto is_of = [](const Finding &f) {
      return f.kind != Finding::nothing;
    };
    return is_of(other) && (!is_of(finding) || other.time < finding.time) ?
             other :
             finding;
  }
} // namespace ThermoContact
