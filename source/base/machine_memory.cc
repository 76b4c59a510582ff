// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/machine_memory.h>

#include <deal.II/base/mpi.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace ThermoContact
{
  using dealii::Utilities::MPI::n_mpi_processes;
  using dealii::Utilities::MPI::this_mpi_process;

  double
  machine_memory()
  {
    double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                   static_cast<double>(sysconf(_SC_PAGESIZE));
    // a file that is not there, or says "max", gives no number
    std::ifstream container("/sys/fs/cgroup/memory.max");
    if (double limit; container >> limit)
      bytes = std::min(bytes, limit);
    rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
    return bytes;
  }



  double
  share_of_ranks_here(const MPI_Comm communicator)
  {
    MPI_Comm here;
    MPI_Comm_split_type(
      communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    const double n_here = n_mpi_processes(here);
    MPI_Comm_free(&here);
    return n_here / n_mpi_processes(communicator);
  }



  SharedMemory
  scarcest_memory(const MPI_Comm communicator)
  {
    double values[2] = {machine_memory(), share_of_ranks_here(communicator)};
    struct
    {
      double bytes_of_run;
      int    rank;
    } scarcest = {values[0] / values[1],
                  static_cast<int>(this_mpi_process(communicator))};
    MPI_Allreduce(
      MPI_IN_PLACE, &scarcest, 1, MPI_DOUBLE_INT, MPI_MINLOC, communicator);
    MPI_Bcast(values, 2, MPI_DOUBLE, scarcest.rank, communicator);
    return {values[0], values[1]};
  }
} // namespace ThermoContact
