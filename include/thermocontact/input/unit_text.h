// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_unit_text_h
#define thermocontact_input_unit_text_h

#include <optional>
#include <string>

namespace ThermoContact
{
  /** Units in which people give times, as UDUNITS-2 knows them. */
  constexpr const char *names_of_time_units = "us|ms|s|min|h";



  /** A number with the unit behind it: "30 um". */
  struct NumberWithUnit
  {
    double      number;
    std::string unit; ///< empty: there is none
  };



  /** What @p text is, or nothing if it is an expression or a word. */
  std::optional<NumberWithUnit>
  split_unit(const std::string &text);

  /**
   * @p number in another unit, by UDUNITS-2: 0.08 for 80 mm in m, 353.15 for
   * 80 degC in K.
   *
   * @param unit as a user writes it, in UTF-8
   * @return nothing if one is no measure of what the other one is
   * @throw std::invalid_argument if @p unit is none, in words; ComputationError
   *   if the list of units of UDUNITS-2 is not there
   */
  std::optional<double>
  convert_unit(const double       number,
               const std::string &unit,
               const std::string &other);
} // namespace ThermoContact

#endif
