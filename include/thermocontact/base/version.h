// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_version_h
#define thermocontact_base_version_h

namespace ThermoContact
{
  /** Version of this program, as CMakeLists.txt states it. */
  const char *
  version();
} // namespace ThermoContact

#endif
