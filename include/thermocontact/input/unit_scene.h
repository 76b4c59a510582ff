// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_unit_scene_h
#define thermocontact_input_unit_scene_h

#include <thermocontact/input/units.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The parameter file of the scene of a rod.
   *
   * @param own entries of a scene that stand in it as they are; the last one
   *   of a path
   * @throw InputError if the rod decides one of them
   */
  std::string
  write_scene(const RodInUnits &rod, const std::vector<Assignment> &own);
} // namespace ThermoContact

#endif
