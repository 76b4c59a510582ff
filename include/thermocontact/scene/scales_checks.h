// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_scales_checks_h
#define thermocontact_scene_scales_checks_h

#include <thermocontact/input/parameters.h>

namespace ThermoContact
{
  /**
   * Throws unless section Scales has no scale, or all that the results of the
   * scene need, none of them zero.
   */
  void
  check_scales(const Parameters &parameters);
} // namespace ThermoContact

#endif
