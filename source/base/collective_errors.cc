// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective_errors.h>

namespace ThermoContact
{
  using namespace dealii;

  std::string
  first_fault(const std::string &fault, const MPI_Comm communicator)
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return fault;
    for (const std::string &message :
         Utilities::MPI::all_gather(communicator, fault))
      if (!message.empty())
        return message;
    return "";
  }
} // namespace ThermoContact
