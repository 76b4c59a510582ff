// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/csv_rows.h>

namespace ThermoContact
{
  template <>
  const CsvColumns<StepRecord> &
  columns_of<StepRecord>()
  {
    static const CsvColumns<StepRecord> columns = {
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
    return columns;
  }



  template <>
  const CsvColumns<ContactEvent> &
  columns_of<ContactEvent>()
  {
    static const CsvColumns<ContactEvent> columns = {
      {"time", &ContactEvent::time},
      {"kind",
       [](const ContactEvent &event) {
         return event.kind == ContactEvent::begin ? "begin" : "end";
       }},
      {"velocity", &ContactEvent::velocity}};
    return columns;
  }



  template <>
  const CsvColumns<StepAttempt> &
  columns_of<StepAttempt>()
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
