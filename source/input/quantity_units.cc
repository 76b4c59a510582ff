// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/quantity_units.h>
#include <thermocontact/input/scales.h>

namespace ThermoContact
{
  QuantityUnits::QuantityUnits(const Parameters &parameters)
  {
    const ScalesParameters &scales = parameters.scales;
    if (!(scales.is_given() && parameters.output.is_si))
      return;
    const double length = *scales.length, seconds = *scales.time,
                 stress           = *scales.stress,
                 displacement     = scales.displacement.value_or(length),
                 force            = stress * *scales.area;
    const TimeUnit        &unit   = time_unit(scales.time_unit);
    const TemperatureUnit &degree = temperature_unit(scales.temperature_unit);
    conversions                   = {{"", {1., 0., ""}},
                                     {"s", {1., 0., "s"}},
                                     {"MB", {1., 0., "MB"}},
                                     {"time", {seconds / unit.seconds, 0., unit.name}},
                                     {"position", {length, 0., "m"}},
                                     {"length", {displacement, 0., "m"}},
                                     {"velocity", {displacement / seconds, 0., "m/s"}},
                                     {"stress", {stress, 0., "Pa"}},
                                     {"force", {force, 0., "N"}},
                                     {"force × time", {force * seconds, 0., "N s"}},
                                     {"force × length", {force * length, 0., "N m"}},
                                     {"energy", {force * displacement, 0., "J"}}};
    if (!scales.temperature)
      return; // nor has the scene any
    // kelvin in both: the absolute temperature is in the scale of heat
    const double scale                    = *scales.temperature,
                 reference                = *scales.reference_temperature;
    conversions["temperature"]            = {scale,
                                             reference - degree.zero_in_kelvin,
                                             degree.symbol};
    conversions["temperature difference"] = {scale, 0., "K"};
    conversions["heat flux"]              = {
                   stress * displacement * reference / (scale * seconds), 0., "W/m^2"};
  }



  const Conversion &
  QuantityUnits::of(const std::string_view kind) const
  {
    if (!is_si())
      return as_it_is;
    const auto found = conversions.find(kind);
    // without a scale of temperature there are none, but their columns
    return found == conversions.end() ? as_it_is : found->second;
  }



  std::string
  QuantityUnits::text(const std::string_view kind,
                      const double           value,
                      const unsigned int     digits) const
  {
    const Conversion &conversion = of(kind);
    const std::string number     = significant(conversion(value), digits);
    return conversion.unit.empty() ? number : number + ' ' + conversion.unit;
  }



  std::string
  QuantityUnits::text_for_entry(const std::string_view kind,
                                const double           value) const
  {
    const std::string number = significant(value, few_digits);
    return is_si() ? text(kind, value) + " (nondimensional: " + number + ")" :
                     number;
  }



  std::string
  QuantityUnits::description() const
  {
    if (!is_si())
      return "";
    std::string line = "SI: lengths in m, times in " + of("time").unit;
    if (!of("temperature").unit.empty())
      line += ", temperatures in " + of("temperature").unit;
    return line + ", forces in N; coefficients and entries have none";
  }
} // namespace ThermoContact
