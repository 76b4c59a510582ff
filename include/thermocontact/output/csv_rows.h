// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_csv_rows_h
#define thermocontact_output_csv_rows_h

#include <thermocontact/base/csv_columns.h>
#include <thermocontact/base/table_file.h>
#include <thermocontact/method/event_locator.h>
#include <thermocontact/simulation/measurements.h>
#include <thermocontact/time/step_controller.h>

namespace ThermoContact
{
  /**
   * The columns of the table that has a row for each Record: contact.csv
   * (StepRecord), events.csv (ContactEvent), steps.csv (StepAttempt).
   */
  template <typename Record>
  const CsvColumns<Record> &
  columns_of();

  template <>
  const CsvColumns<StepRecord> &
  columns_of<StepRecord>();

  template <>
  const CsvColumns<ContactEvent> &
  columns_of<ContactEvent>();

  template <>
  const CsvColumns<StepAttempt> &
  columns_of<StepAttempt>();

  /** Adds a row to the table of @p record; nothing if it is not open. */
  template <typename Record>
  void
  add_row(const Record &record, TableFile &file)
  {
    file.append_row([&record](std::string &rows) {
      append_csv_row(columns_of<Record>(), record, rows);
    });
  }
} // namespace ThermoContact

#endif
