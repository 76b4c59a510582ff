// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_checkpoint_h
#define thermocontact_output_checkpoint_h

#include <thermocontact/base/types.h>
#include <thermocontact/output/output.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** A part of a file. */
  struct PartPlace
  {
    std::uint64_t begin    = 0;
    std::uint64_t size     = 0;
    std::uint32_t checksum = 0;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &begin &size &checksum;
    }
  };



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

    /** The results of Simulation::save(). */
    std::string progress; ///< of all ranks
    std::string nodes;    ///< of this rank

    OutputProgress output;

    /** Where progress, then the nodes of each rank, are in the file. */
    std::string            path;
    std::vector<PartPlace> parts;

    /** The fault of a newer one that cannot be read; mostly empty. */
    std::string warning;
  };



  /**
   * Makes @p checkpoint the newest of @p directory, in one piece and surviving
   * a loss of power. Collective; each rank writes its nodes.
   *
   * @throw ComputationError with the fault and the path; the earlier
   *   ones are as they were then
   */
  void
  write_checkpoint(const std::string &directory,
                   const Checkpoint  &checkpoint,
                   const MPI_Comm     communicator);

  /**
   * Reads the newest checkpoint of @p directory that is whole, without the
   * nodes. Collective: each rank looks at its share of the file.
   *
   * @throw InputError if there is none, with the fault of each file
   */
  Checkpoint
  read_checkpoint(const std::string &directory, const MPI_Comm communicator);

  /**
   * Reads the nodes that rank @p rank of the run had; any rank can.
   *
   * @throw std::runtime_error if the file cannot be read any more
   */
  std::string
  read_nodes(const Checkpoint &checkpoint, const unsigned int rank);

  /**
   * Before a run goes on from @p checkpoint: a newer one that cannot be read is
   * replaced by it. On one rank.
   */
  void
  keep_as_newest(const std::string &directory, const Checkpoint &checkpoint);

  /**
   * Compares a checkpoint with the run that is to go on from it. Title, end
   * time, the directory, the intervals of the output and the number of ranks
   * may differ. The tables in @p directory are at least as long as they were.
   * Collective.
   *
   * @param entries path and value of every parameter of that run
   * @throw InputError naming an entry that differs, a file that is too short,
   * or an end time before the checkpoint
   */
  void
  check_compatibility(const Checkpoint                         &checkpoint,
                      const std::string                        &directory,
                      const std::map<std::string, std::string> &entries,
                      const Parameters                         &parameters,
                      const MPI_Comm                            communicator);
} // namespace ThermoContact

#endif
