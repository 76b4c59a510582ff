// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_shown_velocity_h
#define thermocontact_space_shown_velocity_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/state.h>

namespace ThermoContact
{
  /**
   * The velocity of a state as a field to look at. With
   * Scene::has_midpoint_mass velocities are those of cells, and nodal values
   * may alternate about them, doc/contact-in-time.md (C6.13): then those of a
   * node are the mean of its cells, at the right end of a rod its own, and at a
   * left end that nothing holds that of its cell.
   *
   * @param memory for the result, if it is not that of the state
   */
  const Vector &
  shown_velocity(const Scene &scene, const State &state, Vector &memory);
} // namespace ThermoContact

#endif
