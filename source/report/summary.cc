// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/version.h>
#include <thermocontact/base/writable_file.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/report/result_report.h>
#include <thermocontact/report/summary.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numeric>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /**
     * Largest memory so far of each rank in MB; 0 where there is no /proc, in
     * which deal.II would read for ever.
     */
    std::vector<double>
    peak_memory_per_rank(const MPI_Comm communicator)
    {
      Utilities::System::MemoryStats memory{};
      if (std::ifstream("/proc/self/status"))
        Utilities::System::get_memory_stats(memory);
      return all_gather(communicator, memory.VmHWM / 1024.);
    }



    /**
     * The forecasts beside the results of the run; null where nothing
     * was.
     */
    nlohmann::ordered_json
    predictions(const Scene      &scene,
                const Forecast   &forecast,
                const StepRecord &record,
                const KeyResults &results)
    {
      const auto       &states = forecast.rest.states;
      const auto       &impact = forecast.impact;
      const SteadyState rest =
        states.empty() ? SteadyState{nan, nan, nan, false} :
                         states[nearest_state(states, final_state(record))];

      nlohmann::ordered_json entries = {
        {"final_contact_force", record.contact_force},
        {"final_temperature_end", record.temperature_end},
        {"final_in_contact", record.in_contact},
        {"predicted_displacement_end", rest.displacement_end},
        {"predicted_contact_force", rest.contact_force},
        {"predicted_temperature_end", rest.temperature_end},
        {"predicted_in_contact", nullptr},
        {"predicted_remark", forecast.rest.remark},
        {"difference_displacement_end",
         record.displacement_end - rest.displacement_end},
        {"difference_contact_force", record.contact_force - rest.contact_force},
        {"difference_temperature_end",
         record.temperature_end - rest.temperature_end},
        {"predicted_first_contact_time", impact ? impact->time : nan},
        {"predicted_first_penetration", impact ? impact->penetration : nan},
        {"predicted_critical_step_size", forecast.critical_step.value_or(nan)},
        {"predicted_steps", forecast.cost.steps}};
      if (!states.empty())
        entries["predicted_in_contact"] = rest.in_contact;
      if (scene.heat.exchange->is_in_matrices())
        return entries;
      const OutputUnits units(scene.parameters);
      auto &all = entries["states_of_rest"] = nlohmann::ordered_json::array();
      for (const SteadyState &state : states)
        all.push_back(
          {{"displacement_end", units.of("length")(state.displacement_end)},
           {"contact_force", units.of("force")(state.contact_force)},
           {"temperature_end", units.of("temperature")(state.temperature_end)},
           {"in_contact", state.in_contact},
           {"is_stable", state.is_stable}});
      const double reached             = results.at("reached_state_of_rest");
      entries["reached_state_of_rest"] = nullptr;
      if (!std::isnan(reached))
        entries["reached_state_of_rest"] = static_cast<unsigned int>(reached);
      return entries;
    }



    /** The numbers of @p summary in units, and which ones. */
    void
    convert(const OutputUnits &units, nlohmann::ordered_json &summary)
    {
      nlohmann::ordered_json names = nlohmann::ordered_json::object();
      for (auto &&item : summary.items())
        if (const Conversion &unit = units.of("summary.json", item.key());
            !unit.unit.empty())
          {
            names[item.key()] = unit.unit;
            if (item.value().is_number())
              item.value() = unit(item.value().get<double>());
          }
      summary["units"] = names;
    }



    /** A number that is not known is null; remarks are warnings. */
    void
    add_errors(const KeyErrors &errors, nlohmann::ordered_json &entries)
    {
      for (const std::string &name : results_with_error_bars())
        {
          entries[name + "_time_error"]  = errors.time.at(name);
          entries[name + "_space_error"] = errors.space.at(name);
        }
      for (const std::string &remark : errors.remarks)
        entries["warnings"].push_back(remark);
    }
  } // namespace



  template <int dim>
  void
  write_summary(const std::string     &file_name,
                const std::string     &status,
                const Simulation<dim> &simulation,
                const Forecast        &forecast,
                const RunTimes        &times,
                const KeyErrors       *errors)
  {
    const Scene         &scene    = simulation.scene();
    const RunHistory    &history  = simulation.history();
    const StepRecord    &record   = history.record;
    const SolverCounters counters = simulation.counters();
    const auto          &space    = simulation.discretization();
    const KeyResults     results  = key_results(scene, history);

    const std::vector<double> memory =
      peak_memory_per_rank(space.communicator());

    nlohmann::ordered_json summary = {
      {"title", scene.parameters.title},
      {"status", status},
      {"version", version()},
      {"dimension", dim},
      {"ranks", Utilities::MPI::n_mpi_processes(space.communicator())},
      {"fields", scene_fields(scene)},
      {"terms", scene_terms(scene)},
      {"dofs", space.n_temperature_dofs() + space.n_displacement_dofs()},
      {"factorized_unknowns", simulation.n_factorized_unknowns()},
      {"scheme", scene.scheme.name},
      {"linear_solver", simulation.linear_solver()},
      {"steps", record.step},
      {"rejected_steps", history.n_rejected_steps},
      {"factorizations", counters.factorizations},
      {"responses", counters.responses},
      {"solves", counters.solves},
      {"linear_iterations", counters.linear_iterations},
      {"max_linear_iterations", counters.max_linear_iterations},
      {"active_set_iterations", counters.active_set_iterations},
      {"contact_begins",
       static_cast<unsigned int>(results.at("contact_begins"))},
      {"first_contact_time", results.at("first_contact_time")},
      {"contact_duration", results.at("contact_duration")},
      {"contact_impulse", record.contact_impulse},
      {"restitution", results.at("restitution")},
      {"max_penetration", history.max_penetration},
      {"max_contact_force", history.max_contact_force},
      {"final_time", record.time},
      {"final_displacement_end", record.displacement_end},
      {"final_energy", record.energy},
      {"max_energy_increase", history.max_energy_increase},
      {"set_up_seconds", times.set_up},
      {"loop_seconds", times.loop},
      {"step_seconds", times.steps},
      {"factorization_seconds", counters.factorization_seconds},
      {"solve_seconds", counters.solve_seconds},
      {"contact_seconds", counters.contact_seconds},
      {"output_seconds", times.output},
      {"wall_seconds", times.wall},
      {"peak_memory_mb", std::accumulate(memory.begin(), memory.end(), 0.)},
      {"peak_memory_mb_per_rank", memory},
      {"warnings", run_warnings(scene, forecast.impact, history)}};
    summary.update(predictions(scene, forecast, record, results));
    if (errors != nullptr)
      add_errors(*errors, summary);
    if (const OutputUnits units(scene.parameters); units.is_si())
      convert(units, summary);

    std::string fault;
    if (Utilities::MPI::this_mpi_process(space.communicator()) == 0)
      fault = write_atomically(
        file_name,
        summary.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
          '\n');
    throw_everywhere<ComputationError>(fault, space.communicator());
  }



#define INSTANTIATE(dim)                                    \
  template void write_summary<dim>(const std::string &,     \
                                   const std::string &,     \
                                   const Simulation<dim> &, \
                                   const Forecast &,        \
                                   const RunTimes &,        \
                                   const KeyErrors *)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
