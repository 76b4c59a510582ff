// SPDX-License-Identifier: LGPL-2.1-or-later

#include "contact_events.h"

#include <algorithm>

namespace ThermoContact
{
  void
  EventDetector::start(const StepRecord &record)
  {
    events_.clear();
    if (record.in_contact)
      events_.push_back(
        {record.time, ContactEvent::begin, record.velocity_end});
  }



  void
  EventDetector::observe(const StepRecord &old_record, const StepRecord &record)
  {
    if (old_record.in_contact == record.in_contact)
      return;

    // The gap crosses zero within the step; a closed rigid obstacle holds it
    // at zero, up to rounding, so that the root is an end of the step.
    const double decrease = old_record.gap - record.gap;
    const double fraction =
      decrease == 0. ? 1. :
                       std::min(1., std::max(0., old_record.gap / decrease));
    const double step = record.time - old_record.time;
    events_.push_back(
      {old_record.time + fraction * step,
       record.in_contact ? ContactEvent::begin : ContactEvent::end,
       record.in_contact ? old_record.velocity_end : record.velocity_end});
  }
} // namespace ThermoContact
