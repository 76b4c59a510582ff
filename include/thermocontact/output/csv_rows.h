// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_csv_rows_h
#define thermocontact_output_csv_rows_h

#include <thermocontact/base/table_file.h>
#include <thermocontact/method/event_locator.h>
#include <thermocontact/simulation/measurements.h>
#include <thermocontact/time/step_controller.h>

namespace ThermoContact
{
  // The columns of contact.csv, steps.csv and events.csv.
  constexpr char contact_columns[] =
    "step,time,step_size,displacement_end,displacement_mid,velocity_end,"
    "stress_end,gap,penetration,contact_force,contact_impulse,"
    "temperature_end,heat_flux_end,energy,dissipation,numerical_dissipation,"
    "in_contact,iterations,work,temperature_mean";

  constexpr char step_columns[] =
    "time,step_size,error,accepted,reason,wall_seconds";

  constexpr char event_columns[] = "time,kind,velocity";

  /**
   * Adds a row with these columns to a table, numbers with 17 significant
   * digits (errors and wall times with 6). Nothing if the table is not open.
   */
  void
  add_row(const StepRecord &record, TableFile &file);

  /** Likewise. */
  void
  add_row(const ContactEvent &event, TableFile &file);

  /** Likewise. */
  void
  add_row(const StepAttempt &attempt, TableFile &file);
} // namespace ThermoContact

#endif
