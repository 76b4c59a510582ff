// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_drive_checks_h
#define thermocontact_scene_drive_checks_h

#include <thermocontact/scene/scene.h>

namespace ThermoContact
{
  /**
   * Refuses drives of the fixed end that steps cannot follow from the start, or
   * not with the scheme or the start of the scene.
   *
   * @throw InputError naming entry, value, what is allowed, and a remedy
   */
  void
  check_drives(const Scene &scene);
} // namespace ThermoContact

#endif
