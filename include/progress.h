// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_progress_h
#define thermocontact_progress_h

#include "log.h"
#include "simulation.h"

namespace ThermoContact
{
  /** Prints one line whenever another tenth of the run is done. */
  template <int dim>
  void
  report_progress(const Simulation<dim> &simulation, Log &log);
} // namespace ThermoContact

#endif
