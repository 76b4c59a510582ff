// SPDX-License-Identifier: LGPL-2.1-or-later

#include "result_report.h"

#include "summary.h"
#include "text.h"

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



#define INSTANTIATE(dim)                                    \
  template void report_result<dim>(const Simulation<dim> &, \
                                   const RunTimes &,        \
                                   Log &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
