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



  /** The number in @p text; nothing if it is an expression or a word. */
  std::optional<NumberWithUnit>
  split_unit(const std::string &text);

  /**
   * True for one that UDUNITS-2 knows.
   *
   * @param text as a user writes it, in UTF-8
   * @throw ComputationError if the list of units of UDUNITS-2 is not there
   */
  bool
  is_unit(const std::string &text);

  /**
   * @p number in another unit, by UDUNITS-2: 0.08 for 80 mm in m, 353.15 for
   * 80 degC in K.
   *
   * @return nothing if @p unit is none, or no measure of what @p other is
   * @throw ComputationError as is_unit()
   */
  std::optional<double>
  convert_unit(const double       number,
               const std::string &unit,
               const std::string &other);
} // namespace ThermoContact

#endif
