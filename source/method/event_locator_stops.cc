// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/event_locator.h>

#include <vector>

namespace ThermoContact
{
  const ContactValues &
  seen_from(const ContactValues &values,
            const int            side,
            ContactValues       &mirrored)
  {
    if (side > 0)
      return values;
    mirrored = values;
    mirrored.penetration.swap(mirrored.rear_penetration);
    for (std::vector<double> *column :
         {&mirrored.displacement, &mirrored.velocity, &mirrored.pressure})
      for (double &value : *column)
        value = -value;
    return mirrored;
  }



  bool
  EventLocator::is_at_its_stop(const ContactValues &values) const
  {
    // seen from the stop: the other one is nearer only behind it
    for (unsigned int i = 0; i < values.rear_penetration.size(); ++i)
      if (values.rear_penetration[i] > values.penetration[i] ||
          (side < 0 && values.rear_penetration[i] == values.penetration[i]))
        return false;
    return true;
  }



  void
  EventLocator::turn_to(const int new_side)
  {
    ContactValues mirrored;
    present = seen_from(present, side * new_side, mirrored);
    side    = new_side;
  }



  void
  EventLocator::release(const ContactValues &stopped)
  {
    present = seen_from(stopped, side, mirrored_next);
    pending.push_back(
      {pending.back().time, ContactEvent::end, stopped.velocity.front(), side});
    mode_ = ContactMode::open;
  }



  EventLocator::Finding
  EventLocator::examine(const ContactValues &next,
                        const bool           is_aimed,
                        const BodyScales    &scales) const
  {
    Finding finding = examine_stop(present,
                                   seen_from(next, side, mirrored_next),
                                   is_aimed,
                                   scales);
    finding.side    = side;
    if (mode_ != ContactMode::open || next.rear_penetration.empty())
      return finding;
    Finding other    = examine_stop(seen_from(present, -1, mirrored_present),
                                 seen_from(next, -side, mirrored_next),
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
