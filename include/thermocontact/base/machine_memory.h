// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_machine_memory_h
#define thermocontact_base_machine_memory_h

#include <mpi.h>

namespace ThermoContact
{
  /**
   * Bytes that the processes of this machine can have together: its memory
   * without swap, or less where a container (cgroup v2) or `ulimit -v` allows
   * less.
   */
  double
  machine_memory();

  /** The part of the ranks that are on the machine of this one. */
  double
  share_of_ranks_here(const MPI_Comm communicator);

  /** Memory of a machine and the part of the ranks that are on it. */
  struct SharedMemory
  {
    double bytes, share;
  };

  /**
   * Of the machine whose ranks have the least memory each, the same on all
   * ranks. Collective.
   */
  SharedMemory
  scarcest_memory(const MPI_Comm communicator);
} // namespace ThermoContact

#endif
