// SPDX-License-Identifier: LGPL-2.1-or-later

#include "summary.h"

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include "atomic_file.h"
#include "exceptions.h"
#include "output_directory.h"
#include "scene_terms.h"
#include "version.h"

namespace ThermoContact
{
  unsigned int
  n_contact_begins(const std::vector<ContactEvent> &events)
  {
    unsigned int n = 0;
    for (const ContactEvent &event : events)
      n += event.kind == ContactEvent::begin;
    return n;
  }



  template <int dim>
  void
  write_summary(const std::string     &file_name,
                const std::string     &status,
                const Simulation<dim> &simulation,
                const RunTimes        &times)
  {
    const Parameters    &parameters = simulation.parameters();
    const StepRecord    &record     = simulation.record();
    const SolverCounters counters   = simulation.counters();
    const auto          &space      = simulation.discretization();
    const auto          &events     = simulation.events();

    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    const double peak_memory =
      Utilities::MPI::sum(memory.VmHWM / 1024., space.communicator());

    nlohmann::ordered_json summary = {
      {"title", parameters.title},
      {"status", status},
      {"version", version()},
      {"dimension", dim},
      {"ranks", Utilities::MPI::n_mpi_processes(space.communicator())},
      {"fields", scene_fields(parameters.model)},
      {"terms", scene_terms(parameters)},
      {"dofs", space.n_temperature_dofs() + space.n_displacement_dofs()},
      {"factorized_unknowns", simulation.n_factorized_unknowns()},
      {"scheme", parameters.time.scheme},
      {"steps", record.step},
      {"rejected_steps", simulation.n_rejected_steps()},
      {"factorizations", counters.factorizations},
      {"responses", counters.responses},
      {"solves", counters.solves},
      {"contact_begins", n_contact_begins(events)},
      {"first_contact_time", nullptr},
      {"max_penetration", simulation.max_penetration()},
      {"max_contact_force", simulation.max_contact_force()},
      {"final_time", record.time},
      {"final_displacement_end", record.displacement_end},
      {"final_energy", record.energy},
      {"max_energy_increase", simulation.max_energy_increase()},
      {"set_up_seconds", times.set_up},
      {"loop_seconds", times.loop},
      {"output_seconds", times.output},
      {"wall_seconds", times.wall},
      {"peak_memory_mb", peak_memory},
      {"warnings", simulation.warnings()}};
    if (!events.empty())
      summary["first_contact_time"] = events.front().time;

    std::string fault;
    if (Utilities::MPI::this_mpi_process(space.communicator()) == 0)
      {
        fault = write_atomically(
          file_name,
          summary.dump(
            2, ' ', false, nlohmann::json::error_handler_t::replace) +
            '\n');
      }
    throw_everywhere<ComputationError>(fault, space.communicator());
  }



#define INSTANTIATE(dim)                                    \
  template void write_summary<dim>(const std::string &,     \
                                   const std::string &,     \
                                   const Simulation<dim> &, \
                                   const RunTimes &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
