// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_mass_checks_h
#define thermocontact_scene_mass_checks_h

#include <thermocontact/scene/scene.h>

#include <string>

namespace ThermoContact
{
  /**
   * Refuses mass matrices that a scene cannot have: lumped ones on an axis, and
   * the midpoint rule anywhere but in an elastic rod of equal linear cells,
   * doc/contact-in-time.md (C6.8).
   *
   * @throw InputError with entry, value, what is allowed, remedy
   */
  void
  check_mass_matrix(const Scene &scene);

  /**
   * Why the midpoint rule for the mass does not keep its promise: a step that
   * is not that of a wave through a cell; else empty.
   */
  std::string
  dispersion_warning(const Scene &scene);
} // namespace ThermoContact

#endif
