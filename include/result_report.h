// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_result_report_h
#define thermocontact_result_report_h

#include "log.h"
#include "run_times.h"
#include "simulation.h"

namespace ThermoContact
{
  /** Prints contacts, final state, energy audit, cost. */
  template <int dim>
  void
  report_result(const Simulation<dim> &simulation,
                const RunTimes        &times,
                Log                   &log);
} // namespace ThermoContact

#endif
