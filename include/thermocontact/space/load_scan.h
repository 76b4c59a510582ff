// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_load_scan_h
#define thermocontact_space_load_scan_h

#include <thermocontact/method/load_history.h>
#include <thermocontact/space/problem_data.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The history of the loads of a scene that steps follow: the break points
   * that are listed and, for error-controlled steps, the expressions in t up to
   * the end time: where they depend on the place, at 61 places and in the body
   * where they are largest. Costs nothing
   * where nothing depends on t. The same on all ranks.
   *
   * @param warnings out: loads that could not be resolved are appended
   */
  template <int dim>
  LoadHistory
  load_history(const Scene              &scene,
               const ProblemData<dim>   &data,
               std::vector<std::string> &warnings);



  /**
   * The entries of loads whose change in a step is more than half of their
   * change in the whole run, separated by commas: for the message of a step
   * that fails.
   */
  template <int dim>
  std::string
  changing_loads(const Scene            &scene,
                 const ProblemData<dim> &data,
                 const double            from,
                 const double            to);
} // namespace ThermoContact

#endif
