// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_unit_tables_h
#define thermocontact_input_unit_tables_h

#include <thermocontact/input/units.h>

#include <string>

namespace ThermoContact
{
  /** What one unit of the scene is, in comments of a parameter file. */
  std::string
  write_scales(const UnitScales &scales);

  /** The factors of the columns of contact.csv, likewise. */
  std::string
  write_factors(const RodInUnits &rod, const UnitScales &scales);
} // namespace ThermoContact

#endif
