// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_checkpoint_file_h
#define thermocontact_output_checkpoint_file_h

#include <thermocontact/output/checkpoint.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * A checkpoint file that is whole, open for reading: a line that names the
   * format, a line of JSON for readers, with size and checksum of each part,
   * then the parts: what all ranks have in common, and what one rank has saved
   * after the other. Parts of ranks may be as large as the disk allows; rank 0
   * holds only a piece of them. On rank 0; empty on the others.
   */
  struct CheckpointFile
  {
    std::string path; ///< empty: no file

    std::string                common; ///< the first part
    std::vector<std::uint64_t> sizes;  ///< of the others
    std::ifstream              stream; ///< where they begin
  };



  /**
   * Opens a file and reads it to its end, to see that it is whole. On one rank.
   *
   * @throw std::exception saying what is wrong, without the path
   */
  CheckpointFile
  open_checkpoint_file(const std::string &path);

  /**
   * Reads the checkpoint of @p file; what this rank has saved only if there are
   * as many ranks as the run had. Collective.
   *
   * @throw InputError if the file cannot be read any more
   */
  Checkpoint
  read_checkpoint_file(CheckpointFile &file, const MPI_Comm communicator);

  /**
   * Writes a file and waits until it would survive a loss of power. Collective;
   * rank 0 writes.
   *
   * @return on rank 0, what is wrong, with the path, or nothing
   */
  std::string
  write_checkpoint_file(const std::string &path,
                        const Checkpoint  &checkpoint,
                        const MPI_Comm     communicator);
} // namespace ThermoContact

#endif
