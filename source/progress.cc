// SPDX-License-Identifier: LGPL-2.1-or-later

#include "progress.h"

#include <iomanip>

#include "text.h"

namespace ThermoContact
{
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



#define INSTANTIATE(dim) \
  template void report_progress<dim>(const Simulation<dim> &, Log &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
