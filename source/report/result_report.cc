// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/forecast/steady_state.h>
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
    template <int dim>
    std::string
    join_events(const Simulation<dim> &simulation)
    {
      const auto &events = simulation.events();
      std::string line   = text(n_contact_begins(events), " times");
      if (!events.empty())
        line += text(", first at t = ", events.front().time);
      return line + text(", peak force ",
                         simulation.history().max_contact_force,
                         ", peak penetration ",
                         simulation.history().max_penetration);
    }



    /** Where the scene tends to, and how far it is from there. */
    std::string
    compare_with_rest(const SteadyState &rest,
                      const StepRecord  &record,
                      const Scene       &scene)
    {
      std::string line = describe_steady_state(rest, scene) + "; differs";
      const auto  add =
        [&line](const char *name, const double value, const double predicted) {
          if (std::isfinite(predicted))
            line += text(line.back() == 's' ? " in " : ", ",
                         name,
                         " by ",
                         significant(value - predicted, 2));
        };
      add("u(1)", record.displacement_end, rest.displacement_end);
      add("theta(1)", record.temperature_end, rest.temperature_end);
      if (scene.contact.law->is_active())
        add("force", record.contact_force, rest.contact_force);
      return line;
    }



    /** The audit (M.22) of the whole run. */
    std::string
    describe_energy(const StepRecord &record, const double initial_energy)
    {
      const double defect = initial_energy + record.work + record.algebraic -
                            record.energy - record.dissipation -
                            record.contact_dissipation -
                            record.numerical_dissipation;
      return text(
        initial_energy,
        " at first + work ",
        record.work,
        " = ",
        record.energy,
        " + dissipated ",
        record.dissipation,
        record.lateral_dissipation == 0. ?
          "" :
          text(" (", record.lateral_dissipation, " to the surroundings)"),
        record.contact_dissipation == 0. ?
          "" :
          text(" + taken by the obstacle ", record.contact_dissipation),
        " + lost to the scheme ",
        record.numerical_dissipation,
        record.algebraic == 0. ?
          "" :
          text("; brought in by residuals ", significant(record.algebraic, 2)),
        "; defect ",
        significant(defect, 2));
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
        {"whole run", times.wall}};
      const char *title = "time";
      for (const auto &[name, seconds] : sections)
        {
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
      log.line("  contact   " + join_events(simulation) +
               text(", impulse ", record.contact_impulse));
    log.line("  final     " +
             describe_steady_state(final_state(record), scene));
    const auto rest = steady_state(scene).states;
    if (!rest.empty())
      log.line("  at rest   " +
               compare_with_rest(rest[nearest_state(rest, final_state(record))],
                                 record,
                                 scene));
    log.line("  energy    " + describe_energy(record, initial_energy));
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



#define INSTANTIATE(dim)                                    \
  template void report_result<dim>(const Simulation<dim> &, \
                                   const RunTimes &,        \
                                   const double,            \
                                   Log &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
