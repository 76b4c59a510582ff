// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_h
#define thermocontact_report_h

#include <string>
#include <vector>

#include "log.h"
#include "simulation.h"

namespace ThermoContact
{
  /** Where the wall time of a run went, in seconds. */
  struct RunTimes
  {
    double set_up = 0.;
    double loop   = 0.; ///< steps and CSV rows
    double output = 0.; ///< snapshots
    double wall   = 0.; ///< from the start of the program
  };



  /**
   * Prints the warnings after the first @p n_reported.
   *
   * @return their number
   */
  unsigned int
  report_warnings(const std::vector<std::string> &warnings,
                  const unsigned int              n_reported,
                  Log                            &log);

  /** Prints what is going to be computed, and the warnings so far. */
  template <int dim>
  void
  report_scene(const Simulation<dim> &simulation, Log &log);

  /** Prints one line whenever another tenth of the run is done. */
  template <int dim>
  void
  report_progress(const Simulation<dim> &simulation, Log &log);

  /** Prints contacts, final state, energy audit, cost. */
  template <int dim>
  void
  report_result(const Simulation<dim> &simulation,
                const RunTimes        &times,
                Log                   &log);

  /**
   * Writes summary.json; numbers are JSON numbers, NaN is null. Collective.
   *
   * @param status "done" or "failed: " and the reason
   * @throw ComputationError if the file cannot be written
   */
  template <int dim>
  void
  write_summary(const std::string     &file_name,
                const std::string     &status,
                const Simulation<dim> &simulation,
                const RunTimes        &times);
} // namespace ThermoContact

#endif
