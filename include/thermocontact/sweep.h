// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_sweep_h
#define thermocontact_sweep_h

#include <thermocontact/base/log.h>
#include <thermocontact/input/command_line.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Runs a study with all its files, goes on with one, or checks it, as the
   * command says. Collective on MPI_COMM_WORLD.
   *
   * @param prm is bound to @p parameters
   * @throw InputError if the study, the directory or the study that is to go on
   *   do not fit
   * @throw ComputationError if a run fails or the study is interrupted
   */
  void
  run_sweep(const Parameters              &parameters,
            ParameterHandler              &prm,
            const std::vector<Assignment> &assignments,
            const CommandLine             &command,
            Log                           &log);
} // namespace ThermoContact

#endif
