// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_output_units_h
#define thermocontact_output_output_units_h

#include <thermocontact/base/csv_columns.h>
#include <thermocontact/input/quantity_units.h>

#include <string>

namespace ThermoContact
{
  /**
   * The kind of quantity, as QuantityUnits has them, of a column, key or array.
   * A '*' in a name of the page stands for what the scene chooses.
   */
  const std::string &
  kind_of(const std::string &file, const std::string &name);



  /** The units of the quantities of a scene, and those of columns and keys. */
  class OutputUnits : public QuantityUnits
  {
  public:
    using QuantityUnits::QuantityUnits;

    using QuantityUnits::of;

    /** Of a column, key or array in @p file of the output_page. */
    const Conversion &
    of(const std::string &file, const std::string &name) const
    {
      return of(is_si() ? kind_of(file, name) : "");
    }

    /** The units of the columns of a table; none if there are none. */
    template <typename Record>
    Conversions
    of_columns(const std::string &file, const CsvColumns<Record> &columns) const
    {
      Conversions result;
      if (is_si())
        for (const auto &column : columns)
          result.push_back(of(file, column.name));
      return result;
    }
  };
} // namespace ThermoContact

#endif
