// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/csv_rows.h>

#include <cstdio>

namespace ThermoContact
{
  void
  add_row(const StepRecord &r, TableFile &file)
  {
    char      row[640];
    const int length = std::snprintf(
      row,
      sizeof(row),
      "%u,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,"
      "%.17g,%.17g,%.17g,%.17g,%d,%u,%.17g,%.17g\n",
      r.step,
      r.time,
      r.step_size,
      r.displacement_end,
      r.displacement_mid,
      r.velocity_end,
      r.stress_end,
      r.gap,
      r.penetration,
      r.contact_force,
      r.contact_impulse,
      r.temperature_end,
      r.heat_flux_end,
      r.energy,
      r.dissipation,
      r.numerical_dissipation,
      r.in_contact ? 1 : 0,
      r.iterations,
      r.work,
      r.temperature_mean);
    file.write_row(row, length);
  }



  void
  add_row(const ContactEvent &event, TableFile &file)
  {
    char      row[80];
    const int length =
      std::snprintf(row,
                    sizeof(row),
                    "%.17g,%s,%.17g\n",
                    event.time,
                    event.kind == ContactEvent::begin ? "begin" : "end",
                    event.velocity);
    file.write_row(row, length);
  }



  void
  add_row(const StepAttempt &a, TableFile &file)
  {
    char      row[160];
    const int length = std::snprintf(row,
                                     sizeof(row),
                                     "%.17g,%.17g,%.6g,%d,%s,%.6g\n",
                                     a.time,
                                     a.size,
                                     a.error,
                                     a.is_accepted ? 1 : 0,
                                     a.reason,
                                     a.wall_seconds);
    file.write_row(row, length);
  }
} // namespace ThermoContact
