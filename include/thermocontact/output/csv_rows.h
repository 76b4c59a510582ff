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
   * The columns of contact.csv; a body in 2-D or 3-D has some more, and one
   * more if its stages are solved iteratively, or its obstacle is damped.
   */
  const CsvColumns<StepRecord> &
  contact_columns(const unsigned int dim,
                  const bool         is_iterative = false,
                  const bool         is_damped    = false);

  /** The columns of events.csv; with two stops one more. */
  const CsvColumns<ContactEvent> &
  event_columns(const bool has_sides = false);

  /** The columns of steps.csv. */
  const CsvColumns<StepAttempt> &
  attempt_columns();

  /** Adds a row to the table of @p record; nothing if it is not open. */
  template <typename Record>
  void
  add_row(const CsvColumns<Record> &columns,
          const Record             &record,
          TableFile                &file)
  {
    file.append_row(
      [&](std::string &rows) { append_csv_row(columns, record, rows); });
  }
} // namespace ThermoContact

#endif
