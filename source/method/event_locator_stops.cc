// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/event_locator.h>

#include <vector>

namespace ThermoContact
{
  ContactValues
  seen_from(const ContactValues &values, const int side)
  {
    ContactValues seen(values);
    if (side > 0)
      return seen;
    seen.penetration.swap(seen.rear_penetration);
    for (std::vector<double> *column :
         {&seen.displacement, &seen.velocity, &seen.pressure})
      for (double &value : *column)
        value = -value;
    return seen;
  }



  void
  EventLocator::turn_to(const int new_side)
  {
    present = seen_from(present, side * new_side);
    side    = new_side;
  }



  void
  EventLocator::let_go(const ContactValues &stopped)
  {
    present = seen_from(stopped, side);
    waiting.push_back(
      {waiting.back().time, ContactEvent::end, stopped.velocity.front(), side});
    mode_ = ContactMode::open;
  }



  EventLocator::Finding
  EventLocator::examine(const ContactValues &next,
                        const bool           is_aimed,
                        const BodyScales    &scales) const
  {
    Finding finding =
      examine_stop(present, seen_from(next, side), is_aimed, scales);
    finding.side = side;
    if (mode_ != ContactMode::open || next.rear_penetration.empty())
      return finding;
    Finding other    = examine_stop(seen_from(present, -1),
                                 seen_from(next, -side),
                                 is_aimed,
                                 scales);
    other.side       = -side;
    const auto is_of = [](const Finding &f) {
      return f.kind != Finding::nothing;
    };
    return is_of(other) && (!is_of(finding) || other.time < finding.time) ?
             other :
             finding;
  }
} // namespace ThermoContact
