// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/number_or_word.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/scales.h>
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
    const auto add = [&prm](const std::string     &name,
                            const std::string     &text,
                            std::optional<double> &member) {
      add_number_or_word(
        prm, name, "none", text, [&member](const double *value) {
          member = value ? std::optional<double>(*value) : std::nullopt;
        });
    };
    prm.enter_subsection("Scales");
    add("Length", "Length of the rod, m.", length);
    add("Time", "Time in which heat diffuses through the rod, s.", time);
    add("Displacement",
        "What displacement, gap and penetration are measured in, m; none: in "
        "Length.",
        displacement);
    add("Stress", "What stress and pressure are measured in, Pa.", stress);
    add("Area",
        "Area of the cross-section, m^2: a force is a stress times it.",
        area);
    add("Temperature",
        "What temperatures above the reference are measured in, K.",
        temperature);
    add("Reference temperature",
        "Absolute temperature of the rod without stress, K, at which the "
        "nondimensional one is 0.",
        reference_temperature);
    prm.add_parameter("Time unit",
                      time_unit,
                      "Unit of times in files and on the screen.",
                      dealii::Patterns::Selection(names_of(time_units())));
    prm.add_parameter(
      "Temperature unit",
      temperature_unit,
      "Unit of temperatures there: kelvin, or C for degrees Celsius.",
      dealii::Patterns::Selection(names_of(temperature_units())));
    prm.leave_subsection();
  }



  bool
  ScalesParameters::is_given() const
  {
    return length || time || displacement || stress || area || temperature ||
           reference_temperature;
  }
} // namespace ThermoContact
