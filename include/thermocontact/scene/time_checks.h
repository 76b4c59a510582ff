// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_time_checks_h
#define thermocontact_scene_time_checks_h

#include <thermocontact/scene/scene.h>

namespace ThermoContact
{
  /**
   * Whether the scene can start as Time/Start says.
   *
   * @throw InputError
   */
  void
  check_start(const Scene &scene);

  /**
   * Whether the sizes of steps can be what the scene says.
   *
   * @throw InputError
   */
  void
  check_step_sizes(const Scene &scene);
} // namespace ThermoContact

#endif
