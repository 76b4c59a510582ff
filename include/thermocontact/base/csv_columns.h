// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_csv_columns_h
#define thermocontact_base_csv_columns_h

#include <thermocontact/base/conversion.h>
#include <thermocontact/base/number_text.h>

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** Appends words as a field of a row: in quotes where they must be. */
  void
  append_field(std::string &row, const std::string_view words);

  /** A row of words. */
  std::string
  csv_row(const std::vector<std::string> &words);

  /** The comment lines at the top of every table: title, versions. */
  std::string
  csv_comments(const std::string &title);

  /** The fields of a row without its line break, as append_field() wrote them.
   */
  std::vector<std::string>
  split_row(const std::string_view row);

  /**
   * A column of a CSV table whose rows are made of a @p Record each: its name,
   * and how its fields come from a record.
   */
  template <typename Record>
  class CsvColumn
  {
  public:
    /**
     * @param value a member of Record, or what can be called with a record: a
     *   number, a truth (written as 1 or 0) or words
     * @param digits significant ones, of numbers that are not whole
     */
    template <typename Value>
    CsvColumn(std::string        name,
              const Value        value,
              const unsigned int digits = all_digits)
      : name(std::move(name))
      , append([=](const Record     &record,
                   const Conversion *conversion,
                   std::string      &row) {
        const auto &field = std::invoke(value, record);
        using Field       = std::decay_t<decltype(field)>;
        if constexpr (std::is_floating_point<Field>::value)
          append_number(row, conversion ? (*conversion)(field) : field, digits);
        else if constexpr (std::is_same<Field, bool>::value)
          row += field ? '1' : '0';
        else if constexpr (std::is_integral<Field>::value)
          append_number(row, field);
        else
          append_field(row, field);
      })
    {}

    const std::string name;

    /** Appends a field; numbers are converted, unless there is no conversion.
     */
    const std::function<void(const Record &, const Conversion *, std::string &)>
      append;
  };



  template <typename Record>
  using CsvColumns = std::vector<CsvColumn<Record>>;

  template <typename Record>
  std::vector<std::string>
  names_of(const CsvColumns<Record> &columns)
  {
    std::vector<std::string> names;
    for (const auto &column : columns)
      names.push_back(column.name);
    return names;
  }

  /** The line of names, below a comment of their units if there are any. */
  template <typename Record>
  std::string
  csv_head(const CsvColumns<Record> &columns,
           const Conversions        &conversions = Conversions())
  {
    std::vector<std::string> units;
    for (const Conversion &conversion : conversions)
      units.push_back(conversion.unit);
    return (units.empty() ? "" : "# units: " + csv_row(units)) +
           csv_row(names_of(columns));
  }

  /** Appends the row of @p record; nothing is allocated but by @p text. */
  template <typename Record>
  void
  append_csv_row(const CsvColumns<Record> &columns,
                 const Record             &record,
                 std::string              &text,
                 const Conversions        &conversions = Conversions())
  {
    for (std::size_t i = 0; i < columns.size(); ++i)
      {
        columns[i].append(record,
                          conversions.empty() ? nullptr : &conversions[i],
                          text);
        text += ',';
      }
    text.back() = '\n';
  }
} // namespace ThermoContact

#endif
