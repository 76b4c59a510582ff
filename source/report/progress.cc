// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/multiples.h>
#include <thermocontact/base/text.h>
#include <thermocontact/report/key_results.h>
#include <thermocontact/report/progress.h>
#include <thermocontact/report/scene_report.h>

namespace ThermoContact
{
  namespace
  {
    /** Seconds; less is not worth a word in the log. */
    constexpr double shortest_time_left = 60.;



    double
    seconds_between(const std::chrono::steady_clock::time_point from,
                    const std::chrono::steady_clock::time_point to)
    {
      return std::chrono::duration<double>(to - from).count();
    }
  } // namespace



  Progress::Progress(const Scene &scene, const RunHistory &history, Log &log)
    : scene(scene)
    , log(log)
    , units(scene.parameters)
    , start(Clock::now())
    , first(history.record)
    , last_update(start)
  {}



  void
  Progress::observe(const RunHistory &history)
  {
    if (history.attempts.empty())
      return; // the initial state
    report_tenth(history.record);
    update_live_line(history.record);
  }



  double
  Progress::seconds_left(const StepRecord &record) const
  {
    return seconds_between(start, Clock::now()) *
           (scene.parameters.time.end_time - record.time) /
           (record.time - first.time);
  }



  void
  Progress::report_tenth(const StepRecord &record)
  {
    const double tenth = 0.1 * scene.parameters.time.end_time;
    const double n     = whole_intervals(tenth, record.time);
    if (n == whole_intervals(tenth, record.time - record.step_size))
      return;
    std::string line = text("  ",
                            align_right(text(10. * n), 3),
                            " %   t = ",
                            align_left(units.text("time", record.time), 10));
    const auto  add  = [&](const std::string &name,
                         const char        *kind,
                         const double       value) {
      line += text("  ", name, " = ", align_left(units.text(kind, value), 12));
    };
    if (scene.fields.has_displacement)
      add(at_end("u", scene), "length", shown_displacement(record));
    if (scene.contact.law->is_active())
      {
        add("gap", "length", shown_gap(record));
        add("force", "force", record.contact_force);
      }
    if (scene.fields.has_temperature)
      add(at_end("theta", scene), "temperature", record.temperature_end);
    line.erase(line.find_last_not_of(' ') + 1);
    if (const double left = seconds_left(record); left > shortest_time_left)
      line += "  " + clock_time(left) + " left";
    log.milestone(line);
  }



  void
  Progress::update_live_line(const StepRecord &record)
  {
    const auto now = Clock::now();
    if (seconds_between(last_update, now) < 0.1)
      return;
    last_update = now;
    const double steps_per_second =
      (record.step - first.step) / seconds_between(start, now);
    const double end_time = scene.parameters.time.end_time;

    const auto field =
      [this](const std::string &name, const char *kind, const double value) {
        return text("  ", name, ' ', align_left(units.text(kind, value), 12));
      };
    const double percent = whole_intervals(0.01 * end_time, record.time);
    std::string  line    = text("  ", align_right(text(percent), 3), " %") +
                       field(" t", "time", record.time) +
                       field("dt", "time", record.step_size);
    if (scene.contact.law->is_active())
      line += record.in_contact ?
                field("force", "force", record.contact_force) :
                field("gap  ", "length", shown_gap(record));
    else if (scene.fields.has_displacement)
      line += field(at_end("u", scene), "length", shown_displacement(record));
    else
      line +=
        field(at_end("theta", scene), "temperature", record.temperature_end);
    const std::string speed = steps_per_second < 10. ?
                                significant(steps_per_second, 2) :
                                fixed_point(steps_per_second, 0);
    log.live_line(line + align_right(speed, 8) + " steps/s  " +
                  clock_time(seconds_left(record)) + " left");
  }
} // namespace ThermoContact
