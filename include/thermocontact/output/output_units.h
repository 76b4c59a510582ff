// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_output_units_h
#define thermocontact_output_output_units_h

#include <thermocontact/base/conversion.h>
#include <thermocontact/base/csv_columns.h>
#include <thermocontact/input/parameters.h>

#include <map>
#include <string>
#include <string_view>

namespace ThermoContact
{
  /**
   * In which units the files and the screen of a scene have their numbers: SI
   * units if there are Scales and Output/SI is true, else none. The only place
   * that converts. What is kept for other runs of the program, checkpoints and
   * space-time.columns, is nondimensional.
   *
   * Kinds of quantities are words: "time", "length" (of displacements),
   * "position", "velocity", "stress", "force", "force × time", "force ×
   * length", "temperature", "temperature difference", "heat flux", "energy";
   * "s" and "MB" of the computer; "" a number.
   */
  class OutputUnits
  {
  public:
    explicit OutputUnits(const Parameters &parameters);

    bool
    is_si() const
    {
      return !conversions.empty();
    }

    /** Of a kind of quantity. */
    const Conversion &
    of(const std::string_view kind) const;

    /** Of a column, key or array in @p file of output_tables(). */
    const Conversion &
    of(const std::string &file, const std::string &name) const;

    /** Those of the columns of a table; none if there are no units. */
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

    /** A number of this kind in a sentence, with its unit. */
    std::string
    text(const std::string_view kind,
         const double           value,
         const unsigned int     digits = few_digits) const;

    /** The units in words; nothing if there are none. */
    std::string
    description() const;

  private:
    std::map<std::string, Conversion, std::less<>> conversions; ///< by kind
    const Conversion                               as_it_is;
  };
} // namespace ThermoContact

#endif
