// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/contact_law.h>
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
#include <cstring>
#include <limits>
#include <map>
#include <stdexcept>

namespace ThermoContact
{
  namespace
  {
    /** An entry that is a quantity. */
    struct Quantity
    {
      const char *path, *kind;
    };

    const Quantity quantities[] = {
      {"Boundary/Ambient temperature", "temperature"},
      {"Boundary/Fixed end displacement", "length"},
      {"Boundary/Fixed end temperature", "temperature"},
      {"Boundary/Heat exchange", "heat exchange"},
      {"Boundary/Lateral heat exchange", "heat loss"},
      {"Boundary/Obstacle temperature", "temperature"},
      {"Contact/Compliance", "compliance"},
      {"Contact/Damping", "damping"},
      {"Contact/Gap", "length"},
      {"Contact/Rear gap", "length"},
      {"Contact/Stiffness", "stiffness"},
      {"Initial values/Displacement", "length"},
      {"Initial values/Temperature", "temperature"},
      {"Initial values/Velocity", "velocity"},
      {"Mesh/Width", "length"},
      {"Output/Checkpoint interval", "s"},
      {"Output/Contact interval", "time"},
      {"Output/Fields interval", "time"},
      {"Output/Period", "time"},
      {"Output/Probes", "length"},
      {"Output/Space-time interval", "time"},
      {"Rod/Conductivity", "conductivity"},
      {"Rod/Cross-section area", "area"},
      {"Rod/Density", "density"},
      {"Rod/Heat capacity", "heat capacity"},
      {"Rod/Length", "length"},
      {"Rod/Linear expansion", "thermal expansion"},
      {"Rod/Reference temperature", "temperature"},
      {"Rod/Viscosity", "viscosity"},
      {"Rod/Young's modulus", "stress"},
      {"Sources/Body force", "body force"},
      {"Sources/End heat flux", "heat flux"},
      {"Sources/End traction", "stress"},
      {"Sources/Heat source", "heat source"},
      {"Study/Target error", "length"},
      {"Time/Break points", "time"},
      {"Time/End time", "time"},
      {"Time/First step size", "time"},
      {"Time/Maximum step size", "time"},
      {"Time/Minimum step size", "time"},
      {"Time/Step size", "time"}};

    /** What the variables of expressions are. */
    const Quantity variables[] = {{"t", "time"},
                                  {"x", "length"},
                                  {"y", "length"},
                                  {"z", "length"},
                                  {"gap", "length"},
                                  {"pressure", "stress"},
                                  {"theta_A", "temperature"}};

    /** True for entries that the rod decides. */
    bool
    is_decided(const std::string &path)
    {
      return path == "Model/Coupling" || path == "Model/Inertia" ||
             path == "Model/Poisson ratio" || path == "Model/Viscosity" ||
             (path.rfind("Scales/", 0) == 0 && path != "Scales/Time unit" &&
              path != "Scales/Temperature unit");
    }



    // A wave that passes so often in a run, or a stress that relaxes so fast,
    // is in equilibrium but for ringing after sudden changes.
    constexpr double often = 1e5;

    /** The kind of quantity of an entry or a variable; empty if it is none. */
    template <std::size_t n>
    std::string
    find_kind(const Quantity (&list)[n], const std::string &path)
    {
      const auto found = std::find_if(list, list + n, [&](const Quantity &q) {
        return path == q.path;
      });
      return found == list + n ? "" : found->kind;
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



    [[noreturn]] void
    refuse_value(const Assignment  &assignment,
                 const std::string &fault,
                 const std::string &allowed,
                 const std::string &remedy)
    {
      throw InputError(assignment.place + ": " + assignment.path + " = " +
                       quote(assignment.value) + ": " + fault +
                       "\n  allowed: " + allowed + "\n  remedy:  " + remedy);
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
      std::string fault = split->unit + " is no unit of " + kind;
      try
        {
          if (const auto number =
                convert_unit(split->number, split->unit, unit_of(kind)))
            return number;
        }
      catch (const std::invalid_argument &error)
        {
          fault = error.what();
        }
      refuse_value(assignment,
                   fault,
                   "a number in " + unit_of(kind) +
                     ", or with another unit of " + kind,
                   kind == "temperature" ?
                     "degC for degrees Celsius, K for kelvin" :
                     "such a unit, or the number without one, in " +
                       unit_of(kind));
    }
  } // namespace



  bool
  is_in_si(const std::vector<Assignment> &assignments)
  {
    return std::any_of(assignments.begin(),
                       assignments.end(),
                       [](const Assignment &a) {
                         return a.path.rfind("Rod/", 0) == 0 &&
                                !a.is_section() && a.value != "0" &&
                                a.value != "free" && a.value != "automatic";
                       });
  }



  std::string
  without_unit(const Assignment &assignment)
  {
    const std::string kind  = find_kind(quantities, assignment.path);
    const auto        split = split_unit(assignment.value);
    return kind.empty() || !split || split->unit.empty() ?
             assignment.value :
             significant(*si_number(assignment, assignment.value, kind),
                         all_digits);
  }



  std::string
  unit_of_entry(const std::string &path)
  {
    const std::string kind = find_kind(quantities, path);
    return kind.empty() ? "" : unit_of(kind);
  }



  void
  refuse_units(const std::vector<Assignment> &assignments)
  {
    // what is behind a number may be a name, whose '*' is missing
    const auto is_unit = [](const std::string &text) {
      try
        {
          return convert_unit(1., text, "1") || true;
        }
      catch (const std::invalid_argument &)
        {
          return false;
        }
    };
    for (const Assignment &assignment : assignments)
      {
        const auto split = split_unit(assignment.value);
        if (!find_kind(quantities, assignment.path).empty() && split &&
            !split->unit.empty() && is_unit(split->unit))
          refuse_value(assignment,
                       "a unit, and the file has no section Rod, from which "
                       "the scales of a scene in SI units follow",
                       "a nondimensional number",
                       "the number without a unit, '*' before a name, or "
                       "section Rod");
        if (assignment.path == "Contact/Stiffness" &&
            assignment.value != "none")
          refuse_value(assignment,
                       "the file has no section Rod, and is nondimensional",
                       "none",
                       "Contact/Compliance, or section Rod");
      }
  }



  SiScene::SiScene(const std::vector<Assignment>       &assignments,
                   const std::vector<DeclaredEntry>    &entries,
                   const RodParameters                 &rod,
                   const std::map<std::string, double> &constants)
    : assignments(assignments)
    , entries(entries)
    , rod(rod)
    , constants(constants)
    , dim(parse_number(given("Dimension").value_or("1")).value_or(1.))
    , has_temperature(given("Model/Fields").value_or("") != "displacement")
    , has_displacement(given("Model/Fields").value_or("") != "temperature")
  {
    check_complete();
    set_scales();
    conversions = conversions_by_kind(scales);
    check_area();
    for (const Assignment &assignment : assignments)
      if (is_decided(assignment.path) && !assignment.is_section())
        refuse_value(assignment,
                     "section Rod decides it",
                     "no such entry",
                     "change the rod, or the scene that --units prints");
  }



  std::optional<std::string>
  SiScene::given(const std::string &path) const
  {
    const Assignment *const last = last_assignment(assignments, path);
    return last == nullptr ? std::nullopt : std::optional(last->value);
  }



  void
  SiScene::check_complete() const
  {
    const auto need = [this](const bool is_needed, const std::string &path) {
      if (!is_needed || given(path))
        return;
      const DeclaredEntry &entry = *find_entry(entries, path);
      throw InputError(
        path + " is not given\n  allowed: " + describe_pattern(entry.pattern) +
        "\n  meaning: " + entry.text +
        "\n  remedy:  give it: a scene in SI units has no default of it");
    };
    const auto need_positive =
      [&](const bool is_needed, const double value, const std::string &path) {
        need(is_needed, path);
        if (is_needed && !(value > 0.))
          throw InputError(path + " = " + *given(path) +
                           "\n  allowed: a positive number");
      };
    need_positive(true, rod.length, "Rod/Length");
    need_positive(true, rod.area, "Rod/Cross-section area");
    need_positive(true, rod.density, "Rod/Density");
    need_positive(has_displacement, rod.youngs_modulus, "Rod/Young's modulus");
    need(has_displacement && (dim > 1 || rod.lateral_sides == "confined"),
         "Rod/Poisson ratio");
    need_positive(has_temperature, rod.conductivity, "Rod/Conductivity");
    need_positive(has_temperature, rod.heat_capacity, "Rod/Heat capacity");
    need_positive(has_temperature,
                  rod.reference_temperature,
                  "Rod/Reference temperature");
    need(has_temperature && has_displacement, "Rod/Linear expansion");
    need(has_temperature, "Boundary/Fixed end temperature");
    need(has_temperature, "Boundary/Heat exchange");
    const std::string condition =
      given("Contact/Condition").value_or(contact_laws().front().name);
    need(has_displacement && condition != no_obstacle().name, "Contact/Gap");
    if (given("Contact/Stiffness").value_or("none") != "none")
      need_positive(true, number("Contact/Stiffness"), "Contact/Stiffness");
    if (given("Contact/Stiffness") && given("Contact/Compliance"))
      throw InputError("Contact/Stiffness = " + *given("Contact/Stiffness") +
                       ": Contact/Compliance is given, too\n  remedy:  one of "
                       "them");
    for (const ContactLawKind &law : contact_laws())
      need(has_displacement && condition == law.name &&
             std::find(law.entries.begin(), law.entries.end(), "Compliance") !=
               law.entries.end() &&
             !given("Contact/Compliance"),
           "Contact/Stiffness");
    need(dim > 1, "Mesh/Width");
    need(true, "Time/End time");
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
        std::abs(rod.area - area) > Tolerances::same_area * area)
      throw InputError(
        text("Rod/Cross-section area = ",
             *given("Rod/Cross-section area"),
             "\n  allowed: ",
             area,
             " m^2, as Mesh/Width says\n  remedy:  one of them: forces are "
             "pressures times this area"));
  }



  double
  SiScene::modulus() const
  {
    const double nu = rod.poisson_ratio;
    return rod.youngs_modulus * (dim > 1 || rod.lateral_sides == "confined" ?
                                   (1. - nu) / ((1. + nu) * (1. - 2. * nu)) :
                                   1.);
  }



  void
  SiScene::set_scales()
  {
    const double capacity = rod.density * rod.heat_capacity;
    scales.length         = rod.length;
    scales.area           = rod.area;
    scales.time           = has_temperature ?
                              capacity * rod.length * rod.length / rod.conductivity :
                              rod.length * std::sqrt(rod.density / modulus());
    if (has_temperature)
      {
        scales.reference_temperature = rod.reference_temperature;
        scales.temperature =
          has_displacement ?
            std::sqrt(modulus() * rod.reference_temperature / capacity) :
            1.;
      }
    scales.stress =
      has_displacement ? modulus() : capacity / rod.reference_temperature;
  }



  double
  SiScene::number(const std::string &path) const
  {
    const Assignment *const last = last_assignment(assignments, path);
    return (last == nullptr ? std::nullopt : parse_number(value(*last)))
      .value_or(std::numeric_limits<double>::quiet_NaN());
  }



  std::string
  SiScene::value(const Assignment &assignment) const
  {
    if (find_kind(quantities, assignment.path).empty())
      return assignment.value;
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
    const std::string kind = find_kind(quantities, assignment.path);
    for (const char *const word : {"", "none", "automatic", "infinity"})
      if (text == word)
        return text;
    const bool   is_of_law = kind == "stiffness" || kind == "compliance";
    const double exponent  = is_of_law ? law_exponent() : 1.;
    if (const auto split = split_unit(text);
        exponent != 1. && split && !split->unit.empty())
      refuse_value(assignment,
                   "a unit with a power of the exponent",
                   "a number in N/m^m or m/Pa^(1/m), m Contact/Exponent",
                   "the number without the unit");
    Conversion conversion;
    const auto found = conversions.find(kind);
    if (found != conversions.end() && assignment.path.rfind("Rod/", 0) != 0)
      conversion = found->second;
    if (kind == "compliance")
      conversion.factor =
        *scales.length / std::pow(*scales.stress, 1. / exponent);
    if (const auto number = si_number(assignment, text, kind);
        number && *number < 0. && kind == "temperature")
      refuse_value(assignment,
                   "below absolute zero",
                   "a number in K, or with another unit of temperature",
                   "degC for degrees Celsius");
    else if (number)
      return significant((*number - conversion.offset) / conversion.factor,
                         all_digits);
    const std::string section = section_of(assignment.path);
    if (section != "Boundary" && section != "Contact" &&
        section != "Initial values" && section != "Sources")
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
    const bool        is_exchange = assignment.path == "Boundary/Heat exchange";
    const std::string section     = section_of(assignment.path);
    // as the scene has them: times, places and theta_A
    const auto is_known = [&](const std::string &name) {
      if (name == "gap" || name == "pressure" || is_exchange)
        return is_exchange && (name == "gap" || name == "pressure");
      if (name == "t")
        return section != "Initial values";
      if (name == "theta_A" || name == "x")
        return section == "Initial values" || section == "Sources" ||
               (name == "x" && assignment.path == "Contact/Gap");
      return assignment.path == "Contact/Gap" ||
             ((name == "y" ? dim > 1 : dim > 2) &&
              assignment.path.find("Fixed end") == std::string::npos);
    };
    ExpressionNames names;
    names.constants = constants;
    names.folder    = folder_of_tables(assignments);
    names.has_units = true;
    names.example   = is_exchange ? "if(pressure > 0, 500 + 1e-3*pressure, 5)" :
                      section == "Initial values" ? "2*x/0.5" :
                                                    "1e-4 + 1e-5*sin(t)";
    std::vector<std::string> others;
    for (const Quantity &variable : variables)
      if (is_known(variable.path))
        {
          const auto        found = conversions.find(variable.kind);
          const Conversion &unit =
            found == conversions.end() ? Conversion() : found->second;
          names.variables.emplace_back(variable.path);
          names.units.push_back(unit_of(variable.kind));
          others.push_back(
            "(" + significant(unit.factor, all_digits) + "*" + variable.path +
            (unit.offset == 0. ? "" :
                                 "+" + significant(unit.offset, all_digits)) +
            ")");
        }
    names.units.push_back(unit_of(find_kind(quantities, assignment.path)));
    try
      {
        return rename_variables(assignment.path, text, names, others);
      }
    catch (const InputError &error)
      {
        throw InputError(assignment.place + ": " + error.what());
      }
  }



  double
  SiScene::law_exponent() const
  {
    const double by_default = ContactLawParameters().exponent;
    if (given("Contact/Condition").value_or("") != power_law().name)
      return 1.;
    const std::optional<std::string> exponent = given("Contact/Exponent");
    return exponent ? parse_number(*exponent).value_or(by_default) : by_default;
  }



  bool
  SiScene::is_small(const double seconds) const
  {
    const auto is_zero = [this](const std::string &path) {
      return !given(path) || *given(path) == "none" || number(path) == 0.;
    };
    if (rod.small_terms != "automatic")
      return rod.small_terms == "dropped";
    return is_zero("Initial values/Velocity") &&
           is_zero("Boundary/Fixed end displacement") &&
           is_zero("Contact/Rear gap") &&
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
    const double wave     = rod.length * std::sqrt(rod.density / modulus()),
                 relaxing = rod.viscosity / modulus(), nu = rod.poisson_ratio;
    const bool is_static = is_small(wave);
    if (has_displacement)
      {
        set_number("Model/Inertia",
                   is_static ? 0. : std::pow(wave / *scales.time, 2));
        set_number("Model/Viscosity",
                   is_static && is_small(relaxing) ? 0. :
                                                     relaxing / *scales.time);
        if (dim > 1)
          set_number("Model/Poisson ratio", nu);
        if (!is_static && !given("Initial values/Velocity"))
          set("Initial values/Velocity", "0");
      }
    if (has_displacement && has_temperature)
      set_number("Model/Coupling",
                 rod.linear_expansion * *scales.temperature *
                   (modulus() == rod.youngs_modulus ? 1. :
                                                      (1. + nu) / (1. - nu)));
    if (has_temperature && !given("Initial values/Temperature"))
      set("Initial values/Temperature", "0");
    if (given("Contact/Stiffness"))
      set_number("Contact/Compliance",
                 std::pow(*scales.stress * rod.area /
                            number("Contact/Stiffness"),
                          1. / law_exponent()) /
                   rod.length);
    const double end_time = number("Time/End time");
    if (!given("Output/Fields interval"))
      set_number("Output/Fields interval", round_to_digits(end_time / 20., 6));
    set_number("Scales/Length", scales.length);
    set_number("Scales/Time", scales.time);
    set_number("Scales/Stress", scales.stress);
    set_number("Scales/Area", scales.area);
    set_number("Scales/Temperature", scales.temperature);
    set_number("Scales/Reference temperature", scales.reference_temperature);
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
    std::map<std::string, std::string>
    last_values(const std::vector<Assignment> &assignments)
    {
      std::map<std::string, std::string> values;
      for (const Assignment &assignment : assignments)
        values[assignment.path] = assignment.value;
      return values;
    }
  } // namespace



  void
  add_units(const std::vector<Assignment> &assignments,
            std::vector<DeclaredEntry>    &entries)
  {
    const auto values = last_values(assignments);
    for (DeclaredEntry &entry : entries)
      if (const auto given = values.find(entry.path); given != values.end())
        {
          if (given->second != entry.value)
            entry.remark = entry.value;
          entry.value = given->second;
        }
      else
        entry.is_remark =
          !find_kind(quantities, entry.path).empty() || is_decided(entry.path);
  }



  void
  remove_units(const std::vector<Assignment> &assignments,
               std::vector<DeclaredEntry>    &entries)
  {
    const auto values = last_values(assignments);
    for (DeclaredEntry &entry : entries)
      if (const auto given = values.find(entry.path);
          given != values.end() && given->second != entry.value)
        entry.remark = given->second;
    entries.erase(std::remove_if(entries.begin(),
                                 entries.end(),
                                 [](const DeclaredEntry &entry) {
                                   return entry.path.rfind("Rod/", 0) == 0 ||
                                          entry.path == "Contact/Stiffness" ||
                                          entry.value == entry.default_value;
                                 }),
                  entries.end());
  }
} // namespace ThermoContact
