// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/report/result_report.h>
#include <thermocontact/report/scene_report.h>
#include <thermocontact/simulation/spatial_error_monitor.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    // More than this of the energy is more than engineers leave to a scheme.
    constexpr double largest_numerical_part = 0.05;

    /** Of the time of the first impact, by a run on a few cells. */
    constexpr double largest_forecast_error = 0.05;



    /** How often there was contact, when and how long, and what it did. */
    std::string
    describe_contact(const Scene &scene, const RunHistory &history)
    {
      const OutputUnits        units(scene.parameters);
      constexpr unsigned int   few     = 5;
      const KeyResults         results = key_results(scene, history);
      const auto              &events  = history.events;
      std::vector<std::string> durations;
      for (unsigned int i = 1; i < events.size(); ++i)
        if (events[i].kind == ContactEvent::end)
          durations.push_back(
            units.text("time", duration_of_contact(events, i)));
      std::string line = text(results.at("contact_begins"), " times");
      if (!events.empty())
        line += ", first at t = " + units.text("time", events.front().time);
      if (!durations.empty() && durations.size() <= few)
        line += ", for " + join_words(durations);
      if (durations.size() > 1 ||
          (!events.empty() && history.record.in_contact))
        line += ", in contact altogether " +
                units.text("time", results.at("contact_duration"));
      return line + ", peak force " +
             units.text("force", history.max_contact_force) +
             (is_largest_force_of_mesh(scene, events) ? " (of the mesh)" : "") +
             ", peak penetration " +
             units.text("length", history.max_penetration) + ", impulse " +
             units.text("force × time", history.record.contact_impulse);
    }



    /** Where the scene tends to, and how far it is from there. */
    std::string
    compare_with_rest(const SteadyState &rest,
                      const StepRecord  &record,
                      const Scene       &scene)
    {
      const OutputUnits        units(scene.parameters);
      std::vector<std::string> words;
      const auto               add = [&](const std::string &name,
                           const char        *kind,
                           const double       value,
                           const double       predicted) {
        if (std::isfinite(predicted))
          words.push_back(
            text(name, " by ", units.text(kind, value - predicted, 2)));
      };
      add(at_end("u", scene),
          "length",
          shown_displacement(record),
          rest.displacement_end);
      add(at_end("theta", scene),
          "temperature difference",
          record.temperature_end,
          rest.temperature_end);
      if (scene.contact.law->is_active())
        add("force", "force", record.contact_force, rest.contact_force);
      return describe_steady_state(rest, scene) + "; differs in " +
             join_words(words);
    }



    /** The audit (D4.1) of the whole run. */
    std::string
    describe_energy(const StepRecord  &record,
                    const double       initial_energy,
                    const OutputUnits &units)
    {
      const double rounding =
        Tolerances::rounding_of_data * std::max({std::abs(initial_energy),
                                                 std::abs(record.energy),
                                                 std::abs(record.work)});
      const auto in = [&](const double       energy,
                          const unsigned int digits = few_digits) {
        return units.text("energy",
                          std::abs(energy) > rounding ? energy : 0.,
                          digits);
      };
      const double defect = initial_energy - starting_energy(record);
      return in(initial_energy) + " at first + work " + in(record.work) +
             " = " + in(record.energy) + " + dissipated " +
             in(record.dissipation) +
             (record.lateral_dissipation == 0. ?
                "" :
                " (" + in(record.lateral_dissipation) +
                  " to the surroundings)") +
             (record.contact_dissipation == 0. ?
                "" :
                " + taken by the obstacle " + in(record.contact_dissipation)) +
             " + lost to the scheme " + in(record.numerical_dissipation) +
             (record.algebraic == 0. ?
                "" :
                "; brought in by residuals " + in(record.algebraic, 2)) +
             "; defect " + in(defect, 2);
    }



    /** A table of where the wall time went. */
    void
    report_times(const RunTimes       &times,
                 const SolverCounters &counters,
                 Log                  &log)
    {
      const double steps_rest =
        times.steps - counters.solve_seconds - counters.contact_seconds;
      const std::pair<const char *, double> sections[] = {
        {"set-up", times.set_up},
        {"steps: factorisations", counters.factorization_seconds},
        {"steps: solves",
         counters.solve_seconds - counters.factorization_seconds},
        {"steps: contact", counters.contact_seconds},
        {"steps: energy, errors, rest", steps_rest},
        {"rows and screen", times.loop - times.steps},
        {"fields and checkpoints", times.output},
        {"repeats for error bars", times.repeats},
        {"whole run", times.wall}};
      const char *title = "time";
      for (const auto &[name, seconds] : sections)
        {
          if (seconds == 0. && std::string(name) == "repeats for error bars")
            continue;
          const double share = 100. * std::max(0., seconds) / times.wall;
          log.line(text("  ",
                        align_left(title, 10),
                        align_left(name, 29),
                        align_right(fixed_point(std::max(0., seconds), 3), 9),
                        " s ",
                        align_right(fixed_point(share, 1), 5),
                        " %"));
          title = "";
        }
    }
  } // namespace



  std::vector<std::string>
  step_warnings(const Scene                      &scene,
                const std::optional<FirstImpact> &impact,
                const RunHistory                 &history)
  {
    std::vector<std::string> warnings;
    const StepRecord        &record = history.record;
    const auto              &size   = scene.parameters.time.step_size;
    if (!size)
      return warnings;
    const double there =
      std::max(starting_energy(record), 0.) + std::max(record.work, 0.);
    if (there > 0. &&
        record.numerical_dissipation > largest_numerical_part * there)
      warnings.push_back(
        text("the scheme took ",
             significant(100. * record.numerical_dissipation / there, 2),
             " % of the energy that was there: a smaller Time/Step size, or "
             "automatic"));
    if (!impact)
      return warnings;
    const double allowed =
      std::min(*size, impact->time) + largest_forecast_error * impact->time;
    const double time =
      history.events.empty() ? record.time : history.events.front().time;
    if (time > impact->time + allowed ||
        (!history.events.empty() && time < impact->time - allowed))
      {
        const OutputUnits units(scene.parameters);
        const auto        in_time = [&units](const double value) {
          return units.text("time", value, 3);
        };
        warnings.push_back(
          "the first contact is at t = about " + in_time(impact->time) +
          ", and fixed steps of " + in_time(*size) +
          (history.events.empty() ? " have none up to t = " :
                                    " have it at t = ") +
          in_time(time) + ": a smaller Time/Step size, or automatic");
      }
    return warnings;
  }



  std::vector<std::string>
  run_warnings(const Scene                      &scene,
               const std::optional<FirstImpact> &impact,
               const RunHistory                 &history)
  {
    std::vector<std::string>       all = history.warnings;
    const std::vector<std::string> of_steps =
      step_warnings(scene, impact, history);
    all.insert(all.end(), of_steps.begin(), of_steps.end());
    return all;
  }



  void
  report_result(const Scene          &scene,
                const Forecast       &forecast,
                const RunHistory     &history,
                const SolverCounters &counters,
                const RunTimes       &times,
                const double          initial_energy,
                Log                  &log)
  {
    const StepRecord &record = history.record;
    const OutputUnits units(scene.parameters);
    if (scene.contact.law->is_active())
      log.line("  contact   " + describe_contact(scene, history));
    if (units.is_si() && !scene.parameters.has_masses_alone() &&
        history.max_contact_force > Tolerances::yield_strain)
      log.line("  doubt     the peak force is a strain of " +
               significant(history.max_contact_force, 2) +
               ": most metals yield there, and the model does not");
    log.line("  final     " +
             describe_steady_state(final_state(record), scene));
    if (const auto &rest = forecast.rest.states; !rest.empty())
      log.line("  steady    " +
               compare_with_rest(rest[nearest_state(rest, final_state(record))],
                                 record,
                                 scene));
    log.line("  energy    " + describe_energy(record, initial_energy, units));
    for (const std::string &warning :
         step_warnings(scene, forecast.impact, history))
      log.line("  warning:  " + warning);
    log.line(text(
      "  cost      ",
      record.step,
      " steps, ",
      history.n_rejected_steps,
      " rejected, ",
      counters.factorizations,
      " factorisations, ",
      counters.solves,
      " solves; ",
      significant(record.step == 0 ? 0. : 1e6 * times.loop / record.step, 3),
      " us per step"));
    if (scene.linear_solver.is_iterative)
      log.line(text("  linear    ",
                    counters.linear_iterations,
                    " Krylov iterations, at most ",
                    counters.max_linear_iterations,
                    " for a system; ",
                    counters.active_set_iterations,
                    " sets of contact nodes"));
    report_times(times, counters, log);
  }



  void
  report_errors(const Scene      &scene,
                const RunHistory &history,
                const KeyErrors  &errors,
                Log              &log)
  {
    const OutputUnits units(scene.parameters);
    const auto        in = [&units](const std::string &key,
                             const double       value,
                             const unsigned int digits) {
      return std::isnan(value) ?
                      "unknown" :
                      units.text(kind_of("summary.json", key), value, digits);
    };
    for (const std::string &remark : errors.remarks)
      log.line("  warning:  " + remark);
    const bool are_joined = scene.scheme.has_no_dispersion;
    log.line(text("  errors    by ",
                  errors.n_repeats,
                  " repeats: value, ",
                  are_joined ? "+- in time and space together" :
                               "+- in time, +- in space",
                  "; few errors are beyond 3 of these"));
    const KeyResults values = key_results(scene, history);
    for (const std::string &name : results_with_error_bars())
      if (const double value = values.at(name); !std::isnan(value))
        log.line(text("            ",
                      align_left(name, 24),
                      align_left(in(name, value, few_digits), 12),
                      are_joined ? "" :
                                   "  +- " + align_left(in(name + "_time_error",
                                                           errors.time.at(name),
                                                           2),
                                                        8),
                      "  +- ",
                      in(name + "_space_error", errors.space.at(name), 2)));
  }
} // namespace ThermoContact
