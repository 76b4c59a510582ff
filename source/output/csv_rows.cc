// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/csv_rows.h>

#include <limits>

namespace ThermoContact
{
  CsvColumns<StepRecord>
  contact_columns(const Scene &scene)
  {
    CsvColumns<StepRecord> columns = {
      {"step", &StepRecord::step},
      {"time", &StepRecord::time},
      {"step_size", &StepRecord::step_size},
      {"displacement_end", &StepRecord::displacement_end},
      {"displacement_mid", &StepRecord::displacement_mid},
      {"velocity_end", &StepRecord::velocity_end},
      {"stress_end", &StepRecord::stress_end},
      {"gap", &StepRecord::gap},
      {"penetration", &StepRecord::penetration},
      {"contact_force", &StepRecord::contact_force},
      {"contact_impulse", &StepRecord::contact_impulse},
      {"temperature_end", &StepRecord::temperature_end},
      {"heat_flux_end", &StepRecord::heat_flux_end},
      {"energy", &StepRecord::energy},
      {"dissipation", &StepRecord::dissipation},
      {"numerical_dissipation", &StepRecord::numerical_dissipation},
      {"in_contact", &StepRecord::in_contact},
      {"iterations", &StepRecord::iterations},
      {"work", &StepRecord::work},
      {"temperature_mean", &StepRecord::temperature_mean}};
    if (scene.parameters.dimension > 1)
      for (const auto &[name, member] :
           {std::pair("contact_area", &FaceRecord::contact_area),
            std::pair("max_pressure", &FaceRecord::max_pressure),
            std::pair("min_gap", &FaceRecord::min_gap),
            std::pair("moment_y", &FaceRecord::moment_y),
            std::pair("moment_z", &FaceRecord::moment_z)})
        columns.emplace_back(name, [member = member](const StepRecord &record) {
          return record.face.*member;
        });
    if (scene.linear_solver.is_iterative)
      columns.emplace_back("algebraic", &StepRecord::algebraic);
    if (scene.contact.law->damping() > 0.)
      columns.emplace_back("contact_dissipation",
                           &StepRecord::contact_dissipation);
    if (scene.heat.has_lateral_exchange())
      {
        columns.emplace_back("lateral_heat_flux",
                             &StepRecord::lateral_heat_flux);
        columns.emplace_back("lateral_dissipation",
                             &StepRecord::lateral_dissipation);
      }
    return columns;
  }



  EventRow::EventRow(const ContactEvent &event, const ContactEvent *const begin)
    : ContactEvent(event)
    , duration(event.kind == ContactEvent::end && begin != nullptr ?
                 event.time - begin->time :
                 std::numeric_limits<double>::quiet_NaN())
  {}



  CsvColumns<EventRow>
  event_columns(const bool has_sides)
  {
    CsvColumns<EventRow> columns = {{"time", &ContactEvent::time},
                                    {"kind",
                                     [](const ContactEvent &event) {
                                       return event.kind ==
                                                  ContactEvent::begin ?
                                                "begin" :
                                                "end";
                                     }},
                                    {"velocity", &ContactEvent::velocity},
                                    {"duration", &EventRow::duration}};
    if (has_sides)
      columns.emplace_back("side", [](const ContactEvent &event) {
        return event.side > 0 ? "front" : "rear";
      });
    return columns;
  }



  CsvColumns<StepAttempt>
  attempt_columns()
  {
    return {{"time", &StepAttempt::time},
            {"step_size", &StepAttempt::size},
            {"error", &StepAttempt::error, few_digits},
            {"accepted", &StepAttempt::is_accepted},
            {"reason", &StepAttempt::reason},
            {"wall_seconds", &StepAttempt::wall_seconds, few_digits}};
  }
} // namespace ThermoContact
