// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/csv_rows.h>

#include <limits>

namespace ThermoContact
{
  const CsvColumns<StepRecord> &
  contact_columns(const unsigned int dim, const bool is_iterative)
  {
    static const CsvColumns<StepRecord> of_rod = {
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
    static const CsvColumns<StepRecord> of_face = [] {
      CsvColumns<StepRecord> columns = of_rod;
      for (const auto &[name, member] :
           {std::pair("contact_area", &FaceRecord::contact_area),
            std::pair("max_pressure", &FaceRecord::max_pressure),
            std::pair("min_gap", &FaceRecord::min_gap),
            std::pair("moment_y", &FaceRecord::moment_y),
            std::pair("moment_z", &FaceRecord::moment_z)})
        columns.emplace_back(name, [member = member](const StepRecord &record) {
          return record.face.*member;
        });
      return columns;
    }();
    static const CsvColumns<StepRecord> of_iterative = [] {
      CsvColumns<StepRecord> columns = of_face;
      columns.emplace_back("algebraic", &StepRecord::algebraic);
      return columns;
    }();
    return dim == 1 ? of_rod : is_iterative ? of_iterative : of_face;
  }



  EventRow::EventRow(const ContactEvent &event, const ContactEvent *const begin)
    : ContactEvent(event)
    , duration(event.kind == ContactEvent::end && begin != nullptr ?
                 event.time - begin->time :
                 std::numeric_limits<double>::quiet_NaN())
  {}



  const CsvColumns<EventRow> &
  event_columns()
  {
    static const CsvColumns<EventRow> columns = {
      {"time", &ContactEvent::time},
      {"kind",
       [](const ContactEvent &event) {
         return event.kind == ContactEvent::begin ? "begin" : "end";
       }},
      {"velocity", &ContactEvent::velocity},
      {"duration", &EventRow::duration}};
    return columns;
  }



  const CsvColumns<StepAttempt> &
  attempt_columns()
  {
    static const CsvColumns<StepAttempt> columns = {
      {"time", &StepAttempt::time},
      {"step_size", &StepAttempt::size},
      {"error", &StepAttempt::error, few_digits},
      {"accepted", &StepAttempt::is_accepted},
      {"reason", &StepAttempt::reason},
      {"wall_seconds", &StepAttempt::wall_seconds, few_digits}};
    return columns;
  }
} // namespace ThermoContact
