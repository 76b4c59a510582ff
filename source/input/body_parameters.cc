// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/body_parameters.h>
#include <thermocontact/input/section_of_entries.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    using namespace dealii::Patterns;

    const std::string bodies_section = "Bodies", pairs_section = "Contacts";

    /** Names in the sections that are declared for bodies of any name. */
    const std::string any_body = "NAME", any_pair = "LEFT RIGHT";

    const Double positive(1e-15, 1e15), not_negative(0., 1e15);



    /** "bar" of "Bodies/bar/Length" or "Bodies/bar/"; empty: there is none. */
    std::string
    name_within(const std::string &section, const std::string &path)
    {
      if (!begins_with(path, section + "/"))
        return "";
      const std::string rest = path.substr(section.size() + 1);
      return rest.substr(0, rest.find('/'));
    }



    /** A word of letters, digits, '_' and '-'. */
    bool
    can_name_body(const std::string &name)
    {
      return !name.empty() && name != any_body &&
             std::all_of(name.begin(), name.end(), [](const unsigned char c) {
               return std::isalnum(c) || c == '_' || c == '-';
             });
    }
  } // namespace



  void
  BodyParameters::add_parameters(ParameterHandler &prm)
  {
    const NumberOrText
      field   = NumberOrText::expression("x"),
      along_x = NumberOrText::number_or_expression("x", positive),
      in_body = NumberOrText::number_or_expression("x, y, z", positive),
      coefficient =
        NumberOrText::number_or_expression("x, y, z, theta", positive),
      zero_too =
        NumberOrText::number_or_expression("x, y, z, theta", not_negative),
      any     = NumberOrText::number_or_expression("x, y, z, theta",
                                               Double(-1e15, 1e15),
                                               "none"),
      poisson = NumberOrText::number_or_expression("x, y, z", true, "none");
    SectionOfEntries entry(prm,
                           bodies_section + "/" +
                             (name.empty() ? any_body : name));
    entry("Kind", kind, Selection("rod|mass"))
      .means("A body of a row, in the order of x: a rod, or a rigid mass; for "
             "Dimension > 1 the body, or a mass that is its obstacle.");
    entry("Length", length, positive)
      .means("Length of a rod of the row.", "length");
    entry("Cells", cells, NumberOrText::word_or_count("automatic", 1, 10000000))
      .means("Number of its cells; automatic: of all rods together as many as "
             "Mesh/Cells would be, with Time/Scheme = box such that a wave "
             "passes each of them in the same time.");
    entry("Section", section.value, section.expression, along_x)
      .means("Cross-section of a rod over that of section Model or Rod; x of "
             "these coefficients begins at the left end of the rod.");
    entry("Stiffness", stiffness.value, stiffness.expression, coefficient)
      .means("Young's modulus over that one.");
    entry("Poisson ratio", poisson_ratio, poisson)
      .means("Poisson ratio nu at the same E and alpha, for Dimension > 1; "
             "none: of section Model.");
    entry("Density", density.value, density.expression, in_body)
      .means("Density over that one.");
    entry("Viscosity", viscosity.value, viscosity.expression, zero_too)
      .means("Viscosity zeta over that one: stress is E (u_x + zeta u_xt).");
    entry("Coupling", coupling, any)
      .means("Thermoelastic coupling a, E alpha, over that one; none: as "
             "Stiffness, at the same alpha.");
    entry("Conductivity",
          conductivity.value,
          conductivity.expression,
          coefficient)
      .means("Heat conductivity over that one.");
    entry("Heat capacity",
          heat_capacity.value,
          heat_capacity.expression,
          coefficient)
      .means("Heat capacity per volume over that one; of a mass its heat "
             "capacity over that of the rod of section Model or Rod.");
    entry("Mass", mass, positive)
      .means("Mass of a rigid mass; that of the rod of section Model is b.",
             "mass");
    entry("Temperature", temperature, field)
      .means("Initial temperature; x begins at the left end of the body.",
             "temperature");
    entry("Displacement", displacement, field)
      .means("Initial displacement.", "length");
    entry("Velocity", velocity, field).means("Initial velocity.", "velocity");
  }



  void
  PairParameters::add_parameters(ParameterHandler &prm)
  {
    const std::string section =
      pairs_section + "/" + (name.empty() ? any_pair : name);
    SectionOfEntries entry(prm, section);
    std::string      conditions = "contact|bonded";
    for (const ContactLawKind &law : contact_laws())
      if (law.name != no_obstacle().name)
        conditions += '|' + law.name;
    entry("Condition", condition, Selection(conditions))
      .means("Two neighbours: contact as Contact/Condition, bonded layers of "
             "one rod, or a law of this contact.");
    entry("Gap", gap, NumberOrText::word_or_number("none"))
      .means("Gap between them; negative is a preload; none: Contact/Gap.",
             "length");
    entry("Heat exchange", heat_exchange, NumberOrText::word("none"))
      .means("Heat exchange coefficient k between them; none: "
             "Boundary/right/Heat exchange.",
             "heat exchange");
    own_law.section = section;
    own_law.add_entries(entry, "of this contact");
  }



  bool
  RowParameters::has_rods() const
  {
    return std::any_of(bodies.begin(),
                       bodies.end(),
                       [](const BodyParameters &body) {
                         return !body.is_mass();
                       });
  }



  const PairParameters *
  RowParameters::find_pair(const std::string &name) const
  {
    const auto found =
      std::find_if(pairs.begin(), pairs.end(), [&](const auto &pair) {
        return pair.name == name;
      });
    return found == pairs.end() ? nullptr : &*found;
  }



  bool
  RowParameters::have_own_kinds() const
  {
    bool has_any = false;
    for (std::size_t i = 0; i + 1 < bodies.size(); ++i)
      {
        const PairParameters *const pair =
          find_pair(bodies[i].name + ' ' + bodies[i + 1].name);
        if (pair == nullptr || !(pair->is_bonded() || pair->has_own_kind()))
          return false;
        has_any = has_any || pair->has_own_kind();
      }
    return has_any;
  }



  void
  RowParameters::add_templates(ParameterHandler &prm)
  {
    static BodyParameters body;
    static PairParameters pair;
    body.add_parameters(prm);
    pair.add_parameters(prm);
  }



  void
  RowParameters::add_parameters(const std::vector<Assignment> &assignments,
                                ParameterHandler              &prm)
  {
    std::vector<std::string> names, pair_names;
    const auto add = [](const std::string &name, std::vector<std::string> &to) {
      if (!name.empty() && std::find(to.begin(), to.end(), name) == to.end())
        to.push_back(name);
    };
    const auto is_of_file = [](const Assignment &assignment) {
      return assignment.place.find(", line ") != std::string::npos;
    };
    // what a file has not, a command line or a study does not add to it
    const bool has_bodies = std::any_of(
      assignments.begin(),
      assignments.end(),
      [&](const Assignment &assignment) {
        return is_of_file(assignment) &&
               !name_within(bodies_section, assignment.path).empty();
      });
    for (const Assignment &assignment : assignments)
      {
        const std::string name = name_within(bodies_section, assignment.path);
        if (has_bodies && !name.empty() && !is_of_file(assignment) &&
            std::find(names.begin(), names.end(), name) == names.end())
          refuse(assignment,
                 "the file has no body " + quote(name),
                 "its bodies, " + join_words(names),
                 "a subsection of Bodies in the file");
        if (!name.empty() && !can_name_body(name))
          refuse(assignment,
                 "'" + quote(name) + "' cannot be the name of a body",
                 "letters, digits, '_' and '-'; NAME stands for a name of "
                 "yours",
                 "");
        add(name, names);
        add(name_within(pairs_section, assignment.path), pair_names);
      }
    bodies.assign(names.size(), BodyParameters());
    pairs.assign(pair_names.size(), PairParameters());
    for (unsigned int i = 0; i < names.size(); ++i)
      {
        bodies[i].name = names[i];
        bodies[i].add_parameters(prm);
      }
    for (unsigned int i = 0; i < pair_names.size(); ++i)
      {
        pairs[i].name = pair_names[i];
        pairs[i].add_parameters(prm);
      }
  }



  std::string
  declared_path(const std::string &path)
  {
    for (const auto &[section, any] : {std::pair(bodies_section, any_body),
                                       std::pair(pairs_section, any_pair)})
      if (const std::string name = name_within(section, path); !name.empty())
        return section + "/" + any +
               path.substr(section.size() + 1 + name.size());
    return path;
  }



  bool
  is_template_path(const std::string &path)
  {
    return name_within(bodies_section, path) == any_body ||
           name_within(pairs_section, path) == any_pair;
  }
} // namespace ThermoContact
