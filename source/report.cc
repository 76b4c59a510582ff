// SPDX-License-Identifier: LGPL-2.1-or-later

#include "report.h"

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <iomanip>
#include <sstream>

#include "exceptions.h"
#include "output_directory.h"
#include "scene_terms.h"
#include "version.h"

namespace ThermoContact
{
  namespace
  {
    /** Concatenates its arguments as a stream prints them. */
    template <typename... Arguments>
    std::string
    text(const Arguments &...arguments)
    {
      std::ostringstream stream;
      (stream << ... << arguments);
      return stream.str();
    }



    unsigned int
    n_begins(const std::vector<ContactEvent> &events)
    {
      unsigned int n = 0;
      for (const ContactEvent &event : events)
        n += event.kind == ContactEvent::begin;
      return n;
    }



    template <int dim>
    std::string
    describe_body(const Simulation<dim> &simulation)
    {
      const MeshParameters &mesh = simulation.parameters().mesh;
      const unsigned int    n    = simulation.discretization().n_active_cells();
      if (dim == 1)
        return text("rod of length 1, ", n, " cells of degree ", mesh.degree);
      return text(dim,
                  "-D body of length 1 and width ",
                  mesh.width,
                  ", ",
                  n,
                  " cells of degree ",
                  mesh.degree,
                  ", lateral faces: ",
                  simulation.parameters().boundary.lateral_support);
    }



    std::string
    join_words(const std::vector<std::string> &words)
    {
      std::string line;
      for (const std::string &word : words)
        line += (line.empty() ? "" : ", ") + word;
      return line;
    }



    template <int dim>
    std::string
    describe_unknowns(const Simulation<dim> &simulation)
    {
      const auto &space = simulation.discretization();
      std::string line;
      if (space.has_field(0))
        line = text(space.n_temperature_dofs(), " temperature");
      if (space.has_field(1))
        line += text(line.empty() ? "" : " + ",
                     space.n_displacement_dofs(),
                     " displacement");
      return line +
             text("; factorised at once: ", simulation.n_factorized_unknowns());
    }



    std::string
    describe_contact(const Parameters &parameters)
    {
      const ContactLaw law = parameters.contact_law();
      if (!law.is_active)
        return "none: free end";
      const std::string nodes =
        parameters.has_massless_contact() ? ", massless contact nodes" : "";
      if (law.compliance == 0.)
        return text("rigid obstacle, g = ", law.gap, nodes);
      return text("elastic obstacle, epsilon = ",
                  law.compliance,
                  ", g = ",
                  law.gap,
                  nodes);
    }



    std::string
    describe_time(const Parameters &parameters)
    {
      const TimeParameters &time = parameters.time;
      const std::string     steps =
        time.has_error_control() ?
              text("error-controlled steps, tolerance ", time.tolerance) :
              text("dt = ", *time.step_size, ", ", time.n_steps(), " steps");
      return text(time.scheme,
                  ", ",
                  steps,
                  ", T = ",
                  time.end_time,
                  time.locates_contact_events() &&
                      parameters.contact_law().is_active ?
                    ", contact events located" :
                    "",
                  ", ",
                  parameters.has_prescribed_start() ? "start of the paper" :
                                                      "consistent start",
                  ", ",
                  parameters.solver.step_solver,
                  " solver");
    }



    template <int dim>
    std::string
    join_events(const Simulation<dim> &simulation)
    {
      const auto &events = simulation.events();
      std::string line   = text(n_begins(events), " times");
      if (!events.empty())
        line += text(", first at t = ", events.front().time);
      return line + text(", peak force ",
                         simulation.max_contact_force(),
                         ", peak penetration ",
                         simulation.max_penetration());
    }



    template <int dim>
    std::string
    describe_final_state(const Simulation<dim> &simulation)
    {
      const StepRecord &record     = simulation.record();
      const Parameters &parameters = simulation.parameters();
      std::string       state;
      if (parameters.model.has_displacement())
        state = text("u(1) = ", record.displacement_end);
      if (parameters.model.has_temperature())
        state += text(
          state.empty() ? "" : ", ", "theta(1) = ", record.temperature_end);
      if (parameters.contact_law().is_active)
        state += text(", force ",
                      record.contact_force,
                      record.in_contact ? ", in contact" : ", open");
      return state;
    }
  } // namespace



  unsigned int
  report_warnings(const std::vector<std::string> &warnings,
                  const unsigned int              n_reported,
                  Log                            &log)
  {
    for (unsigned int i = n_reported; i < warnings.size(); ++i)
      log.line("  warning:  " + warnings[i]);
    return warnings.size();
  }



  template <int dim>
  void
  report_scene(const Simulation<dim> &simulation, Log &log)
  {
    const Parameters &parameters = simulation.parameters();
    const auto       &model      = parameters.model;
    const auto       &boundary   = parameters.boundary;

    if (!parameters.title.empty())
      log.line(parameters.title);
    log.line("  body      " + describe_body(simulation));
    log.line("  unknowns  " + describe_unknowns(simulation));
    log.line("  terms     " + join_words(scene_terms(parameters)));
    if (model.has_displacement())
      log.line(
        text("  model     ",
             model.has_temperature() ? text("a = ", model.coupling, ", ") : "",
             "b = ",
             model.inertia,
             ", zeta = ",
             model.viscosity,
             dim == 1 ? "" : text(", nu = ", model.poisson_ratio)));
    if (model.has_temperature())
      log.line(text("  heat      theta_A = ",
                    boundary.fixed_end_temperature,
                    ", k = ",
                    boundary.heat_exchange,
                    ", theta_obs = ",
                    boundary.obstacle_temperature));
    if (model.has_displacement())
      log.line("  contact   " + describe_contact(parameters));
    log.line("  time      " + describe_time(parameters));
    report_warnings(simulation.warnings(), 0, log);
  }



  template <int dim>
  void
  report_progress(const Simulation<dim> &simulation, Log &log)
  {
    const StepRecord &record   = simulation.record();
    const double      end_time = simulation.parameters().time.end_time;
    const auto        tenths   = [end_time](const double time) {
      return static_cast<unsigned int>(10. * time / end_time + 1e-9);
    };
    if (record.step == 0 ||
        tenths(record.time) == tenths(record.time - record.step_size))
      return;
    std::string line = text("  ",
                            std::setw(3),
                            10 * tenths(record.time),
                            " %   t = ",
                            std::setw(10),
                            std::left,
                            record.time);
    const auto  add  = [&line](const char *name, const double value) {
      line += text("  ", name, " = ", std::setw(12), std::left, value);
    };
    const Parameters &parameters = simulation.parameters();
    if (parameters.model.has_displacement())
      add("u(1)", record.displacement_end);
    if (parameters.contact_law().is_active)
      {
        add("gap", record.gap);
        add("force", record.contact_force);
      }
    if (parameters.model.has_temperature())
      add("theta(1)", record.temperature_end);
    log.line(line.substr(0, line.find_last_not_of(' ') + 1));
  }



  template <int dim>
  void
  report_result(const Simulation<dim> &simulation,
                const RunTimes        &times,
                Log                   &log)
  {
    const StepRecord    &record   = simulation.record();
    const SolverCounters counters = simulation.counters();
    if (simulation.parameters().contact_law().is_active)
      log.line("  contact   " + join_events(simulation) +
               text(", impulse ", record.contact_impulse));
    log.line("  final     " + describe_final_state(simulation));
    log.line(text("  energy    ",
                  record.energy,
                  ", dissipated ",
                  record.dissipation,
                  ", lost to the scheme ",
                  record.numerical_dissipation,
                  ", work ",
                  record.work));
    log.line(text("  cost      ",
                  record.step,
                  " steps, ",
                  counters.factorizations,
                  " factorisations, ",
                  counters.solves,
                  " solves; set-up ",
                  times.set_up,
                  " s, loop ",
                  times.loop,
                  " s (",
                  record.step == 0 ? 0. : 1e6 * times.loop / record.step,
                  " us per step), fields ",
                  times.output,
                  " s"));
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
      {"contact_begins", n_begins(events)},
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
        std::ofstream file(file_name);
        file << summary.dump(2,
                             ' ',
                             false,
                             nlohmann::json::error_handler_t::replace)
             << '\n';
        file.close();
        if (!file)
          fault = file_name +
                  ": cannot be written\n  remedy:  check free space "
                  "and rights";
      }
    throw_everywhere<ComputationError>(fault, space.communicator());
  }



#define INSTANTIATE(dim)                                              \
  template void report_scene<dim>(const Simulation<dim> &, Log &);    \
  template void report_progress<dim>(const Simulation<dim> &, Log &); \
  template void report_result<dim>(const Simulation<dim> &,           \
                                   const RunTimes &,                  \
                                   Log &);                            \
  template void write_summary<dim>(const std::string &,               \
                                   const std::string &,               \
                                   const Simulation<dim> &,           \
                                   const RunTimes &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
