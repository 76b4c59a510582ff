// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/interruption.h>
#include <thermocontact/base/serial_section.h>

#include <chrono>
#include <optional>
#include <thread>

namespace ThermoContact
{
  using namespace dealii;

  int
  share_status(int status, const MPI_Comm communicator)
  {
    std::optional<SignalWatch> signals; // they mean rank 0
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      signals.emplace();
    MPI_Request request;
    int fault = MPI_Ibcast(&status, 1, MPI_INT, 0, communicator, &request);
    AssertThrowMPI(fault);
    // A wait of MPI would take a processor.
    int is_done = 0;
    while (true)
      {
        fault = MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
        AssertThrowMPI(fault);
        if (is_done != 0)
          return status;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
  }
} // namespace ThermoContact
