// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/report/progress.h>

namespace ThermoContact
{
  namespace
  {
    double
    seconds_between(const std::chrono::steady_clock::time_point from,
                    const std::chrono::steady_clock::time_point to)
    {
      return std::chrono::duration<double>(to - from).count();
    }



    /** The energy that the audit started from, by the audit. */
    double
    energy_at_first(const StepRecord &record)
    {
      return record.energy + record.dissipation + record.contact_dissipation +
             record.numerical_dissipation - record.work - record.algebraic;
    }
  } // namespace



  template <int dim>
  Progress<dim>::Progress(const Simulation<dim> &simulation, Log &log)
    : log(log)
    , units(simulation.parameters())
    , start(Clock::now())
    , start_time(simulation.record().time)
    , initial_energy_(energy_at_first(simulation.record()))
    , last_update(start)
    , last_step(simulation.record().step)
    , steps_per_second(0.)
    , step_seconds_(0.)
  {}



  template <int dim>
  void
  Progress<dim>::observe(const Simulation<dim> &simulation)
  {
    if (simulation.history().attempts.empty())
      return; // the initial state
    for (const StepAttempt &attempt : simulation.history().attempts)
      step_seconds_ += attempt.wall_seconds;
    report_tenth(simulation);
    if (log.has_live_line())
      update_live_line(simulation);
  }



  template <int dim>
  void
  Progress<dim>::report_tenth(const Simulation<dim> &simulation)
  {
    const StepRecord &record   = simulation.record();
    const double      end_time = simulation.parameters().time.end_time;
    const auto        tenths   = [end_time](const double time) {
      return static_cast<unsigned int>(10. * time / end_time + 1e-9);
    };
    if (tenths(record.time) == tenths(record.time - record.step_size))
      return;
    std::string line = text("  ",
                            align_right(text(10 * tenths(record.time)), 3),
                            " %   t = ",
                            align_left(units.text("time", record.time), 10));
    const auto  add  = [&](const char  *name,
                         const char  *kind,
                         const double value) {
      line += text("  ", name, " = ", align_left(units.text(kind, value), 12));
    };
    const Scene &scene = simulation.scene();
    if (scene.fields.has_displacement)
      add("u(1)", "length", record.displacement_end);
    if (scene.contact.law->is_active())
      {
        add("gap", "length", record.gap);
        add("force", "force", record.contact_force);
      }
    if (scene.fields.has_temperature)
      add("theta(1)", "temperature", record.temperature_end);
    line.erase(line.find_last_not_of(' ') + 1);
    if (log.has_live_line())
      log.file_line(line);
    else
      log.line(line);
  }



  template <int dim>
  void
  Progress<dim>::update_live_line(const Simulation<dim> &simulation)
  {
    const auto   now     = Clock::now();
    const double seconds = seconds_between(last_update, now);
    if (seconds < 0.1)
      return;
    const StepRecord &record   = simulation.record();
    const Scene      &scene    = simulation.scene();
    const double      end_time = scene.parameters.time.end_time;
    const double      rate     = (record.step - last_step) / seconds;
    steps_per_second =
      steps_per_second == 0. ? rate : 0.7 * steps_per_second + 0.3 * rate;
    last_update = now;
    last_step   = record.step;

    const double done = record.time - start_time;
    const double left =
      seconds_between(start, now) * (end_time - record.time) / done;
    const auto field =
      [this](const char *name, const char *kind, const double value) {
        return text("  ", name, ' ', align_left(units.text(kind, value), 12));
      };
    const auto percent =
      static_cast<unsigned int>(100. * record.time / end_time + 1e-9);
    std::string line = text("  ", align_right(text(percent), 3), " %") +
                       field(" t", "time", record.time) +
                       field("dt", "time", record.step_size);
    if (scene.contact.law->is_active())
      line += record.in_contact ?
                field("force", "force", record.contact_force) :
                field("gap  ", "length", record.gap);
    else if (scene.fields.has_displacement)
      line += field("u(1)", "length", record.displacement_end);
    else
      line += field("theta(1)", "temperature", record.temperature_end);
    const std::string speed = steps_per_second < 10. ?
                                significant(steps_per_second, 2) :
                                fixed_point(steps_per_second, 0);
    log.live_line(line + align_right(speed, 8) + " steps/s  " +
                  clock_time(left) + " left");
  }



  template class Progress<1>;
  template class Progress<2>;
  template class Progress<3>;
} // namespace ThermoContact
