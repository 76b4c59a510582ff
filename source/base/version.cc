// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/version.h>

namespace ThermoContact
{
  const char *
  version()
  {
    return THERMOCONTACT_VERSION;
  }
} // namespace ThermoContact
