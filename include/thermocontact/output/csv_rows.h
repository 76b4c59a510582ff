// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_csv_rows_h
#define thermocontact_output_csv_rows_h

#include <thermocontact/base/csv_columns.h>
#include <thermocontact/contact/event_locator.h>
#include <thermocontact/simulation/measurements.h>
#include <thermocontact/time/step_controller.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The columns of contact.csv, those among them that not every scene has:
   * of the face of a body in 2-D or 3-D, of stages that are solved iteratively,
   * of a damped obstacle, of a lateral heat exchange.
   */
  CsvColumns<StepRecord>
  contact_columns(const Scene &scene);

  /** A row of events.csv: an event and how long the contact that ends was. */
  struct EventRow : ContactEvent
  {
    double duration; ///< NaN of a begin
  };

  /** The columns of events.csv; with two stops, or in a row, one more. */
  CsvColumns<EventRow>
  event_columns(const Scene &scene);

  /** The columns of the table of a contact of a row. */
  CsvColumns<ContactRecord>
  columns_of_row_contact();

  /** The columns of boundaries.csv, of the fields that the scene has. */
  CsvColumns<StepRecord>
  boundary_columns(const Scene &scene);

  /** The columns of steps.csv. */
  CsvColumns<StepAttempt>
  attempt_columns();

  /** A row of probes.csv: values as PointValues gives them. */
  struct ProbeRow
  {
    double                     time;
    const std::vector<double> &values;
  };

  /** The columns of probes.csv. */
  CsvColumns<ProbeRow>
  probe_columns(const unsigned int n_places);

  /** The places of Output/Probes as comment lines. */
  std::string
  probe_comments(const Parameters &parameters);
} // namespace ThermoContact

#endif
