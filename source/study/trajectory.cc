// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/study/trajectory.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  const std::array<const char *, Trajectory::n_quantities> Trajectory::names = {
    {"displacement_end",
     "velocity_end",
     "contact_force",
     "temperature_end",
     "energy"}};



  void
  Trajectory::add(const StepRecord &record)
  {
    times.push_back(record.time);
    values.push_back({{record.displacement_end,
                       record.velocity_end,
                       record.contact_force,
                       record.temperature_end,
                       record.energy}});
  }



  void
  Trajectory::set_events(const std::vector<ContactEvent> &events)
  {
    event_times.clear();
    for (const ContactEvent &event : events)
      event_times.push_back(event.time);
  }



  double
  Trajectory::first_contact_time() const
  {
    return event_times.empty() ? nan : event_times.front();
  }



  unsigned int
  Trajectory::phase(const std::size_t n) const
  {
    return std::upper_bound(event_times.begin(),
                            event_times.end(),
                            0.5 * (times[n - 1] + times[n])) -
           event_times.begin();
  }



  Trajectory::Values
  Trajectory::interpolate(const double time) const
  {
    const std::size_t next =
      std::lower_bound(times.begin(), times.end(), time) - times.begin();
    if (next == times.size())
      {
        Values none;
        none.fill(nan);
        return none;
      }
    if (times[next] == time || next == 0)
      return values[next];

    // Up to six steps around the interval (next - 1, next), none beyond a
    // change of contact: there the polynomial would smooth a kink.
    std::size_t        first = next - 1, last = next;
    const unsigned int present = phase(next);
    while (last - first < 5)
      {
        const bool goes_left = first > 0 && phase(first) == present;
        const bool goes_right =
          last + 1 < times.size() && phase(last + 1) == present;
        const bool is_left_shorter = next - 1 - first <= last - next;
        if (goes_left && (is_left_shorter || !goes_right))
          --first;
        else if (goes_right)
          ++last;
        else
          break;
      }

    Values result{};
    for (std::size_t i = first; i <= last; ++i)
      {
        double weight = 1.;
        for (std::size_t j = first; j <= last; ++j)
          if (j != i)
            weight *= (time - times[j]) / (times[i] - times[j]);
        for (unsigned int q = 0; q < n_quantities; ++q)
          result[q] += weight * values[i][q];
      }
    return result;
  }



  Trajectory::Difference
  Trajectory::compare(const Trajectory &reference) const
  {
    Difference difference(0.);
    for (std::size_t n = 1; n < times.size(); ++n)
      {
        const Values exact = reference.interpolate(times[n]);
        for (unsigned int q = 0; q < n_quantities; ++q)
          {
            const double error        = std::abs(values[n][q] - exact[q]);
            difference.final_value[q] = error;
            if (!(error <= difference.maximum[q]))
              difference.maximum[q] = error;
          }
      }
    difference.first_contact_time =
      event_times.empty() && reference.event_times.empty() ?
        0. :
        std::abs(first_contact_time() - reference.first_contact_time());
    return difference;
  }
} // namespace ThermoContact
