// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/output/csv_rows.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/space/point_values.h>


namespace ThermoContact
{
  CsvColumns<StepRecord>
  contact_columns(const Scene &scene)
  {
    CsvColumns<StepRecord> columns;
    StepRecord::for_each_column([&](const char *name,
                                    const auto  member,
                                    bool (*is_there)(const Scene &) = nullptr) {
      if (is_there == nullptr || is_there(scene))
        columns.emplace_back(name, member);
    });
    return columns;
  }



  CsvColumns<EventRow>
  event_columns(const Scene &scene)
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
    if (scene.contact.is_two_sided())
      columns.emplace_back("side", [](const ContactEvent &event) {
        return event.side > 0 ? "front" : "rear";
      });
    if (scene.row.is_given())
      columns.emplace_back("contact",
                           [names = scene.row.contact_names()](
                             const ContactEvent &event) -> std::string {
                             return names[event.contact];
                           });
    return columns;
  }



  CsvColumns<ContactRecord>
  columns_of_row_contact()
  {
    using R = ContactRecord;
    return {{"time", &R::time},
            {"gap", &R::gap},
            {"velocity", &R::velocity},
            {"contact_force", &R::contact_force},
            {"contact_impulse", &R::contact_impulse},
            {"heat_flux", &R::heat_flux},
            {"in_contact", &R::in_contact}};
  }



  CsvColumns<StepRecord>
  boundary_columns(const Scene &scene)
  {
    CsvColumns<StepRecord> columns = {{"time", &StepRecord::time}};
    BoundarySums::for_each_column(
      [&](const std::string &name, const auto member) {
        const bool is_heat = begins_with(name, "heat");
        if (!(is_heat ? scene.fields.has_temperature :
                        scene.fields.has_displacement) ||
            (name == "heat_sides" && !scene.heat.has_lateral_exchange()))
          return;
        columns.emplace_back(name, [member](const StepRecord &record) {
          return record.boundaries.*member;
        });
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



  CsvColumns<ProbeRow>
  probe_columns(const unsigned int n_places)
  {
    const auto          &names   = PointValues<1>::names;
    CsvColumns<ProbeRow> columns = {{"time", &ProbeRow::time}};
    for (unsigned int i = 0; i < n_places; ++i)
      for (unsigned int q = 0; q < names.size(); ++q)
        columns.emplace_back(text(names[q], '_', i + 1),
                             [k = q * n_places + i](const ProbeRow &row) {
                               return row.values[k];
                             });
    return columns;
  }



  std::string
  probe_comments(const Parameters &parameters)
  {
    std::string       lines;
    unsigned int      n = 0;
    const OutputUnits units(parameters);
    const Conversion &length = units.of("position");
    for (const auto &position : parameters.probe_positions())
      {
        std::vector<std::string> words;
        for (unsigned int d = 0; d < parameters.dimension; ++d)
          words.push_back(std::string(1, "xyz"[d]) + " = " +
                          significant(length(position[d]), all_digits) +
                          (length.unit.empty() ? "" : " " + length.unit));
        lines += text("# probe ", ++n, ": ", join_words(words), '\n');
      }
    return lines;
  }
} // namespace ThermoContact
