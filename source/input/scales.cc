// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/parameters.h>
#include <thermocontact/input/scales.h>
#include <thermocontact/input/section_of_entries.h>
#include <thermocontact/input/words_of_kinds.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** The one of this name. */
    template <typename Kind>
    const Kind &
    named(const std::vector<Kind> &kinds, const std::string &name)
    {
      const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const Kind &kind) {
          return kind.name == name;
        });
      AssertThrow(found != kinds.end(), dealii::ExcInternalError());
      return *found;
    }
  } // namespace



  const std::vector<TimeUnit> &
  time_units()
  {
    static const std::vector<TimeUnit> units = {
      {"us", 1e-6}, {"ms", 1e-3}, {"s", 1.}, {"min", 60.}, {"h", 3600.}};
    return units;
  }



  const TimeUnit &
  time_unit(const std::string &name)
  {
    return named(time_units(), name);
  }



  const TimeUnit &
  readable_time_unit(const double seconds)
  {
    return time_unit(seconds >= 10. ? "s" : seconds >= 1e-5 ? "ms" : "us");
  }



  const std::vector<TemperatureUnit> &
  temperature_units()
  {
    static const std::vector<TemperatureUnit> units = {{"K", "K", 0.},
                                                       {"C", "°C", 273.15}};
    return units;
  }



  const TemperatureUnit &
  temperature_unit(const std::string &name)
  {
    return named(temperature_units(), name);
  }



  void
  ScalesParameters::add_parameters(ParameterHandler &prm)
  {
    const NumberOrText none = NumberOrText::word("none");
    SectionOfEntries   entry(prm, "Scales");
    entry("Length", length, none).means("Length of the rod, m.");
    entry("Time", time, none)
      .means("Time in which heat diffuses through the "
             "rod, s.");
    entry("Displacement", displacement, none)
      .means("What displacement, gap "
             "and penetration are "
             "measured in, m; none: in "
             "Length.");
    entry("Stress", stress, none)
      .means("What stress and pressure are measured "
             "in, Pa.");
    entry("Area", area, none)
      .means("Area of the cross-section, m^2: a force "
             "is a stress times it.");
    entry("Temperature", temperature, none)
      .means("What temperatures above the "
             "reference are measured in, "
             "K.");
    entry("Reference temperature", reference_temperature, none)
      .means("Absolute temperature of the rod without stress, K, at which the "
             "nondimensional one is 0.");
    entry("Time unit",
          time_unit,
          dealii::Patterns::Selection(names_of(time_units())))
      .means("Unit of times in files and on the screen.");
    entry("Temperature unit",
          temperature_unit,
          dealii::Patterns::Selection(names_of(temperature_units())))
      .means("Unit of temperatures there: kelvin, or C for degrees Celsius.");
  }



  bool
  ScalesParameters::is_given() const
  {
    return length || time || displacement || stress || area || temperature ||
           reference_temperature;
  }
} // namespace ThermoContact
