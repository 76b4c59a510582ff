// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_scene_terms_h
#define thermocontact_scene_scene_terms_h

#include <thermocontact/scene/scene.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** The fields that a scene has. */
  std::vector<std::string>
  scene_fields(const Scene &scene);

  /** The terms that a scene contains, in words. */
  std::vector<std::string>
  scene_terms(const Scene &scene);
} // namespace ThermoContact

#endif
