// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/machine_memory.h>
#include <thermocontact/base/text.h>
#include <thermocontact/forecast/expected_memory.h>
#include <thermocontact/study/study_memory.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  double
  StudyMemory::expected(const Scene &scene)
  {
    has_bodies |= scene.parameters.dimension > 1;
    return expected_memory(scene, 1);
  }



  void
  StudyMemory::add(const std::string &run, const Scene &scene)
  {
    runs.push_back({run, expected(scene)});
  }



  void
  StudyMemory::add_reference(const Scene &scene)
  {
    bytes_of_reference = expected(scene);
  }



  std::string
  StudyMemory::report(const MPI_Comm communicator) const
  {
    const SharedMemory memory = scarcest_memory(communicator);
    if (!has_bodies)
      return "";
    const auto        n_here    = static_cast<std::size_t>(std::round(
      memory.share * dealii::Utilities::MPI::n_mpi_processes(communicator)));
    const std::size_t n_at_once = std::min(n_here, runs.size());
    std::vector<Run>  largest   = runs;
    std::stable_sort(largest.begin(),
                     largest.end(),
                     [](const Run &a, const Run &b) {
                       return a.bytes > b.bytes;
                     });
    double bytes = 0.;
    for (std::size_t i = 0; i < n_at_once; ++i)
      bytes += largest[i].bytes;
    std::string what;
    if (n_at_once > 0)
      what = gigabytes(largest[0].bytes) + " for " + largest[0].name;
    if (n_at_once > 1)
      what += text(", ",
                   gigabytes(bytes),
                   " for the ",
                   n_at_once,
                   " largest runs, which may be under way at the same time");
    if (bytes_of_reference > 0.)
      what += text(what.empty() ? "" : ", ",
                   gigabytes(bytes_of_reference),
                   " for the reference");
    const double      needed      = std::max(bytes, bytes_of_reference);
    const std::string fewer_ranks = n_at_once > 1 ? "fewer ranks, " : "";
    if (needed > 2. * memory.bytes)
      throw InputError(
        text(bytes > 2. * memory.bytes ? "Study/Vary" : "Study/Reference",
             ": the study takes, of memory here, about ",
             what,
             "; there are ",
             gigabytes(memory.bytes),
             "\n  allowed: what takes less than twice as much as there is, "
             "since the forecast may be off by as much\n  remedy:  ",
             fewer_ranks,
             "fewer Mesh/Cells, a lower Mesh/Degree, Solver/Linear solver = "
             "iterative"));
    std::string lines =
      "  memory    about " + what + "; here are " + gigabytes(memory.bytes);
    if (needed > memory.bytes)
      lines += text("\n  warning:  that may not be enough memory; ",
                    n_at_once > 1 ? "fewer ranks or " : "",
                    "Solver/Linear solver = iterative take less");
    return lines;
  }
} // namespace ThermoContact
