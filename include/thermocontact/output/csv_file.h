// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_csv_file_h
#define thermocontact_output_csv_file_h

#include <thermocontact/base/csv_columns.h>
#include <thermocontact/base/table_file.h>
#include <thermocontact/output/output_units.h>

namespace ThermoContact
{
  /** A table of an output directory; a row is made of a @p Record. */
  template <typename Record>
  class CsvFile
  {
  public:
    /**
     * @param name of the file
     * @param listed_in the file whose table on the output_page has the columns;
     *   empty: it has one of its own
     */
    CsvFile(const std::string        &name,
            const CsvColumns<Record> &columns,
            const OutputUnits        &units,
            const std::string        &listed_in = "")
      : name(name)
      , columns(columns)
      , conversions(
          units.of_columns(listed_in.empty() ? name : listed_in, columns))
    {}

    /**
     * Begins the file in @p directory, or goes on behind its first @p size
     * bytes if that is not 0; on one rank.
     *
     * @param comments lines at the top, each with its end
     */
    void
    open(const std::string  &directory,
         const std::string  &comments,
         const std::uint64_t size)
    {
      file.open(directory + "/" + name,
                comments + csv_head(columns, conversions),
                size);
    }

    /** Appends the row of @p record; nothing if the file is not open. */
    void
    add(const Record &record)
    {
      file.append_row([&](std::string &rows) {
        append_csv_row(columns, record, rows, conversions);
      });
    }

    const std::string name;
    TableFile         file;

  private:
    const CsvColumns<Record> columns;
    const Conversions        conversions;
  };
} // namespace ThermoContact

#endif
