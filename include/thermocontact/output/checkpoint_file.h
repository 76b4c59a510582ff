// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_checkpoint_file_h
#define thermocontact_output_checkpoint_file_h

#include <thermocontact/output/checkpoint.h>

#include <string>

namespace ThermoContact
{
  /**
   * Reads a checkpoint file without the nodes, and looks at all of it, to see
   * that it is whole. Collective; each rank reads its share.
   *
   * The file is a line that names the format, a line of JSON for readers, with
   * size and checksum of each part, then the parts: what all ranks have in
   * common, and the nodes of one rank after the other, which may be as large as
   * the disk allows.
   *
   * @param fault out: what is wrong, without the path, or nothing; on all ranks
   */
  Checkpoint
  read_checkpoint_file(const std::string &path,
                       std::string       &fault,
                       const MPI_Comm     communicator);

  /**
   * Writes a file and waits until it would survive a loss of power. Collective;
   * each rank writes its nodes.
   *
   * @return on all ranks, what is wrong, with the path, or nothing
   */
  std::string
  write_checkpoint_file(const std::string &path,
                        const Checkpoint  &checkpoint,
                        const MPI_Comm     communicator);
} // namespace ThermoContact

#endif
