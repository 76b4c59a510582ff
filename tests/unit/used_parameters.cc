// SPDX-License-Identifier: LGPL-2.1-or-later
//
// used.prm names the directory that it is in, and no rank has another value
// than before in any entry: what is decided by an entry is decided alike.

#include <thermocontact/output/output_directory.h>

#include <deal.II/base/mpi.h>

#include <fstream>

#include "../tests.h"

using namespace ThermoContact;

void
main_used_parameters()
{
  const MPI_Comm communicator = MPI_COMM_WORLD;

  Parameters               parameters;
  dealii::ParameterHandler prm;
  parameters.add_parameters(prm);
  ThermoContact::assign_entries({{"here", "Mesh/Cells", "7"}}, prm, parameters);
  const auto before = entry_values(prm);
  write_used_parameters(".", {"Mesh/Width"}, prm, {}, communicator);
  const auto after = entry_values(prm);

  const unsigned int n_changed =
    dealii::Utilities::MPI::sum(before == after ? 0u : 1u, communicator);
  if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
    return;
  initlog();
  deallog << "ranks with a changed entry " << n_changed << std::endl;
  std::istringstream text(read_text("used.prm"));
  unsigned int       n_written = 0;
  for (const Assignment &assignment : read_assignments(text, "used.prm"))
    {
      n_written += !assignment.is_section();
      if (assignment.path == "Output/Directory" ||
          assignment.path == "Mesh/Cells" || assignment.path == "Mesh/Width")
        deallog << assignment.path << " = " << assignment.value << std::endl;
    }
  // neither those of a file in SI units nor the one that stands for constants
  unsigned int n_others = 0;
  for (const auto &entry : before)
    n_others += entry.first.rfind("Rod/", 0) == 0 ||
                entry.first == "Contact/Stiffness" ||
                entry.first == "Constants/NAME";
  deallog << "all entries but one written "
          << (n_written + 1 + n_others == before.size()) << std::endl;
}
