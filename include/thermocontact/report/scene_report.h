// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_scene_report_h
#define thermocontact_report_scene_report_h

#include <thermocontact/base/log.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/simulation/simulation.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Prints the warnings after the first @p n_reported.
   *
   * @return their number
   */
  unsigned int
  report_warnings(const std::vector<std::string> &warnings,
                  const unsigned int              n_reported,
                  Log                            &log);

  /** The name of a field at the end of the body or of the row. */
  std::string
  at_end(const std::string &field, const Scene &scene);

  /** The quantities of an end state that the scene has, on one line. */
  std::string
  describe_steady_state(const SteadyState &state, const Scene &scene);

  /**
   * Prints the scene, its cost and the forecasts, before anything is set up.
   * Collective.
   *
   * @param loads that steps follow
   * @param assignments of the file: in SI units expressions are shown as they
   *   stand there
   * @param communicator of the ranks that share the body
   */
  void
  report_scene(const Scene                   &scene,
               const LoadHistory             &loads,
               const Forecast                &forecast,
               const std::vector<Assignment> &assignments,
               const MPI_Comm                 communicator,
               Log                           &log);

  /**
   * Prints the results of set-up, and the warnings so far.
   *
   * @param seconds since the start of the program, printed of a body
   */
  template <int dim>
  void
  report_set_up(const Simulation<dim> &simulation,
                const double           seconds,
                Log                   &log);

  /**
   * Warns of a run that would take more than 1e8 steps or write more than 10
   * GB.
   *
   * @param free_bytes of the disk of the results
   * @param is_forced it may be too small
   * @throw InputError if it is
   */
  void
  check_cost(const ExpectedCost &cost,
             const double        free_bytes,
             const bool          is_forced,
             Log                &log);
} // namespace ThermoContact

#endif
