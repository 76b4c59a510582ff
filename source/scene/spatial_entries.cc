// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/scene/spatial_entries.h>

#include <algorithm>
#include <array>

namespace ThermoContact
{
  bool
  changes_matrices(const std::string &path)
  {
    // Neither Scene::contact.has_massless_nodes nor Scene::linear_solver asks
    // for one of them.
    static const std::array<const char *, 11> others = {
      {"Title",
       "Boundary/Ambient temperature",
       "Boundary/Fixed end temperature",
       "Contact/Compliance",
       "Time/Break points",
       "Time/End time",
       "Time/First step size",
       "Time/Locate contact events",
       "Time/Maximum step size",
       "Time/Minimum step size",
       "Time/Tolerance"}};
    const auto is_in = [&](const std::string &section) {
      return path.rfind(section + '/', 0) == 0;
    };
    return std::find(others.begin(), others.end(), path) == others.end() &&
           !is_in("Initial values") && !is_in("Sources") && !is_in("Output");
  }
} // namespace ThermoContact
