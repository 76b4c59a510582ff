// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/measured_table.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/input/unit_text.h>
#include <thermocontact/input/unknown_names.h>
#include <thermocontact/method/body_geometry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ThermoContact
{
  namespace
  {
    /** The kinds of quantities that the variables of expressions are. */
    const std::map<std::string, std::string> kinds_of_variables = {
      {"t", "time"},
      {"x", "length"},
      {"y", "length"},
      {"z", "length"},
      {"gap", "length"},
      {"pressure", "stress"},
      {"theta", "temperature"},
      {"theta_obs", "temperature"},
      {"theta_A", "temperature"}};



    // A wave that passes so often in a run, or a stress that relaxes so fast,
    // is in equilibrium but for ringing after sudden changes.
    constexpr double often = 1e5;

    /** The kind of quantity of an entry; empty if there is none. */
    std::string
    kind_of(const std::string &path)
    {
      const DeclaredEntry *const entry = find_entry(path);
      return entry == nullptr || entry->kind == kind_of_coefficients ?
               "" :
               entry->kind;
    }



    /** The base unit of a kind of quantity. */
    const std::string &
    unit_of(const std::string &kind)
    {
      static const ConversionsByKind all = []() {
        ScalesParameters one;
        one.length = one.time = one.stress = one.area = 1.;
        one.temperature = one.reference_temperature = 1.;
        return conversions_by_kind(one);
      }();
      return all.at(kind).unit;
    }



    /** The right end meets the obstacle, which is the default. */
    bool
    meets_obstacle(const std::vector<Assignment> &assignments)
    {
      const Assignment *const support =
        last_assignment(assignments, "Boundary/right/Support");
      return support == nullptr || support->value == "contact";
    }



    /** A row has two bodies at least. */
    bool
    has_neighbours(const std::vector<Assignment> &assignments)
    {
      std::set<std::string> bodies;
      for (const Assignment &assignment : assignments)
        if (begins_with(assignment.path, "Bodies/") && !assignment.is_section())
          bodies.insert(assignment.path.substr(
            0, assignment.path.find('/', std::string("Bodies/").size())));
      return bodies.size() > 1;
    }



    /** Two bodies of a row, or the right end and the obstacle. */
    bool
    can_have_contact(const std::vector<Assignment> &assignments)
    {
      return has_neighbours(assignments) || meets_obstacle(assignments);
    }



    /** The default law without an assignment, none for one that there is not,
     * and where nothing can meet. */
    const ContactLawKind &
    law_of(const std::vector<Assignment> &assignments)
    {
      if (!can_have_contact(assignments))
        return contact_law(no_obstacle().name);
      const Assignment *const last =
        last_assignment(assignments, "Contact/Condition");
      for (const ContactLawKind &law : contact_laws())
        if (last == nullptr || law.name == last->value)
          return law;
      return contact_law(no_obstacle().name);
    }



    /** Words that entries have in place of a number or an expression. */
    bool
    is_word(const std::string &text)
    {
      for (const char *const word :
           {"", "none", "automatic", "infinity", "as in front"})
        if (text == word)
          return true;
      return false;
    }



    /** The number of @p text in SI base units; none if it is an expression. */
    std::optional<double>
    si_number(const Assignment  &assignment,
              const std::string &text,
              const std::string &kind)
    {
      const auto split = split_unit(text);
      if (!split || split->unit.empty())
        return split ? std::optional<double>(split->number) : std::nullopt;
      if (const auto number =
            convert_unit(split->number, split->unit, unit_of(kind)))
        return number;
      refuse(assignment,
             is_unit(split->unit) ?
               split->unit + " is no unit of " + kind :
               "'" + quote(split->unit) + "' is no unit that UDUNITS-2 knows",
             "a number in " + unit_of(kind) + ", or with another unit of " +
               kind,
             kind == "temperature" ?
               "degC for degrees Celsius, K for kelvin" :
             kind == "body force" &&
                 convert_unit(split->number, split->unit, "m/s^2") ?
               "the density times this acceleration; masses alone have 1 "
               "kg/m^3" :
               "such a unit, or the number without one, in " + unit_of(kind));
    }
  } // namespace



  bool
  is_in_si(const std::vector<Assignment> &assignments)
  {
    return std::any_of(assignments.begin(),
                       assignments.end(),
                       [](const Assignment &a) {
                         return begins_with(a.path, "Rod/") &&
                                !a.is_section() && a.value != "0" &&
                                a.value != "free" && a.value != "automatic";
                       });
  }



  namespace
  {
    /** A number with a unit, where it is one of a quantity. */
    bool
    has_unit(const Assignment &assignment)
    {
      const auto split = split_unit(assignment.value);
      // the word behind a number may be a name, whose '*' is missing
      return split && !split->unit.empty() && is_unit(split->unit) &&
             !kind_of(assignment.path).empty();
    }



    /** Of the assignments that add_scales_of_masses() adds. */
    const std::string place_of_scales = "the scales of masses alone";



    /** In nondimensional scenes there is a compliance. */
    bool
    is_stiffness(const Assignment &assignment)
    {
      return kind_of(assignment.path) == "stiffness" &&
             assignment.value != "none";
    }
  } // namespace



  bool
  have_masses_alone(const std::vector<Assignment> &assignments)
  {
    const std::string section = "Bodies/";
    bool              has_any = false;
    for (const Assignment &assignment : assignments)
      if (begins_with(assignment.path, section) && assignment.path != section)
        {
          const std::string body =
            assignment.path.substr(0,
                                   assignment.path.find('/', section.size()));
          const Assignment *const kind =
            last_assignment(assignments, body + "/Kind");
          if (kind == nullptr || kind->value != "mass")
            return false;
          has_any = true;
        }
    return has_any;
  }



  void
  add_scales_of_masses(std::vector<Assignment> &assignments)
  {
    const Assignment *const fields =
      last_assignment(assignments, "Model/Fields");
    if (is_in_si(assignments) || !have_masses_alone(assignments) ||
        fields == nullptr || fields->value != "displacement" ||
        std::none_of(assignments.begin(),
                     assignments.end(),
                     [](const Assignment &assignment) {
                       return has_unit(assignment) || is_stiffness(assignment);
                     }))
      return;
    assignments.insert(assignments.begin(),
                       {{place_of_scales, "Rod/Length", "1 m"},
                        {place_of_scales, "Rod/Cross-section area", "1 m^2"},
                        {place_of_scales, "Rod/Density", "1 kg/m^3"},
                        {place_of_scales, "Rod/Young's modulus", "1 Pa"}});
  }



  std::string
  without_unit(const Assignment &assignment)
  {
    const std::string kind  = kind_of(assignment.path);
    const auto        split = split_unit(assignment.value);
    return kind.empty() || !split || split->unit.empty() ?
             assignment.value :
             significant(*si_number(assignment, assignment.value, kind),
                         all_digits);
  }



  std::string
  unit_of_entry(const std::string &path)
  {
    const std::string kind = kind_of(path);
    return kind.empty() ? "" : unit_of(kind);
  }



  void
  refuse_units(const Assignment &assignment)
  {
    if (has_unit(assignment))
      refuse(assignment,
             "a unit, and the file has no section Rod, from which "
             "the scales of a scene in SI units follow",
             "a nondimensional number",
             "the number without a unit, '*' before a name, or "
             "section Rod");
    if (is_stiffness(assignment))
      refuse(assignment,
             "the file has no section Rod, and is nondimensional",
             "none",
             path_in_same_law(assignment.path, "Compliance") +
               ", or section Rod");
  }



  SiScene::SiScene(const std::vector<Assignment>       &assignments,
                   const std::map<std::string, double> &constants)
    : assignments(assignments)
    , constants(constants)
    , dim(parse_number(given("Dimension").value_or("1")).value_or(1.))
    , has_temperature(given("Model/Fields").value_or("") != "displacement")
    , has_displacement(given("Model/Fields").value_or("") != "temperature")
    , has_row(dim == 1. && std::any_of(assignments.begin(),
                                       assignments.end(),
                                       [](const Assignment &assignment) {
                                         return begins_with(assignment.path,
                                                            "Bodies/");
                                       }))
    , is_confined(dim > 1 || given("Rod/Lateral sides") == "confined")
    , law(law_of(assignments))
  {
    check_complete();
    set_scales();
    conversions = conversions_by_kind(scales);
    check_area();
    for (const Assignment &assignment : assignments)
      if (const DeclaredEntry *const entry = find_entry(assignment.path);
          entry != nullptr && entry->kind == kind_of_coefficients)
        refuse(assignment,
               have_masses_alone(assignments) ?
                 "masses alone have no material" :
                 "section Rod decides it",
               "no such entry",
               have_masses_alone(assignments) ?
                 "leave it out" :
                 "change the rod, or the scene that --units prints");
  }



  std::optional<std::string>
  SiScene::given(const std::string &path) const
  {
    const Assignment *const last = last_assignment(assignments, path);
    return last == nullptr || (last->place == place_of_scales &&
                               !have_masses_alone(assignments)) ?
             std::nullopt :
             std::optional(last->value);
  }



  void
  SiScene::check_complete() const
  {
    std::vector<std::string> faults;
    const auto               need = [&](const bool         is_needed,
                          const std::string &path,
                          const bool         is_positive = false) {
      if (!is_needed)
        return;
      const DeclaredEntry &entry = entry_of_program(path);
      if (!given(path))
        faults.push_back(
          path + " is not given\n  allowed: " + describe_allowed(entry) +
          "\n  meaning: " + entry.text +
          "\n  remedy:  give it: a scene in SI units has no default of it");
      else if (is_positive && !(number(path) > 0.))
        faults.push_back(path + " = " + *given(path) +
                         "\n  allowed: a positive number" +
                         (entry.kind == "stiffness" ?
                                          "\n  remedy:  Contact/Condition = none, if nothing "
                                          "is to be met" :
                                          ""));
    };
    need(true, "Rod/Length", true);
    need(true, "Rod/Cross-section area", true);
    need(true, "Rod/Density", true);
    need(has_displacement, "Rod/Young's modulus", true);
    need(has_displacement && is_confined, "Rod/Poisson ratio");
    for (const std::string entry :
         {"Conductivity", "Heat capacity", "Reference temperature"})
      need(has_temperature, "Rod/" + entry, true);
    need(has_temperature && has_displacement, "Rod/Linear expansion");
    need(has_temperature, "Boundary/left/Temperature");
    need(has_temperature &&
           (has_neighbours(assignments) ||
            given("Boundary/right/Temperature").value_or("none") == "none"),
         "Boundary/right/Heat exchange");
    need(has_displacement && law.name != no_obstacle().name &&
           takes_from_section("Gap"),
         "Contact/Gap");
    for (const std::string &stiffness : given_stiffnesses())
      {
        need(true, stiffness, true);
        const std::string compliance =
          path_in_same_law(stiffness, "Compliance");
        if (given(compliance))
          throw InputError(stiffness + " = " + *given(stiffness) + ": " +
                           compliance +
                           " is given, too\n  remedy:  one of them");
      }
    check_exponents();
    for (const ContactLawEntry &entry : law.entries)
      if (has_displacement && entry.is_positive &&
          takes_from_section(entry.name) && !given("Contact/" + entry.name))
        need(true,
             entry.name == "Compliance" ? "Contact/Stiffness" :
                                          "Contact/" + entry.name);
    need(dim > 1, "Mesh/Width");
    need(true, "Time/End time");
    throw_faults(faults);
  }



  void
  SiScene::check_area() const
  {
    const double width = scales.length.value() * number("Mesh/Width");
    const bool   is_round =
      given("Mesh/Geometry").value_or(geometries().front().name) !=
      geometries().front().name;
    const double area =
      dim == 3 ? width * width : dealii::numbers::PI * width * width;
    if ((dim == 3 || (dim == 2 && is_round)) &&
        std::abs(*scales.area - area) > Tolerances::same_area * area)
      throw InputError(
        text("Rod/Cross-section area = ",
             *given("Rod/Cross-section area"),
             "\n  allowed: ",
             area,
             " m^2, as Mesh/Width says\n  remedy:  one of them: forces are "
             "pressures times this area"));
  }



  double
  SiScene::rod(const std::string &entry) const
  {
    return given("Rod/" + entry) ? number("Rod/" + entry) : 0.;
  }



  double
  SiScene::modulus() const
  {
    const double nu = rod("Poisson ratio");
    return rod("Young's modulus") *
           (is_confined ? (1. - nu) / ((1. + nu) * (1. - 2. * nu)) : 1.);
  }



  void
  SiScene::set_scales()
  {
    const double length   = rod("Length"),
                 capacity = rod("Density") * rod("Heat capacity"),
                 absolute = rod("Reference temperature");
    scales.length         = length;
    scales.area           = rod("Cross-section area");
    scales.stress         = has_displacement ? modulus() : capacity / absolute;
    scales.time           = length * std::sqrt(rod("Density") / modulus());
    if (!has_temperature)
      return;
    scales.time = capacity * length * length / rod("Conductivity");
    scales.reference_temperature = absolute;
    scales.temperature =
      has_displacement ? std::sqrt(modulus() * absolute / capacity) : 1.;
  }



  double
  SiScene::number(const std::string &path) const
  {
    const Assignment *const last = last_assignment(assignments, path);
    return (last == nullptr ? std::nullopt : parse_number(value(*last)))
      .value_or(nan);
  }



  std::string
  SiScene::value(const Assignment &assignment) const
  {
    if (kind_of(assignment.path).empty())
      {
        const DeclaredEntry *const entry = find_entry(assignment.path);
        return entry == nullptr || entry->variables(dim).empty() ||
                   is_word(assignment.value) || parse_number(assignment.value) ?
                 assignment.value :
                 in_scene_variables(assignment, assignment.value);
      }
    const bool  is_list = assignment.path == "Output/Probes";
    std::string result, part;
    int         depth  = 0;
    const auto  finish = [&]() {
      result += scaled(assignment, dealii::Utilities::trim(part));
      part.clear();
    };
    for (const char letter : assignment.value)
      {
        depth += (letter == '(') - (letter == ')');
        if (letter == ';' || (is_list && depth <= 0 && letter == ','))
          {
            finish();
            result += std::string(1, letter) + ' ';
          }
        else
          part += letter;
      }
    finish();
    return result;
  }



  std::string
  SiScene::scaled(const Assignment &assignment, const std::string &text) const
  {
    const std::string kind = kind_of(assignment.path);
    if (is_word(text))
      return text;
    const bool   is_contact_law = kind == "stiffness" || kind == "compliance";
    const double exponent = is_contact_law ? law_exponent(assignment.path) : 1.;
    if (const auto split = split_unit(text);
        exponent != 1. && split && !split->unit.empty())
      refuse(assignment,
             "a unit with a power of the exponent",
             "a number in N/m^m or m/Pa^(1/m), m the Exponent of the law",
             "the number without the unit");
    Conversion conversion;
    if (!begins_with(assignment.path, "Rod/"))
      conversion = conversion_of(kind, conversions);
    if (kind == "compliance")
      conversion.factor =
        *scales.length / std::pow(*scales.stress, 1. / exponent);
    if (const auto number = si_number(assignment, text, kind);
        number && *number < 0. && kind == "temperature")
      refuse(assignment,
             "below absolute zero",
             "a number in K, or with another unit of temperature",
             "degC for degrees Celsius");
    else if (number)
      return significant((*number - conversion.offset) / conversion.factor,
                         all_digits);
    if (entry_of_program(assignment.path).variables(dim).empty())
      return text; // no expression, and refused as what it is
    const std::string offset =
      conversion.offset == 0. ?
        "" :
        " - " + significant(conversion.offset, all_digits);
    return "((" + in_scene_variables(assignment, text) + ")" + offset + ")/" +
           significant(conversion.factor, all_digits);
  }



  std::string
  SiScene::in_scene_variables(const Assignment  &assignment,
                              const std::string &text) const
  {
    ExpressionNames names;
    names.variables     = entry_of_program(assignment.path).variables(dim);
    names.constants     = constants;
    names.folder        = folder_of_tables(assignments);
    names.has_units     = true;
    names.checks_values = false;
    std::vector<std::string> others; // as the scene has them
    for (const std::string &name : names.variables)
      {
        const std::string &kind = kinds_of_variables.at(name);
        const Conversion  &unit = conversion_of(kind, conversions);
        names.units.push_back(unit_of(kind));
        others.push_back(
          "(" + significant(unit.factor, all_digits) + "*" + name +
          (unit.offset == 0. ? "" :
                               "+" + significant(unit.offset, all_digits)) +
          ")");
      }
    const std::string unit = unit_of_entry(assignment.path);
    names.units.push_back(unit.empty() ? "1" : unit);
    try
      {
        return Expression(assignment.path, text, names).with_variables(others);
      }
    catch (const InputError &error)
      {
        throw InputError(assignment.place + ": " + error.what());
      }
  }



  std::vector<std::string>
  SiScene::given_stiffnesses() const
  {
    std::vector<std::string> paths;
    for (const Assignment &assignment : assignments)
      if (kind_of(assignment.path) == "stiffness" &&
          given(assignment.path) != "none" &&
          std::find(paths.begin(), paths.end(), assignment.path) == paths.end())
        paths.push_back(assignment.path);
    return paths;
  }



  bool
  SiScene::has_law_at(const std::string &path) const
  {
    const std::string condition = path_in_same_law(path, "Condition");
    return begins_with(path, "Contacts/") ?
             given(condition) != "bonded" :
             path == path_in_same_law("Contact/Gap", "Stiffness") ||
               given("Contact/Rear gap").value_or("none") != "none";
  }



  const ContactLawKind &
  SiScene::law_at(const std::string &path) const
  {
    if (begins_with(path, "Contacts/"))
      if (const auto own = given(path_in_same_law(path, "Condition")))
        for (const ContactLawKind &kind : contact_laws())
          if (kind.name == *own)
            return kind;
    return law;
  }



  bool
  SiScene::takes_from_section(const std::string &entry) const
  {
    if (meets_obstacle(assignments) || dim > 1.)
      return true;
    std::vector<std::string> bodies;
    for (const Assignment &assignment : assignments)
      if (begins_with(assignment.path, "Bodies/") && !assignment.is_section())
        {
          const std::string name = name_of(section_of(assignment.path));
          if (std::find(bodies.begin(), bodies.end(), name) == bodies.end())
            bodies.push_back(name);
        }
    for (std::size_t i = 0; i + 1 < bodies.size(); ++i)
      {
        const std::string section =
          "Contacts/" + bodies[i] + ' ' + bodies[i + 1] + '/';
        const auto has_own = [&](const std::string &name) {
          return given(section + name).value_or("none") != "none";
        };
        const bool has_entry =
          entry == "Gap" || law_at(section + entry).uses(entry);
        if (has_law_at(section + entry) && has_entry && !has_own(entry) &&
            !(entry == "Compliance" && has_own("Stiffness")))
          return true;
      }
    return false;
  }



  void
  SiScene::check_exponents() const
  {
    for (const Assignment &assignment : assignments)
      {
        const std::string &path      = assignment.path;
        const std::string  stiffness = path_in_same_law(path, "Stiffness");
        const bool         is_kind   = begins_with(path, "Contacts/") &&
                             path == path_in_same_law(path, "Condition");
        const bool is_exponent = path != "Contact/Exponent" &&
                                 path == path_in_same_law(path, "Exponent") &&
                                 parse_number(*given(path));
        const bool is_of_same =
          law.uses("Compliance") &&
          law_exponent(path) == law_exponent("Contact/Exponent");
        if ((is_kind || is_exponent) && has_law_at(stiffness) &&
            law_at(path).uses("Compliance") && !is_of_same &&
            given(stiffness).value_or("none") == "none" &&
            !parse_number(
              given(path_in_same_law(path, "Compliance")).value_or("")))
          refuse(assignment,
                 "the number of section Contact goes with another exponent",
                 "that exponent",
                 stiffness + " = a number");
      }
  }



  double
  SiScene::law_exponent(const std::string &path) const
  {
    const std::string own = path_in_same_law(path, "Exponent");
    const std::string exponent =
      parse_number(given(own).value_or("")) ? own : "Contact/Exponent";
    if (!law_at(path).uses("Exponent"))
      return 1.;
    return parse_number(
             given(exponent).value_or(entry_of_program(exponent).default_value))
      .value_or(1.);
  }



  bool
  SiScene::is_small(const double seconds) const
  {
    const auto is_zero = [this](const std::string &path) {
      return !given(path) || *given(path) == "none" || number(path) == 0.;
    };
    const std::string wanted = given("Rod/Small terms").value_or("automatic");
    if (wanted != "automatic")
      return wanted == "dropped";
    const bool has_moving_body =
      std::any_of(assignments.begin(),
                  assignments.end(),
                  [](const Assignment &assignment) {
                    return begins_with(assignment.path, "Bodies/") &&
                           (name_of(assignment.path) == "Velocity" ||
                            assignment.value == "mass");
                  });
    return !has_moving_body && is_zero("Initial values/Velocity") &&
           is_zero("Boundary/left/Displacement") &&
           is_zero("Contact/Rear gap") && is_zero("Contact/Dashpot") &&
           is_zero("Boundary/left/Mass") && is_zero("Boundary/right/Mass") &&
           is_zero("Boundary/left/Dashpot") &&
           is_zero("Boundary/right/Dashpot") &&
           given("Boundary/left/Support") != "free" &&
           *scales.time * number("Time/End time") > often * seconds;
  }



  std::vector<Assignment>
  SiScene::derived() const
  {
    std::vector<Assignment> result;
    const auto set = [&](const std::string &path, const std::string &value) {
      result.push_back({"section Rod", path, value});
    };
    const auto set_number = [&](const std::string           &path,
                                const std::optional<double> &value) {
      if (value)
        set(path, significant(*value, all_digits));
    };
    const double wave = rod("Length") * std::sqrt(rod("Density") / modulus()),
                 relaxing = rod("Viscosity") / modulus(),
                 nu       = rod("Poisson ratio");
    const bool is_static  = is_small(wave);
    if (has_displacement)
      {
        set_number("Model/Inertia",
                   is_static ? 0. : std::pow(wave / *scales.time, 2));
        set_number("Model/Viscosity",
                   is_static && is_small(relaxing) ? 0. :
                                                     relaxing / *scales.time);
        if (dim > 1)
          set_number("Model/Poisson ratio", nu);
        if (!is_static && !has_row && !given("Initial values/Velocity"))
          set("Initial values/Velocity", "0");
      }
    if (has_displacement && has_temperature)
      set_number("Model/Coupling",
                 rod("Linear expansion") * *scales.temperature *
                   (is_confined ? (1. + nu) / (1. - nu) : 1.));
    if (has_temperature && !has_row && !given("Initial values/Temperature"))
      set("Initial values/Temperature", "0");
    if (has_displacement)
      for (const std::string &stiffness : given_stiffnesses())
        if (has_law_at(stiffness) && law_at(stiffness).uses("Compliance"))
          set_number(path_in_same_law(stiffness, "Compliance"),
                     std::pow(*scales.stress * *scales.area / number(stiffness),
                              1. / law_exponent(stiffness)) /
                       *scales.length);
    const double end_time = number("Time/End time");
    if (!given("Output/Fields interval"))
      set_number("Output/Fields interval", round_to_digits(end_time / 20., 6));
    for (const ScalesParameters::Scale &scale : ScalesParameters::all())
      set_number(std::string("Scales/") + scale.name, scales.*scale.value);
    // the units that the file uses
    const auto unit_of = [this](const std::string &path) {
      const auto split = split_unit(given(path).value_or(""));
      return split ? split->unit : "";
    };
    if (!given("Scales/Time unit"))
      {
        const std::string wanted  = unit_of("Time/End time");
        const double      seconds = end_time * *scales.time;
        set("Scales/Time unit",
            dealii::Patterns::Selection(names_of_time_units).match(wanted) ?
              wanted :
            seconds >= 10.       ? "s" :
            1e6 * seconds >= 10. ? "ms" :
                                   "us");
      }
    const std::string degree = unit_of("Rod/Reference temperature");
    if (has_temperature && !given("Scales/Temperature unit"))
      set("Scales/Temperature unit",
          !degree.empty() && convert_unit(0., degree, "degC") == 0. ? "C" :
                                                                      "K");
    return result;
  }



  namespace
  {
    /** Whether only files in SI units have the entry. */
    bool
    exists_only_in_si(const DeclaredEntry &entry)
    {
      return section_of(entry.path) == "Rod" || entry.kind == "stiffness";
    }



    template <typename Condition>
    void
    remove_if(const Condition &condition, std::vector<DeclaredEntry> &entries)
    {
      entries.erase(std::remove_if(entries.begin(), entries.end(), condition),
                    entries.end());
    }
  } // namespace



  void
  add_units(const std::vector<Assignment> &assignments,
            std::vector<DeclaredEntry>    &entries)
  {
    if (!is_in_si(assignments))
      return remove_if(exists_only_in_si, entries);
    for (DeclaredEntry &entry : entries)
      if (const Assignment *const given =
            last_assignment(assignments, entry.path))
        {
          if (given->value != entry.value)
            entry.remark = entry.value;
          entry.value = given->value;
        }
      else
        entry.is_remark = !entry.kind.empty();
  }



  void
  remove_units(const std::vector<Assignment> &assignments,
               std::vector<DeclaredEntry>    &entries)
  {
    for (DeclaredEntry &entry : entries)
      if (const Assignment *const given =
            last_assignment(assignments, entry.path);
          given != nullptr && given->value != entry.value)
        entry.remark = given->value;
    remove_if(
      [](const DeclaredEntry &entry) {
        // a body is there by its section
        return exists_only_in_si(entry) ||
               (entry.value == entry.default_value &&
                !(begins_with(entry.path, "Bodies/") &&
                  name_of(entry.path) == "Kind"));
      },
      entries);
  }
} // namespace ThermoContact
