// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/csv_rows.h>

#include <array>

namespace ThermoContact
{
  namespace
  {
    CsvColumns<StepRecord>
    make_contact_columns(const bool has_face,
                         const bool is_iterative,
                         const bool is_damped)
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
      if (has_face)
        for (const auto &[name, member] :
             {std::pair("contact_area", &FaceRecord::contact_area),
              std::pair("max_pressure", &FaceRecord::max_pressure),
              std::pair("min_gap", &FaceRecord::min_gap),
              std::pair("moment_y", &FaceRecord::moment_y),
              std::pair("moment_z", &FaceRecord::moment_z)})
          columns.emplace_back(name,
                               [member = member](const StepRecord &record) {
                                 return record.face.*member;
                               });
      if (is_iterative)
        columns.emplace_back("algebraic", &StepRecord::algebraic);
      if (is_damped)
        columns.emplace_back("contact_dissipation",
                             &StepRecord::contact_dissipation);
      return columns;
    }
  } // namespace



  const CsvColumns<StepRecord> &
  contact_columns(const unsigned int dim,
                  const bool         is_iterative,
                  const bool         is_damped)
  {
    static const auto tables = [] {
      std::array<CsvColumns<StepRecord>, 8> all;
      for (unsigned int i = 0; i < all.size(); ++i)
        all[i] = make_contact_columns(i & 1, i & 2, i & 4);
      return all;
    }();
    return tables[(dim > 1 ? 1 : 0) + (is_iterative ? 2 : 0) +
                  (is_damped ? 4 : 0)];
  }



  const CsvColumns<ContactEvent> &
  event_columns(const bool has_sides)
  {
    static const CsvColumns<ContactEvent> columns = {
      {"time", &ContactEvent::time},
      {"kind",
       [](const ContactEvent &event) {
         return event.kind == ContactEvent::begin ? "begin" : "end";
       }},
      {"velocity", &ContactEvent::velocity}};
    static const CsvColumns<ContactEvent> with_sides = [] {
      CsvColumns<ContactEvent> all = columns;
      all.emplace_back("side", [](const ContactEvent &event) {
        return event.side > 0 ? "front" : "rear";
      });
      return all;
    }();
    return has_sides ? with_sides : columns;
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
