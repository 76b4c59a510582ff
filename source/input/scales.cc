// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>
#include <thermocontact/input/unit_text.h>

#include <deal.II/base/patterns.h>

namespace ThermoContact
{
  void
  ScalesParameters::add_parameters(ParameterHandler &prm)
  {
    const NumberOrText none = NumberOrText::word("none");
    SectionOfEntries   entry(prm, "Scales");
    entry("Length", length, none).means("Length of the rod, m.");
    entry("Time", time, none)
      .means("Time in which heat diffuses through the rod, s.");
    entry("Displacement", displacement, none)
      .means("What displacement, gap and penetration are measured in, m; none: "
             "in Length.");
    entry("Stress", stress, none)
      .means("What stress and pressure are measured in, Pa.");
    entry("Area", area, none)
      .means("Area of the cross-section, m^2: a force is a stress times it.");
    entry("Temperature", temperature, none)
      .means("What temperatures above the reference are measured in, K.");
    entry("Reference temperature", reference_temperature, none)
      .means("Absolute temperature of the rod without stress, K, at which the "
             "nondimensional one is 0.");
    entry("Time unit",
          time_unit,
          dealii::Patterns::Selection(names_of_time_units))
      .means("Unit of times in files and on the screen.");
    entry("Temperature unit",
          temperature_unit,
          dealii::Patterns::Selection("K|C"))
      .means("Unit of temperatures there: kelvin, or C for degrees Celsius.");
  }



  bool
  ScalesParameters::is_given() const
  {
    return length || time || displacement || stress || area || temperature ||
           reference_temperature;
  }
} // namespace ThermoContact
