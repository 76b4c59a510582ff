// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_history_h
#define thermocontact_history_h

#include <thermocontact/base/exceptions.h>
#include <thermocontact/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests.h"

namespace ThermoContact
{
  struct StepEnd
  {
    double time, displacement, velocity, gap;
  };



  /** What a run leaves. */
  struct History
  {
    std::vector<ContactEvent> events;
    std::vector<StepEnd>      steps;
    StepRecord                last;
    double                    max_displacement = 0.;
    double                    max_velocity     = 0.;
    bool                      is_complete      = false; ///< ran to the end
  };



  inline History
  run(Parameters parameters, const double tolerance)
  {
    parameters.time.tolerance = tolerance;
    History       history;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    const auto    observe = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      history.steps.push_back(
        {r.time, r.displacement_end, r.velocity_end, r.gap});
      raise(history.max_displacement, std::abs(r.displacement_end));
      raise(history.max_velocity, std::abs(r.velocity_end));
    };
    try
      {
        simulation.run({observe});
        history.is_complete = true;
      }
    catch (const ComputationError &)
      {}
    history.events = simulation.events();
    history.last   = simulation.record();
    return history;
  }



  inline bool
  is_begin(const ContactEvent &event)
  {
    return event.kind == ContactEvent::begin;
  }



  inline bool
  alternate(const std::vector<ContactEvent> &events)
  {
    for (unsigned int i = 0; i < events.size(); ++i)
      if (is_begin(events[i]) != (i % 2 == 0) ||
          (i > 0 && !(events[i].time > events[i - 1].time)))
        return false;
    return true;
  }



  /** Largest penetration while the events say open, gap while they do not. */
  inline double
  wrong_side(const History &history)
  {
    double       worst = 0.;
    unsigned int next  = 0;
    for (const StepEnd &step : history.steps)
      {
        while (next < history.events.size() &&
               history.events[next].time <= step.time)
          ++next;
        raise(worst, next % 2 == 0 ? -step.gap : step.gap);
      }
    return worst;
  }



  /**
   * Largest distance from the obstacle between event @p i and the next one: at
   * the ends of steps, and the height of the parabola through both events.
   */
  inline double
  excursion(const History &history, const unsigned int i)
  {
    const double begin  = history.events[i].time;
    const double end    = history.events[i + 1].time;
    double       height = 0.25 * (end - begin) *
                    std::max(std::abs(history.events[i].velocity),
                             std::abs(history.events[i + 1].velocity));
    for (const StepEnd &step : history.steps)
      if (step.time > begin && step.time < end)
        raise(height, std::abs(step.gap));
    return height;
  }



  /** The events without pairs that are less than @p height apart. */
  inline std::vector<ContactEvent>
  without_tiny(const History &history, const double height)
  {
    std::vector<ContactEvent> events;
    for (unsigned int i = 0; i < history.events.size(); ++i)
      if (i + 1 < history.events.size() && excursion(history, i) < height)
        ++i;
      else
        events.push_back(history.events[i]);
    return events;
  }



  inline bool
  same_kinds(const std::vector<ContactEvent> &events,
             const std::vector<ContactEvent> &reference)
  {
    return std::equal(events.begin(),
                      events.end(),
                      reference.begin(),
                      reference.end(),
                      [](const ContactEvent &a, const ContactEvent &b) {
                        return a.kind == b.kind;
                      });
  }



  /** Same kinds, and times as near as an error @p miss of u(1) lets them be. */
  inline bool
  agree(const std::vector<ContactEvent> &events,
        const std::vector<ContactEvent> &reference,
        const double                     miss)
  {
    if (!same_kinds(events, reference))
      return false;
    for (unsigned int i = 0; i < events.size(); ++i)
      {
        const double difference = std::abs(events[i].time - reference[i].time);
        if (!(difference < 1e-4 ||
              difference * std::abs(reference[i].velocity) < 2. * miss))
          return false;
      }
    return true;
  }
} // namespace ThermoContact

#endif
