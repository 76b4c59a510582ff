// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_sweep_h
#define thermocontact_sweep_h

#include <thermocontact/base/log.h>
#include <thermocontact/scene_run.h>

namespace ThermoContact
{
  /**
   * Runs a study with all its files, goes on with one, or checks it, as the
   * command says. Collective on MPI_COMM_WORLD.
   *
   * @throw InputError if the study, the directory or the study that is to go on
   *   do not fit
   * @throw ComputationError if a run fails or the study is interrupted
   */
  void
  run_sweep(const Request &request, Log &log);
} // namespace ThermoContact

#endif
