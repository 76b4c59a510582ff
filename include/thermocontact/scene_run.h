// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_run_h
#define thermocontact_scene_run_h

#include <thermocontact/base/log.h>
#include <thermocontact/input/command_line.h>
#include <thermocontact/input/parameters.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <string>

namespace ThermoContact
{
  /** Where the files of a run go: as given, or `results/` and the file's name.
   */
  std::string
  output_directory(const Parameters &parameters, const CommandLine &command);

  /** The command, for a shell, that goes on with a run or a study. */
  std::string
  resume_command(const CommandLine &command,
                 const std::string &directory,
                 const MPI_Comm     communicator);

  /**
   * Sets up one scene, or goes on from a checkpoint, and runs it with all its
   * files; or checks it, if the command says so. Collective on the ranks of
   * MPI_COMM_WORLD that share the body: of a rod, one alone.
   *
   * @param prm is bound to @p parameters
   * @param assignments of the file
   * @param since_start runs since the start of the program
   * @throw InputError if the scene, the directory or the checkpoint do not fit
   * @throw ComputationError if the run fails or is interrupted
   */
  template <int dim>
  void
  run_scene(const Parameters              &parameters,
            ParameterHandler              &prm,
            const std::vector<Assignment> &assignments,
            const CommandLine             &command,
            const dealii::Timer           &since_start,
            Log                           &log);
} // namespace ThermoContact

#endif
