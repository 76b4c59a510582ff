// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/report/key_results.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  }



  unsigned int
  n_contact_begins(const std::vector<ContactEvent> &events)
  {
    unsigned int n = 0;
    for (const ContactEvent &event : events)
      n += event.kind == ContactEvent::begin;
    return n;
  }



  double
  contact_duration(const std::vector<ContactEvent> &events,
                   const bool                       is_in_contact,
                   const double                     time)
  {
    double sum = 0., begin = 0.;
    for (const ContactEvent &event : events)
      if (event.kind == ContactEvent::begin)
        begin = event.time;
      else
        sum += event.time - begin;
    return is_in_contact ? sum + time - begin : sum;
  }



  double
  restitution(const std::vector<ContactEvent> &events)
  {
    double impact = nan, release = nan;
    for (const ContactEvent &event : events)
      if (event.kind == ContactEvent::end)
        release = event.side * event.velocity;
      else if (std::isnan(impact))
        impact = event.side * event.velocity;
    // a body that stays has 0, not -0
    return impact > 0. ? 0. - release / impact : nan;
  }



  double
  starting_energy(const StepRecord &record)
  {
    return record.energy + record.dissipation + record.contact_dissipation +
           record.numerical_dissipation - record.work - record.algebraic;
  }



  SteadyState
  final_state(const StepRecord &record)
  {
    return {record.displacement_end,
            record.contact_force,
            record.temperature_end,
            record.in_contact};
  }



  unsigned int
  reached_state_of_rest(const std::vector<SteadyState> &states,
                        const SteadyState              &end,
                        const Scene                    &scene)
  {
    if (states.empty())
      return 0;
    const unsigned int nearest = nearest_state(states, end);
    const SteadyState &state   = states[nearest];
    const auto         is_near =
      [](const double value, const double rest, const double scale) {
        // what the scene does not have is NaN
        return std::isnan(rest) || std::abs(value - rest) <= 1e-3 * scale;
      };
    double largest = scene.contact.law->is_active() ? scene.contact.gap : 0.;
    for (const SteadyState &any : states)
      largest = std::max(largest, std::abs(any.displacement_end));
    return is_near(end.temperature_end,
                   state.temperature_end,
                   scene.heat.temperature_range()) &&
               is_near(end.displacement_end, state.displacement_end, largest) ?
             nearest + 1 :
             0;
  }



  const std::array<const char *, KeyResult::n_names> key_result_names = {
    {"first_contact_time",
     "contact_begins",
     "contact_duration",
     "max_contact_force",
     "max_penetration",
     "contact_impulse",
     "restitution",
     "final_displacement_end",
     "final_temperature_end",
     "reached_state_of_rest"}};



  KeyResults
  key_results(const Scene &scene, const RunHistory &history)
  {
    const StepRecord  &record = history.record;
    const auto        &events = history.events;
    const unsigned int state = reached_state_of_rest(steady_state(scene).states,
                                                     final_state(record),
                                                     scene);
    return {{events.empty() ? nan : events.front().time,
             double(n_contact_begins(events)),
             contact_duration(events, record.in_contact, record.time),
             history.max_contact_force,
             history.max_penetration,
             record.contact_impulse,
             restitution(events),
             record.displacement_end,
             record.temperature_end,
             state > 0 ? state : nan}};
  }



  KeyResults
  smooth_key_results(const Scene &scene, const RunHistory &history)
  {
    KeyResults results                    = key_results(scene, history);
    results[KeyResult::max_contact_force] = history.force_peak.estimate();
    results[KeyResult::max_penetration]   = history.penetration_peak.estimate();
    return results;
  }
} // namespace ThermoContact
