// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_spatial_entries_h
#define thermocontact_scene_spatial_entries_h

#include <string>

namespace ThermoContact
{
  /**
   * False if scenes that differ in the entry "Section/Entry" alone have the
   * same mesh, spaces and matrices, bit for bit; true of all others, and of
   * those of which it is not known.
   */
  bool
  changes_matrices(const std::string &path);
} // namespace ThermoContact

#endif
