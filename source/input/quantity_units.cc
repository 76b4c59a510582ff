// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/quantity_units.h>
#include <thermocontact/input/unit_text.h>

#include <cmath>
#include <utility>

namespace ThermoContact
{
  ConversionsByKind
  conversions_by_kind(const ScalesParameters &scales)
  {
    const double length = *scales.length, seconds = *scales.time,
                 stress          = *scales.stress,
                 displacement    = scales.displacement.value_or(length),
                 force           = stress * *scales.area;
    const bool        is_celsius = scales.temperature_unit == "C";
    const double      unit       = *convert_unit(1., scales.time_unit, "s");
    ConversionsByKind all;
    all[""]               = {1., 0., ""};
    all["s"]              = {1., 0., "s"};
    all["MB"]             = {1., 0., "MB"};
    all["time"]           = {seconds / unit, 0., scales.time_unit};
    all["position"]       = {length, 0., "m"};
    all["length"]         = {displacement, 0., "m"};
    all["velocity"]       = {displacement / seconds, 0., "m/s"};
    all["stress"]         = {stress, 0., "Pa"};
    all["body force"]     = {stress / length, 0., "N/m^3"};
    all["compliance"]     = {displacement / stress, 0., "m/Pa"};
    all["damping"]        = {seconds / displacement, 0., "s/m"};
    all["force"]          = {force, 0., "N"};
    all["force × time"]   = {force * seconds, 0., "N s"};
    all["force × length"] = {force * length, 0., "N m"};
    all["energy"]         = {force * displacement, 0., "J"};
    all["spring"]         = {force / displacement, 0., "N/m"};
    all["dashpot"]        = {force * seconds / displacement, 0., "N s/m"};
    all["mass"] = {force * seconds * seconds / displacement, 0., "kg"};
    // of the body in SI units, without a scale
    all["area"]              = {1., 0., "m^2"};
    all["conductivity"]      = {1., 0., "W/(m K)"};
    all["density"]           = {1., 0., "kg/m^3"};
    all["heat capacity"]     = {1., 0., "J/(kg K)"};
    all["stiffness"]         = {1., 0., "N/m"};
    all["thermal expansion"] = {1., 0., "1/K"};
    all["viscosity"]         = {1., 0., "Pa s"};
    if (!scales.temperature)
      return all; // nor has the scene any
    // kelvin in both: the absolute temperature is in the scale of heat
    const double scale     = *scales.temperature,
                 reference = *scales.reference_temperature,
                 flux  = stress * displacement * reference / (scale * seconds);
    all["temperature"] = {scale,
                          reference - (is_celsius ? 273.15 : 0.),
                          is_celsius ? "°C" : "K"};
    all["temperature difference"] = {scale, 0., "K"};
    all["heat flux"]              = {flux, 0., "W/m^2"};
    all["heat"]                   = {flux * *scales.area * seconds, 0., "J"};
    all["heat source"]            = {flux / length, 0., "W/m^3"};
    all["heat exchange"]          = {flux / scale, 0., "W/(m^2 K)"};
    all["heat loss"]              = {flux / (scale * length), 0., "W/(m^3 K)"};
    return all;
  }



  const Conversion &
  conversion_of(const std::string_view kind, const ConversionsByKind &all)
  {
    static const Conversion as_it_is;
    const auto              found = all.find(kind);
    return found == all.end() ? as_it_is : found->second;
  }



  QuantityUnits::QuantityUnits(const Parameters &parameters)
  {
    if (parameters.scales.is_given() && parameters.output.is_si)
      conversions = conversions_by_kind(parameters.scales);
    has_si_entries = parameters.rod.is_given();
  }



  const Conversion &
  QuantityUnits::of(const std::string_view kind) const
  {
    // without a scale of temperature there are none, but their columns
    return conversion_of(kind, conversions);
  }



  std::string
  QuantityUnits::text(const std::string_view kind,
                      const double           value,
                      const unsigned int     digits) const
  {
    const Conversion &conversion = of(kind);
    const double      number     = conversion(value);
    if (conversion.unit.empty())
      return significant(number, digits);
    static const std::pair<double, const char *> prefixes[] = {
      {1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1., ""}, {1e-3, "m"}, {1e-6, "u"}};
    // times and temperatures have a unit that fits
    const bool is_scaled =
      kind != "time" && kind != "s" && kind != "MB" && kind != "temperature" &&
      kind != "temperature difference" && kind != "mass" && number != 0.;
    if (is_scaled)
      for (const auto &[size, prefix] : prefixes)
        if (std::abs(number) >= 0.9999995 * size || size == 1e-6)
          return significant(number / size, digits) + ' ' + prefix +
                 conversion.unit;
    return significant(number, digits) + ' ' + conversion.unit;
  }



  std::string
  QuantityUnits::text_for_entry(const std::string_view kind,
                                const double           value) const
  {
    const std::string number = significant(value, few_digits);
    if (!is_si())
      return number;
    return text(kind, value) +
           (has_si_entries ? "" : " (nondimensional: " + number + ")");
  }



  std::string
  QuantityUnits::description() const
  {
    if (!is_si())
      return "";
    std::string line = "SI: lengths in m, times in " + of("time").unit;
    if (!of("temperature").unit.empty())
      line += ", temperatures in " + of("temperature").unit;
    return line + ", forces in N" +
           (has_si_entries ? "" : "; coefficients and entries have none");
  }
} // namespace ThermoContact
