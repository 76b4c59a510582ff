// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_conversion_h
#define thermocontact_base_conversion_h

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * How a number is written: factor times the value, plus an offset, in a unit.
   * By default as it is, to the last bit, without a unit.
   */
  struct Conversion
  {
    double      factor = 1.;
    double      offset = 0.;
    std::string unit;

    double
    operator()(const double value) const
    {
      // nothing is added to a value without a unit: -0 stays -0
      return unit.empty() ? value : factor * value + offset;
    }
  };



  /** Of the columns of a table, in order; none: all as they are. */
  using Conversions = std::vector<Conversion>;
} // namespace ThermoContact

#endif
