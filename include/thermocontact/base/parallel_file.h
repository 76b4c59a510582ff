// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_parallel_file_h
#define thermocontact_base_parallel_file_h

#include <deal.II/base/mpi.h>

#include <string>
#include <string_view>
#include <vector>

namespace ThermoContact
{
  /**
   * Writes a file of one part from each rank, in the order of the ranks, of any
   * size: each rank writes its own to its place, and none holds that of
   * another. The directory must be one that all ranks see. Collective.
   *
   * Each rank writes for itself, not by MPI-IO, which in Open MPI 4.1 reports
   * success on a full disk, and hangs at a limit on the size of files.
   *
   * @param part of this rank, in pieces that follow each other
   * @param is_durable wait until the parts would survive a loss of power
   * @return on all ranks, what is wrong on the first that has a fault, with the
   *   path, or nothing
   */
  std::string
  write_parallel_file(const std::string                   &path,
                      const std::vector<std::string_view> &part,
                      const MPI_Comm                       communicator,
                      const bool                           is_durable = false);

  /**
   * The same, but an older file is replaced in one piece, as by
   * write_atomically().
   */
  std::string
  write_parallel_file_atomically(const std::string                   &path,
                                 const std::vector<std::string_view> &part,
                                 const MPI_Comm communicator);
} // namespace ThermoContact

#endif
