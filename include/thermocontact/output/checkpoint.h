// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_checkpoint_h
#define thermocontact_output_checkpoint_h

#include <thermocontact/base/types.h>
#include <thermocontact/output/output.h>

#include <map>
#include <string>

namespace ThermoContact
{
  /**
   * A run at the end of a step: all that it takes to go on as if it had never
   * stopped. The newest two are kept in the output directory, checkpoint.bin
   * and checkpoint.previous.bin.
   */
  struct Checkpoint
  {
    double       time = 0.;
    unsigned int step = 0;

    /** Program that wrote it. */
    std::string version;

    /** Path and value of every parameter. */
    std::map<std::string, std::string> parameters;

    /** Ranks of the run. */
    unsigned int n_ranks = 0;

    /** What Simulation::save() gave on this rank. */
    std::string simulation;

    OutputProgress output;

    /** What is wrong with a newer one that cannot be read; mostly empty. */
    std::string warning;
  };



  /**
   * Makes @p checkpoint the newest of @p directory, in one piece and surviving
   * a loss of power. Collective; rank 0 writes, and holds no other rank's
   * memory as a whole.
   *
   * @throw ComputationError saying what is wrong, with the path; the earlier
   *   ones are as they were then
   */
  void
  write_checkpoint(const std::string &directory,
                   const Checkpoint  &checkpoint,
                   const MPI_Comm     communicator);

  /**
   * Reads the newest checkpoint of @p directory that is whole. Collective, read
   * by rank 0. The parts of the ranks are read only if they are as many as
   * those of the run.
   *
   * @throw InputError if there is none, with what is wrong with each file
   */
  Checkpoint
  read_checkpoint(const std::string &directory, const MPI_Comm communicator);

  /**
   * Before a run goes on from @p checkpoint: a newer one that cannot be read is
   * replaced by it. On one rank.
   */
  void
  keep_as_newest(const std::string &directory, const Checkpoint &checkpoint);

  /**
   * Looks whether the tables of a run are as long as @p progress says; on one
   * rank.
   *
   * @return what is wrong, with path and remedy, or nothing
   */
  std::string
  find_short_file(const std::string &directory, const OutputProgress &progress);

  /**
   * Compares a checkpoint with the run that is to go on from it. End time,
   * the directory and the intervals of the output may differ.
   *
   * @param parameters path and value of every parameter of that run
   * @throw InputError naming what differs, or an end time before the
   *   checkpoint
   */
  void
  check_compatibility(const Checkpoint                         &checkpoint,
                      const std::map<std::string, std::string> &parameters,
                      const double                              end_time,
                      const unsigned int                        n_ranks);
} // namespace ThermoContact

#endif
