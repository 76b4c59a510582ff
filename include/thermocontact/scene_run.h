// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_run_h
#define thermocontact_scene_run_h

#include <thermocontact/base/log.h>
#include <thermocontact/input/command_line.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/parameters.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** The request of the user. */
  struct Request
  {
    /**
     * @param command borrowed
     * @param assignments of the parameter file and the command line
     * @throw InputError as assign_entries()
     */
    Request(const CommandLine             &command,
            const std::vector<Assignment> &assignments);

    const CommandLine            &command;
    const std::vector<Assignment> assignments;
    Parameters                    parameters;
    ParameterHandler              prm; ///< bound to parameters

    /** Where the files go: as given, or `results/` and the file's name. */
    std::string
    output_directory() const;

    /** The command, for a shell, that goes on with a run or a study. */
    std::string
    resume_command(const MPI_Comm communicator) const;
  };



  /**
   * Sets up one scene, or goes on from a checkpoint, and runs it with all its
   * files; or checks it, if the command says so. Collective on the ranks of
   * MPI_COMM_WORLD, of which those that share the body compute: of a rod, one.
   *
   * @param scene of the parameters, which fits together
   * @param since_start runs since the start of the program
   * @throw InputError if the scene, the directory or the checkpoint do not fit
   * @throw ComputationError if the run fails or is interrupted
   */
  void
  run_scene(const Request       &request,
            const Scene         &scene,
            const dealii::Timer &since_start,
            Log                 &log);
} // namespace ThermoContact

#endif
