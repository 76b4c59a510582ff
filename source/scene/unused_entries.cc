// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/scene/scene_checks.h>

#include <algorithm>
#include <set>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    using Paths = std::vector<std::string>;

    /** Collects entries with the reason why they are not used. */
    class Collector
    {
    public:
      std::vector<UnusedEntry> entries;

      void
      add_if(const bool         condition,
             const Paths       &paths,
             const std::string &reason)
      {
        if (condition)
          for (const std::string &path : paths)
            entries.push_back({path, reason});
      }
    };



    /** Entries of a field or a term that the scene does not have. */
    void
    add_by_model(const Scene &scene, Collector &unused)
    {
      const ModelParameters &model  = scene.parameters.model;
      const std::string      fields = "Model/Fields = " + model.fields;
      for (const DeclaredEntry &entry : entries_of_program())
        unused.add_if(!scene.fields.has_displacement &&
                        begins_with(entry.path, "Contact/"),
                      {entry.path},
                      fields);
      unused.add_if(!scene.fields.has_displacement,
                    {"Model/Inertia",
                     "Model/Viscosity",
                     "Model/Coupling",
                     "Model/Thermoelastic heating",
                     "Model/Poisson ratio",
                     "Boundary/sides/Support",
                     "Boundary/left/Support",
                     "Boundary/left/Displacement",
                     "Initial values/Displacement",
                     "Initial values/Velocity",
                     "Sources/Body force",
                     "Boundary/left/Traction",
                     "Boundary/left/Spring",
                     "Boundary/left/Dashpot",
                     "Boundary/left/Mass",
                     "Boundary/right/Support",
                     "Boundary/right/Traction",
                     "Boundary/right/Spring",
                     "Boundary/right/Dashpot",
                     "Boundary/right/Mass",
                     "Time/Start",
                     "Time/Locate contact events"},
                    fields);
      unused.add_if(!scene.fields.has_temperature,
                    {"Model/Coupling",
                     "Model/Thermoelastic heating",
                     "Boundary/left/Temperature",
                     "Boundary/left/Heat exchange",
                     "Boundary/left/Surroundings",
                     "Boundary/left/Heat flux",
                     "Boundary/right/Heat exchange",
                     "Boundary/right/Surroundings",
                     "Boundary/sides/Heat exchange",
                     "Boundary/sides/Surroundings",
                     "Initial values/Temperature",
                     "Sources/Heat source",
                     "Boundary/right/Temperature",
                     "Boundary/right/Heat flux"},
                    fields);
      unused.add_if(model.coupling == 0.,
                    {"Model/Thermoelastic heating"},
                    "Model/Coupling = 0");
      unused.add_if(!scene.material.has_inertia() &&
                      !scene.fields.has_temperature,
                    {"Mesh/Mass matrix"},
                    "Model/Inertia = 0");
      unused.add_if(!scene.fields.has_displacement,
                    {"Study/Target error"},
                    fields);
      unused.add_if(!scene.material.has_inertia(),
                    {"Initial values/Velocity", "Contact/Massless nodes"},
                    "Model/Inertia = 0");
      unused.add_if(scene.material.is_static(),
                    {"Initial values/Displacement"},
                    "Model/Inertia = 0 and Viscosity = 0");
    }



    /** Entries that bodies of a row do not have. */
    void
    add_by_row(const Scene &scene, Collector &unused)
    {
      const Parameters    &parameters = scene.parameters;
      const RowParameters &row        = parameters.row;
      unused.add_if(parameters.has_row(),
                    {"Initial values/Temperature",
                     "Initial values/Displacement",
                     "Initial values/Velocity"},
                    "Bodies = a row, which has them");
      unused.add_if(parameters.has_row() && !scene.scheme_choice.shares_cells,
                    {"Mesh/Cells", "Mesh/Refinements"},
                    "Bodies/NAME/Cells = a number for each rod");
      const std::string fields = "Model/Fields = " + parameters.model.fields;
      for (const PairParameters &pair : row.pairs)
        {
          const std::string section = "Contacts/" + pair.name + "/";
          std::vector<std::pair<std::string, bool>> of_fields = {
            {"Gap", scene.fields.has_displacement},
            {"Heat exchange", scene.fields.has_temperature},
            {"Stiffness", scene.fields.has_displacement}};
          if (pair.has_own_kind())
            of_fields.emplace_back("Condition", scene.fields.has_displacement);
          for (const auto &[name, value] : pair.own_law.numbers)
            of_fields.emplace_back(name, scene.fields.has_displacement);
          for (const auto &[name, has_field] : of_fields)
            {
              unused.add_if(pair.is_bonded(),
                            {section + name},
                            section + "Condition = bonded");
              unused.add_if(!has_field, {section + name}, fields);
            }
        }
      for (const BodyParameters &body : row.bodies)
        {
          const std::string section = "Bodies/" + body.name + "/";
          const auto        add     = [&](const bool         is_unused,
                               const Paths       &names,
                               const std::string &reason) {
            for (const std::string &name : names)
              unused.add_if(is_unused, {section + name}, reason);
          };
          const Material &material = scene.material;
          add(!scene.fields.has_displacement,
              {"Stiffness",
               "Poisson ratio",
               "Density",
               "Viscosity",
               "Coupling",
               "Mass",
               "Displacement",
               "Velocity"},
              fields);
          add(!scene.fields.has_temperature,
              {"Coupling", "Conductivity", "Heat capacity", "Temperature"},
              fields);
          // in SI the program leaves small terms out
          const bool is_in_si = parameters.rod.is_given();
          add(!material.has_viscosity() && !is_in_si,
              {"Viscosity"},
              "Model/Viscosity = 0");
          if (&body == parameters.obstacle_mass())
            unused.add_if(scene.fields.has_temperature,
                          {"Boundary/right/Surroundings"},
                          section + "Kind = mass");
          add(parameters.model.coupling == 0.,
              {"Coupling"},
              "Model/Coupling = 0");
          add(!material.has_inertia(), {"Velocity"}, "Model/Inertia = 0");
          add(!material.has_inertia() && !scene.sources.has_body_force &&
                !is_in_si,
              {"Density"},
              "Model/Inertia = 0");
          add(parameters.dimension == 1, {"Poisson ratio"}, "Dimension = 1");
          add(material.is_static(),
              {"Displacement"},
              "Model/Inertia = 0 and Viscosity = 0");
          add(body.is_mass(),
              {"Length",
               "Cells",
               "Section",
               "Stiffness",
               "Poisson ratio",
               "Density",
               "Viscosity",
               "Coupling",
               "Conductivity"},
              section + "Kind = mass");
          add(!body.is_mass(), {"Mass"}, section + "Kind = rod");
        }
    }



    /** The entries that contact laws use, but not the law of their contact. */
    void
    add_by_laws(const Scene          &scene,
                const ContactLawKind &general,
                Collector            &unused)
    {
      const Parameters &parameters = scene.parameters;
      const std::string condition  = "Contact/Condition = " + general.name;
      const auto add = [&](const std::string &name, const std::string &entry) {
        // which contacts have it, and which of these from section Contact
        const std::string path = "Contact/" + entry;
        bool is_used           = (parameters.boundary.right.meets_obstacle() ||
                        scene.row.contacts.empty()) &&
                       general.uses(name);
        bool is_taken = is_used;
        for (const RowContact &contact : scene.row.contacts)
          {
            const auto *const pair = parameters.row.find_pair(contact.name);
            if (!(pair != nullptr ? pair->law_kind(general) : general)
                   .uses(name))
              continue;
            is_used = true;
            is_taken =
              is_taken || !(pair != nullptr && pair->own_law.has_number(name));
          }
        unused.add_if(!is_taken,
                      {path},
                      is_used ? "each of Contacts = a number of its own" :
                                condition);
        unused.add_if(!general.uses(name),
                      {parameters.contact.own_rear_law.path(entry)},
                      condition);
        for (const PairParameters &pair : parameters.row.pairs)
          unused.add_if(!pair.law_kind(general).uses(name),
                        {pair.own_law.path(entry)},
                        pair.has_own_kind() ?
                          "Contacts/" + pair.name +
                            "/Condition = " + pair.condition :
                          condition);
      };
      add("Compliance", "Stiffness");
      for (const ContactLawEntry &entry : contact_law_entries())
        add(entry.name, entry.name);
    }



    /** A reason, in a file in SI units by what it has for a coefficient. */
    std::string
    in_entries_of_file(const std::string &reason, const Scene &scene)
    {
      const RodParameters &rod = scene.parameters.rod;
      if (rod.is_given() && begins_with(reason, "Model/Inertia = 0"))
        return "Rod/Small terms = " + rod.small_terms;
      if (rod.is_given() && reason == "Model/Coupling = 0")
        return "Rod/Linear expansion = 0";
      return reason;
    }



    Paths
    entries_of_law(const ContactLawKind &law, const OwnLaw &own)
    {
      Paths paths{own.path("Stiffness")};
      for (const ContactLawEntry &entry : law.entries)
        paths.push_back(own.path(entry.name));
      return paths;
    }
  } // namespace



  std::vector<UnusedEntry>
  unused_entries(const Scene &scene)
  {
    const Parameters &parameters = scene.parameters;
    Collector         unused;
    add_by_model(scene, unused);
    unused.add_if(parameters.dimension == 1,
                  {"Model/Poisson ratio",
                   "Boundary/sides/Support",
                   "Mesh/Width",
                   "Mesh/Cells across",
                   "Mesh/Grading across"},
                  "Dimension = 1");
    const std::string &sides = parameters.rod.lateral_sides;
    unused.add_if(parameters.dimension == 1 && sides != "confined",
                  {"Rod/Poisson ratio"},
                  "Rod/Lateral sides = " + sides);
    unused.add_if(parameters.dimension == 1 && scene.has_sliding_end,
                  {"Boundary/left/Support"},
                  "Dimension = 1");
    add_by_row(scene, unused);
    const BoundaryParameters::Left &left = parameters.boundary.left;
    unused.add_if(!scene.has_free_end,
                  {"Boundary/left/Traction",
                   "Boundary/left/Spring",
                   "Boundary/left/Dashpot",
                   "Boundary/left/Mass"},
                  "Boundary/left/Support = " + left.support);
    unused.add_if(scene.has_free_end,
                  {"Boundary/left/Displacement"},
                  "Boundary/left/Support = free");
    unused.add_if(scene.heat.has_given_temperature,
                  {"Boundary/left/Heat exchange",
                   "Boundary/left/Surroundings",
                   "Boundary/left/Heat flux"},
                  "Boundary/left/Temperature = " +
                    (left.temperature_expression.empty() ?
                       text(left.temperature) :
                       left.temperature_expression));
    unused.add_if(parameters.dimension > 1,
                  {"Rod/Lateral sides"},
                  "Dimension = " + std::to_string(parameters.dimension));
    unused.add_if(parameters.dimension != 2,
                  {"Mesh/Geometry"},
                  "Dimension = " + std::to_string(parameters.dimension));
    const ContactLawKind &law       = contact_law(parameters.contact.condition);
    const std::string     condition = "Contact/Condition = " + law.name;
    add_by_laws(scene, law, unused);
    const std::vector<RowContact> &contacts = scene.row.contacts;
    unused.add_if(!parameters.boundary.right.meets_obstacle() &&
                    !contacts.empty() &&
                    std::all_of(contacts.begin(),
                                contacts.end(),
                                [&](const RowContact &contact) {
                                  const PairParameters *const pair =
                                    parameters.row.find_pair(contact.name);
                                  return pair != nullptr && pair->gap;
                                }),
                  {"Contact/Gap"},
                  "each of Contacts = a number of its own");
    unused.add_if(!parameters.uses_general_law(),
                  {"Contact/Condition"},
                  "each of Contacts = a Condition of its own");
    unused.add_if(!law.make(parameters.contact.law)->is_active(),
                  {"Contact/Gap",
                   "Contact/Rear gap",
                   "Contact/Massless nodes",
                   "Time/Locate contact events"},
                  condition);
    unused.add_if(!parameters.contact.rear_gap,
                  entries_of_law(law, parameters.contact.own_rear_law),
                  "Contact/Rear gap = none");
    const BoundaryParameters::Right &right = parameters.boundary.right;
    const std::string                given =
      "Boundary/right/Temperature = " + text(right.temperature.value_or(0.));
    unused.add_if(!scene.heat.has_exchange() && !right.temperature,
                  {"Boundary/right/Surroundings"},
                  "Boundary/right/Heat exchange = 0");
    unused.add_if(right.temperature.has_value(),
                  {"Boundary/right/Surroundings", "Boundary/right/Heat flux"},
                  given);
    unused.add_if(right.temperature && !parameters.has_row(),
                  {"Boundary/right/Heat exchange"},
                  given);
    const std::string support = "Boundary/right/Support = " + right.support;
    unused.add_if(right.is_clamped(),
                  {"Boundary/right/Traction",
                   "Boundary/right/Spring",
                   "Boundary/right/Dashpot",
                   "Boundary/right/Mass"},
                  support);
    unused.add_if(!right.meets_obstacle(), {"Contact/Rear gap"}, support);
    unused.add_if(!right.meets_obstacle() && !parameters.has_row(),
                  {"Contact/Gap",
                   "Contact/Massless nodes",
                   "Time/Locate contact events"},
                  support);
    unused.add_if(!scene.heat.has_lateral_exchange(),
                  {"Boundary/sides/Surroundings"},
                  "Boundary/sides/Heat exchange = 0");
    const bool        has_fixed_steps = !parameters.time.has_error_control();
    const bool        is_box          = scene.scheme.has_no_dispersion;
    const std::string steps = is_box ? "Time/Scheme = " + scene.scheme.name :
                                       "Time/Step size = a number";
    unused.add_if(has_fixed_steps,
                  {"Time/First step size",
                   "Time/Minimum step size",
                   "Time/Maximum step size"},
                  steps);
    // it decides on automatic cells, which used.prm has as a number
    unused.add_if(has_fixed_steps && !is_box, {"Time/Tolerance"}, steps);
    const OutputParameters &output = parameters.output;
    unused.add_if(output.fields_interval == 0. &&
                    output.contact_interval == 0. &&
                    output.space_time_interval == 0.,
                  {"Output/Land on output times"},
                  "Output/Contact interval = 0 and no other interval is set");
    unused.add_if(output.fields_interval == 0.,
                  {"Output/Fields cells"},
                  "Output/Fields interval = 0");
    unused.add_if(parameters.dimension == 1,
                  {"Output/Fields cells"},
                  "Dimension = 1");
    unused.add_if(!parameters.study.is_active(),
                  {"Study/Reference",
                   "Study/Repetitions",
                   "Study/Target error",
                   "Study/Keep files"},
                  "Study/Vary = (empty)");
    unused.add_if(!parameters.scales.is_given(),
                  {"Output/SI", "Scales/Time unit", "Scales/Temperature unit"},
                  "Scales/Length = none");
    unused.add_if(!scene.is_fixed_point,
                  {"Solver/Fixed point tolerance",
                   "Solver/Fixed point iterations"},
                  "Solver/Step solver = monolithic");
    unused.add_if(!scene.linear_solver.is_iterative,
                  {"Solver/Linear tolerance"},
                  "Solver/Linear solver = direct");
    unused.add_if(scene.is_fixed_point,
                  {"Solver/Linear tolerance"},
                  "Solver/Step solver = fixed point");
    return unused.entries;
  }



  std::set<std::string>
  unused_paths(const Scene &scene)
  {
    std::set<std::string> paths;
    for (const UnusedEntry &unused : unused_entries(scene))
      paths.insert(unused.path);
    return paths;
  }



  void
  check_unused_entries(const Scene                   &scene,
                       const std::vector<Assignment> &assignments,
                       const ParameterHandler        &prm)
  {
    const std::vector<DeclaredEntry> entries = declared_entries(prm);
    std::vector<std::string>         faults;
    std::set<std::string>            told; // one reason is enough
    // section Rod sets entries that the file does not have
    const auto is_derived = [&](const std::string &path) {
      return scene.parameters.rod.is_given() &&
             last_assignment(assignments, path) == nullptr;
    };
    for (const UnusedEntry &unused : unused_entries(scene))
      for (const DeclaredEntry &entry : entries)
        if (entry.path == unused.path && !is_derived(entry.path) &&
            !equal_values(entry.value, entry.default_value) &&
            told.insert(entry.path).second)
          {
            const std::string reason = in_entries_of_file(unused.reason, scene);
            faults.push_back(
              complete_message(entry.path + " = " + quote(entry.value) +
                                 " has no effect, since " + reason +
                                 "\n  remedy:  remove the entry or change " +
                                 reason.substr(0, reason.find(" =")),
                               assignments,
                               prm));
          }
    throw_faults(faults);
  }
} // namespace ThermoContact
