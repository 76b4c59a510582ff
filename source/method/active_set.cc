// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/active_set.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  bool
  update_active_set(const std::vector<double> &pressure,
                    const std::vector<double> &reach,
                    const std::vector<bool>   &may_change,
                    const double               rounding,
                    const bool                 only_the_first,
                    std::vector<bool>         &is_active)
  {
    double largest_pressure = 0., largest_reach = 0.;
    for (unsigned int i = 0; i < reach.size(); ++i)
      {
        largest_pressure = std::max(largest_pressure, std::abs(pressure[i]));
        largest_reach    = std::max(largest_reach, std::abs(reach[i]));
      }
    const auto penetrates = [&](const unsigned int i) {
      return reach[i] > rounding * largest_reach;
    };
    bool changed = false;
    for (unsigned int i = 0; i < reach.size() && !(changed && only_the_first);
         ++i)
      if (may_change[i] &&
          (is_active[i] ?
             pressure[i] < -rounding * largest_pressure && !penetrates(i) :
             penetrates(i)))
        {
          is_active[i] = !is_active[i];
          changed      = true;
        }
    return changed;
  }



  bool
  update_active_set(const std::vector<double> &pressure,
                    const std::vector<double> &reach,
                    const std::vector<double> &rear_reach,
                    const std::vector<bool>   &may_change,
                    const double               rounding,
                    const bool                 only_the_first,
                    SetsBetweenStops          &sets)
  {
    if (rear_reach.empty())
      return update_active_set(
        pressure, reach, may_change, rounding, only_the_first, sets.is_active);
    // of a node in the set the stop that it is at, of an open one the nearer
    std::vector<double> seen_pressure(pressure), seen_reach(reach);
    std::vector<bool>   is_rear(sets.is_rear);
    for (unsigned int i = 0; i < reach.size(); ++i)
      {
        if (!sets.is_active[i])
          is_rear[i] = nearer_stop(reach[i], rear_reach[i]) < 0;
        if (is_rear[i])
          {
            seen_pressure[i] = -pressure[i];
            seen_reach[i]    = rear_reach[i];
          }
      }
    const bool changed = update_active_set(seen_pressure,
                                           seen_reach,
                                           may_change,
                                           rounding,
                                           only_the_first,
                                           sets.is_active);
    for (unsigned int i = 0; i < reach.size(); ++i)
      sets.is_rear[i] = sets.is_active[i] && is_rear[i];
    return changed;
  }



  void
  remove_pull(const SetsBetweenStops  &sets,
              const std::vector<bool> &may_pull,
              std::vector<double>     &pressure)
  {
    for (unsigned int i = 0; i < pressure.size(); ++i)
      if (!may_pull[i])
        pressure[i] = sets.is_rear[i] ? std::min(pressure[i], 0.) :
                                        std::max(pressure[i], 0.);
  }
} // namespace ThermoContact
