// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/shown_velocity.h>

namespace ThermoContact
{
  const Vector &
  shown_velocity(const Scene &scene, const State &state, Vector &memory)
  {
    if (!scene.has_midpoint_mass)
      return state.velocity;
    memory                = state.velocity;
    const unsigned int n  = memory.locally_owned_size();
    const double      *v  = state.velocity.begin();
    double            *at = memory.begin();
    for (unsigned int i = 1; i + 1 < n; ++i)
      at[i] = 0.5 * v[i] + 0.25 * (v[i - 1] + v[i + 1]);
    at[0] = scene.fixed_end_motion ?
              scene.fixed_end_motion->derivatives(state.load_time).first :
              0.;
    return memory;
  }
} // namespace ThermoContact
