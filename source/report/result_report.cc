// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/forecast/steady_state.h>
#include <thermocontact/output/output_tables.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/report/key_results.h>
#include <thermocontact/report/result_report.h>
#include <thermocontact/report/scene_report.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    // More than this of the energy is more than engineers leave to a scheme.
    constexpr double largest_numerical_part = 0.05;



    /** Each of a few contacts that have ended, or the sum of all. */
    std::string
    describe_durations(const std::vector<ContactEvent> &events,
                       const StepRecord                &record,
                       const OutputUnits               &units)
    {
      constexpr unsigned int   few = 5;
      std::vector<std::string> durations;
      for (unsigned int i = 1; i < events.size(); ++i)
        if (events[i].kind == ContactEvent::end)
          durations.push_back(
            units.text("time", events[i].time - events[i - 1].time));
      std::string line;
      if (!durations.empty() && durations.size() <= few)
        for (const std::string &duration : durations)
          line += (line.empty() ? ", for " : ", ") + duration;
      return line + (durations.size() > 1 || record.in_contact ?
                       text(", in contact altogether ",
                            units.text("time",
                                       contact_duration(events,
                                                        record.in_contact,
                                                        record.time))) :
                       "");
    }



    template <int dim>
    std::string
    join_events(const Simulation<dim> &simulation)
    {
      const OutputUnits units(simulation.parameters());
      const auto       &events = simulation.events();
      std::string       line   = text(n_contact_begins(events), " times");
      if (!events.empty())
        line += ", first at t = " + units.text("time", events.front().time) +
                describe_durations(events, simulation.record(), units);
      return line + ", peak force " +
             units.text("force", simulation.history().max_contact_force) +
             ", peak penetration " +
             units.text("length", simulation.history().max_penetration) +
             ", impulse " +
             units.text("force × time", simulation.record().contact_impulse);
    }



    /** Where the scene tends to, and how far it is from there. */
    std::string
    compare_with_rest(const SteadyState &rest,
                      const StepRecord  &record,
                      const Scene       &scene)
    {
      std::string       line = describe_steady_state(rest, scene) + "; differs";
      const OutputUnits units(scene.parameters);
      const char       *comma = " in ";
      const auto        add   = [&](const char  *name,
                           const char  *kind,
                           const double value,
                           const double predicted) {
        if (!std::isfinite(predicted))
          return;
        line +=
          text(comma, name, " by ", units.text(kind, value - predicted, 2));
        comma = ", ";
      };
      add("u(1)", "length", record.displacement_end, rest.displacement_end);
      add("theta(1)",
          "temperature difference",
          record.temperature_end,
          rest.temperature_end);
      if (scene.contact.law->is_active())
        add("force", "force", record.contact_force, rest.contact_force);
      return line;
    }



    /** The audit (M.22) of the whole run. */
    std::string
    describe_energy(const StepRecord  &record,
                    const double       initial_energy,
                    const OutputUnits &units)
    {
      const auto in = [&units](const double       energy,
                               const unsigned int digits = few_digits) {
        return units.text("energy", energy, digits);
      };
      const double defect = initial_energy + record.work + record.algebraic -
                            record.energy - record.dissipation -
                            record.contact_dissipation -
                            record.numerical_dissipation;
      return text(
        in(initial_energy),
        " at first + work ",
        in(record.work),
        " = ",
        in(record.energy),
        " + dissipated ",
        in(record.dissipation),
        record.lateral_dissipation == 0. ?
          "" :
          text(" (", in(record.lateral_dissipation), " to the surroundings)"),
        record.contact_dissipation == 0. ?
          "" :
          text(" + taken by the obstacle ", in(record.contact_dissipation)),
        " + lost to the scheme ",
        in(record.numerical_dissipation),
        record.algebraic == 0. ?
          "" :
          text("; brought in by residuals ", in(record.algebraic, 2)),
        "; defect ",
        in(defect, 2));
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



  template <int dim>
  std::string
  scheme_warning(const Simulation<dim> &simulation)
  {
    const StepRecord &record = simulation.record();
    // at t = 0, by the audit (M.22)
    const double initial_energy =
      record.energy + record.dissipation + record.contact_dissipation +
      record.numerical_dissipation - record.work - record.algebraic;
    const double there =
      std::max(initial_energy, 0.) + std::max(record.work, 0.);
    if (simulation.parameters().time.has_error_control() ||
        !(record.numerical_dissipation > largest_numerical_part * there))
      return "";
    return text("the scheme took ",
                significant(100. * record.numerical_dissipation / there, 2),
                " % of the energy that was there: a smaller Time/Step size, or "
                "automatic");
  }



  template <int dim>
  void
  report_result(const Simulation<dim> &simulation,
                const RunTimes        &times,
                const double           initial_energy,
                Log                   &log)
  {
    const Scene         &scene    = simulation.scene();
    const StepRecord    &record   = simulation.record();
    const SolverCounters counters = simulation.counters();
    if (scene.contact.law->is_active())
      log.line("  contact   " + join_events(simulation));
    log.line("  final     " +
             describe_steady_state(final_state(record), scene));
    const auto rest = steady_state(scene).states;
    if (!rest.empty())
      log.line("  at rest   " +
               compare_with_rest(rest[nearest_state(rest, final_state(record))],
                                 record,
                                 scene));
    log.line("  energy    " + describe_energy(record,
                                              initial_energy,
                                              OutputUnits(scene.parameters)));
    if (const std::string warning = scheme_warning(simulation);
        !warning.empty())
      log.line("  warning:  " + warning);
    log.line(text(
      "  cost      ",
      record.step,
      " steps, ",
      simulation.history().n_rejected_steps,
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



  template <int dim>
  void
  report_errors(const Simulation<dim> &simulation,
                const KeyErrors       &errors,
                Log                   &log)
  {
    const KeyValues   values = key_values(simulation);
    const OutputUnits units(simulation.parameters());
    const auto        in = [&units](const std::string &key,
                             const double       value,
                             const unsigned int digits = few_digits) {
      return units.text(kind_of("summary.json", key), value, digits);
    };
    const auto bar = [&in](const std::string &key, const double error) {
      return std::isnan(error) ? "unknown" : in(key, error, 2);
    };
    for (const std::string &remark : errors.remarks)
      log.line("  warning:  " + remark);
    log.line(text("  errors    by ",
                  errors.n_repeats,
                  " repeats: value, +- in time, +- in space"));
    for (unsigned int k = 0; k < n_key_errors; ++k)
      if (!std::isnan(values[k]))
        {
          const std::string name = key_error_names[k];
          log.line(
            text("            ",
                 align_left(name, 24),
                 align_left(in(name, values[k]), 12),
                 "  +- ",
                 align_left(bar(name + "_time_error", errors.time[k]), 8),
                 "  +- ",
                 bar(name + "_space_error", errors.space[k])));
        }
  }



#define INSTANTIATE(dim)                                             \
  template std::string scheme_warning<dim>(const Simulation<dim> &); \
  template void        report_result<dim>(const Simulation<dim> &,   \
                                   const RunTimes &,          \
                                   const double,              \
                                   Log &);                    \
  template void        report_errors<dim>(const Simulation<dim> &,   \
                                   const KeyErrors &,         \
                                   Log &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
