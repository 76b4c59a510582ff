// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/machine_memory.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/forecast/expected_memory.h>
#include <thermocontact/report/memory_report.h>

#include <deal.II/base/mpi.h>

namespace ThermoContact
{
  std::string
  gigabytes(const double bytes)
  {
    return significant(round_to_digits(bytes / 1e9, 2), 12) + " GB";
  }



  void
  report_memory(const Scene &scene, const MPI_Comm communicator, Log &log)
  {
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(communicator);
    const double expected =
      share_of_ranks_here(communicator) * expected_memory(scene, n_ranks);
    const double available = machine_memory();
    log.line("  memory    about " + gigabytes(expected) + ", here are " +
             gigabytes(available));
    if (expected > available)
      log.line(std::string("  warning:  that may not be enough memory") +
               (scene.linear_solver.is_iterative ?
                  "" :
                  "; Solver/Linear solver = iterative takes less"));
  }
} // namespace ThermoContact
