// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/report/key_results.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    double
    contact_begins(const Scene &, const RunHistory &history)
    {
      return std::count_if(history.events.begin(),
                           history.events.end(),
                           [](const ContactEvent &event) {
                             return event.kind == ContactEvent::begin;
                           });
    }



    /**
     * Begins and ends of each contact alternate; contact at t = 0 is a begin.
     * Of a row the sum of all contacts.
     */
    double
    contact_duration(const Scene &, const RunHistory &history)
    {
      const StepRecord   &record = history.record;
      const unsigned int  n = std::max<std::size_t>(1, record.contacts.size());
      std::vector<double> begin(n, 0.);
      double              sum = 0.;
      for (const ContactEvent &event : history.events)
        if (event.kind == ContactEvent::begin)
          begin[event.contact] = event.time;
        else
          sum += event.time - begin[event.contact];
      for (unsigned int i = 0; i < n; ++i)
        if (record.contacts.empty() ? record.in_contact :
                                      record.contacts[i].in_contact)
          sum += record.time - begin[i];
      return sum;
    }



    /**
     * The velocity of the last release over the one of the first impact, with
     * the sign that makes it positive for a body that comes back; NaN without
     * one of the two. Of a row it is that of the contact that is first.
     */
    double
    restitution(const Scene &, const RunHistory &history)
    {
      double impact = nan, release = nan;
      for (const ContactEvent &event : history.events)
        if (event.contact != history.events.front().contact)
          continue;
        else if (event.kind == ContactEvent::end)
          release = event.velocity_into();
        else if (std::isnan(impact))
          impact = event.velocity_into();
      // a body that stays has 0, not -0
      return impact > 0. ? 0. - release / impact : nan;
    }



    /**
     * The number, from 1, of the steady state that is reached: the nearest one,
     * if the temperature of the contact end is as near to its as that of a
     * state that is reached, in parts of the difference of the outer
     * temperatures, and the displacement in parts of the gap or of the largest
     * one of these states.
     */
    double
    reached_state(const Scene &scene, const RunHistory &history)
    {
      const std::vector<SteadyState> states = steady_state(scene).states;
      const SteadyState              end    = final_state(history.record);
      if (states.empty())
        return nan;
      const unsigned int nearest = nearest_state(states, end);
      const auto         is_near =
        [](const double value, const double rest, const double scale) {
          // a result that the scene does not have is NaN
          return std::isnan(rest) ||
                 std::abs(value - rest) <= Tolerances::reached_state * scale;
        };
      double largest = scene.contact.law->is_active() ? scene.contact.gap : 0.;
      for (const SteadyState &any : states)
        largest = std::max(largest, std::abs(any.displacement_end));
      return is_near(end.temperature_end,
                     states[nearest].temperature_end,
                     scene.heat.temperature_range()) &&
                 is_near(end.displacement_end,
                         states[nearest].displacement_end,
                         largest) ?
               nearest + 1. :
               nan;
    }



    template <double StepRecord::*member>
    double
    at_end(const Scene &, const RunHistory &history)
    {
      return history.record.*member;
    }



    template <double RunHistory::*member>
    double
    over_steps(const Scene &, const RunHistory &history)
    {
      return history.*member;
    }



    double
    first_contact_time(const Scene &, const RunHistory &history)
    {
      return history.events.empty() ? nan : history.events.front().time;
    }



    /** All key results: the only list of them. */
    const struct
    {
      const char *name;
      bool        has_error_bars;
      double (*value)(const Scene &, const RunHistory &);
    } results[] = {
      {"first_contact_time", true, first_contact_time},
      {"contact_begins", false, contact_begins},
      {"contact_duration", true, contact_duration},
      {"max_contact_force", true, over_steps<&RunHistory::max_contact_force>},
      {"max_penetration", true, over_steps<&RunHistory::max_penetration>},
      {"contact_impulse", true, at_end<&StepRecord::contact_impulse>},
      {"restitution", true, restitution},
      {"final_displacement_end", true, at_end<&StepRecord::displacement_end>},
      {"final_temperature_end", true, at_end<&StepRecord::temperature_end>},
      {"reached_state_of_rest", false, reached_state},
      {"final_contact_force", false, at_end<&StepRecord::contact_force>}};



    std::vector<std::string>
    names_of_results(const bool with_error_bars_alone)
    {
      std::vector<std::string> names;
      for (const auto &result : results)
        if (result.has_error_bars || !with_error_bars_alone)
          names.emplace_back(result.name);
      return names;
    }



    /** @param scale of the terms whose rounding is in the length */
    double
    without_rounding(const double length, const double scale)
    {
      return std::abs(length) <=
                 Tolerances::rounding_of_solution * std::abs(scale) ?
               0. :
               length;
    }
  } // namespace



  double
  starting_energy(const StepRecord &record)
  {
    return record.energy + record.dissipation + record.contact_dissipation +
           record.numerical_dissipation - record.work - record.algebraic;
  }



  double
  shown_displacement(const StepRecord &record)
  {
    return without_rounding(record.displacement_end, record.contact_force);
  }



  double
  shown_gap(const StepRecord &record)
  {
    return without_rounding(record.gap,
                            std::max(std::abs(record.contact_force),
                                     std::abs(record.displacement_end)));
  }



  SteadyState
  final_state(const StepRecord &record)
  {
    return {shown_displacement(record),
            record.contact_force,
            record.temperature_end,
            record.in_contact};
  }



  const std::vector<std::string> &
  key_result_names()
  {
    static const std::vector<std::string> names = names_of_results(false);
    return names;
  }



  const std::vector<std::string> &
  results_with_error_bars()
  {
    static const std::vector<std::string> names = names_of_results(true);
    return names;
  }



  KeyResults
  key_results(const Scene &scene, const RunHistory &history)
  {
    KeyResults values;
    for (const auto &result : results)
      values[result.name] = result.value(scene, history);
    return values;
  }



  KeyResults
  smooth_key_results(const Scene &scene, const RunHistory &history)
  {
    KeyResults values = key_results(scene, history);
    if (scene.scheme.has_no_dispersion)
      return values; // rows are means over steps, among them fronts
    values["max_contact_force"] = history.peak_force();
    values["max_penetration"]   = history.peak_penetration();
    return values;
  }
} // namespace ThermoContact
