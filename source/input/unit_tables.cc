// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/unit_tables.h>

namespace ThermoContact
{
  namespace
  {
    std::string
    number_of_factor(const double value)
    {
      return significant(value, 12);
    }



    /** A line of a table: name, number, unit, all in a comment. */
    std::string
    row(const std::string &name, const double value, const std::string &unit)
    {
      return text("#   ",
                  align_left(name, 38),
                  ' ',
                  align_left(number_of_factor(value), 20),
                  ' ',
                  unit,
                  '\n');
    }
  } // namespace



  std::string
  write_scales(const UnitScales &scales)
  {
    return "# One unit of the scene is\n" +
           row("length, displacement", scales.length, "m") +
           row("time", scales.time, "s") +
           row("temperature above the reference", scales.temperature, "K") +
           row("velocity", scales.velocity, "m/s") +
           row("stress, pressure", scales.stress, "Pa") +
           row("force", scales.force, "N") +
           row("heat flux", scales.heat_flux, "W/m^2") +
           row("energy", scales.energy, "J") + "#\n";
  }



  std::string
  write_factors(const RodInUnits &rod, const UnitScales &scales)
  {
    return "# Columns of contact.csv in SI units: multiply those of "
           "Output/SI = false by\n" +
           row("time, step_size", scales.time, "s") +
           row("displacement_*, gap, penetration", scales.length, "m") +
           row("velocity_end", scales.velocity, "m/s") +
           row("stress_end", scales.stress, "Pa") +
           row("contact_force", scales.force, "N") +
           row("contact_impulse", scales.force * scales.time, "N s") +
           row("temperature_*, then add " +
                 number_of_factor(rod.in_kelvin(rod.reference_temperature)),
               scales.temperature,
               "K") +
           row("heat_flux_end", scales.heat_flux, "W/m^2") +
           row("energy, work, *dissipation", scales.energy, "J") + "\n";
  }
} // namespace ThermoContact
