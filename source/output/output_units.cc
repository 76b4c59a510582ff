// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/scales.h>
#include <thermocontact/output/output_tables.h>
#include <thermocontact/output/output_units.h>

#include <deal.II/base/exceptions.h>

namespace ThermoContact
{
  OutputUnits::OutputUnits(const Parameters &parameters)
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
    conversions["heat flux"] = {stress * displacement / length * length *
                                  reference / (scale * seconds),
                                0.,
                                "W/m^2"};
  }



  const Conversion &
  OutputUnits::of(const std::string_view kind) const
  {
    if (!is_si())
      return as_it_is;
    const auto found = conversions.find(kind);
    // without a scale of temperature there are none, but their columns
    return found == conversions.end() ? as_it_is : found->second;
  }



  const Conversion &
  OutputUnits::of(const std::string &file, const std::string &name) const
  {
    return is_si() ? of(kind_of(file, name)) : as_it_is;
  }



  std::string
  OutputUnits::text(const std::string_view kind,
                    const double           value,
                    const unsigned int     digits) const
  {
    const Conversion &conversion = of(kind);
    const std::string number     = significant(conversion(value), digits);
    return conversion.unit.empty() ? number : number + ' ' + conversion.unit;
  }



  std::string
  OutputUnits::description() const
  {
    if (!is_si())
      return "";
    std::string line = "SI: lengths in m, times in " + of("time").unit;
    if (!of("temperature").unit.empty())
      line += ", temperatures in " + of("temperature").unit;
    return line + ", forces in N; coefficients and entries have none";
  }
} // namespace ThermoContact
