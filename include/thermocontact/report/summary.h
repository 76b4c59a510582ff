// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_summary_h
#define thermocontact_report_summary_h

#include <thermocontact/base/stop_watch.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/report/key_results.h>
#include <thermocontact/simulation/simulation.h>

#include <string>

namespace ThermoContact
{
  /**
   * Writes summary.json; numbers are JSON numbers, NaN is null. Collective.
   *
   * @param status "done" or "failed: " and the reason
   * @param errors of the key results; null: the run has no error bars
   * @throw ComputationError if the file cannot be written
   */
  template <int dim>
  void
  write_summary(const std::string     &file_name,
                const std::string     &status,
                const Simulation<dim> &simulation,
                const Forecast        &forecast,
                const RunTimes        &times,
                const KeyErrors       *errors = nullptr);
} // namespace ThermoContact

#endif
