// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_events_h
#define thermocontact_contact_events_h

#include <vector>

#include "measurements.h"

namespace ThermoContact
{
  /** Begin or end of contact. */
  struct ContactEvent
  {
    enum Kind
    {
      begin,
      end
    };

    double time     = 0.;
    Kind   kind     = begin;
    double velocity = 0.; ///< $u_t(1)$ of the free end next to that time
  };



  /**
   * Finds the contact events of a sequence of records. Between two steps the
   * gap is interpolated linearly; the velocity is that of the step end without
   * contact, since contact changes it within the step. With several contact
   * nodes the events are those of the first node to touch and the last to
   * leave. A body that is in contact at the start begins contact there.
   */
  class EventDetector
  {
  public:
    /** The initial state. */
    void
    start(const StepRecord &record);

    /** The step from @p old_record to @p record. */
    void
    observe(const StepRecord &old_record, const StepRecord &record);

    const std::vector<ContactEvent> &
    events() const
    {
      return events_;
    }

  private:
    std::vector<ContactEvent> events_;
  };
} // namespace ThermoContact

#endif
