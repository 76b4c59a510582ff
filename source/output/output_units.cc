// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/output_page.h>
#include <thermocontact/output/output_units.h>

namespace ThermoContact
{
  const Conversion &
  OutputUnits::of(const std::string &file, const std::string &name) const
  {
    return of(is_si() ? kind_of(file, name) : "");
  }
} // namespace ThermoContact
