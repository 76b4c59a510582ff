// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_contact_checks_h
#define thermocontact_scene_contact_checks_h

#include <thermocontact/scene/scene.h>

namespace ThermoContact
{
  /**
   * A damped obstacle needs stages that are solved for velocities, and contact
   * nodes that something moves.
   *
   * @throw InputError
   */
  void
  check_damping(const Scene &scene);

  /**
   * Two-sided contact is for the end of a rod that moves with inertia.
   *
   * @throw InputError
   */
  void
  check_rear_gap(const Scene &scene);
} // namespace ThermoContact

#endif
