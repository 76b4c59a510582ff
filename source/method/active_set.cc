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
} // namespace ThermoContact
