// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_scales_h
#define thermocontact_input_scales_h

#include <string>
#include <vector>

namespace ThermoContact
{
  /** A unit in which people give times. */
  struct TimeUnit
  {
    std::string name;
    double      seconds; ///< in one
  };



  /** The units of time, by growing length. */
  const std::vector<TimeUnit> &
  time_units();

  /** That of this name, one of time_units(). */
  const TimeUnit &
  time_unit(const std::string &name);

  /** The unit in which @p seconds is a number that people read at a glance. */
  const TimeUnit &
  readable_time_unit(const double seconds);



  /** A unit in which people give temperatures. */
  struct TemperatureUnit
  {
    std::string name; ///< as an entry has it
    std::string symbol;
    double      zero_in_kelvin;
  };



  /** Kelvin and degrees Celsius. */
  const std::vector<TemperatureUnit> &
  temperature_units();

  /** That of this name, one of temperature_units(). */
  const TemperatureUnit &
  temperature_unit(const std::string &name);
} // namespace ThermoContact

#endif
