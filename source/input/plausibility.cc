// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/constants.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/measured_table.h>
#include <thermocontact/input/plausibility.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/input/unit_text.h>

#include <cmath>
#include <limits>
#include <optional>

namespace ThermoContact
{
  namespace
  {
    constexpr double unbounded = std::numeric_limits<double>::infinity();

    /** The range of a quantity, and the unit of numbers that are not in it. */
    struct Range
    {
      const char *path;
      double      low, high;
      const char *unit;
    };

    // softer than rubber, heavier than osmium, colder than any rod but in a
    // cryostat
    const Range ranges[] = {
      {"Boundary/Ambient temperature", 150., unbounded, "degC"},
      {"Boundary/Fixed end temperature", 150., unbounded, "degC"},
      {"Boundary/Obstacle temperature", 150., unbounded, "degC"},
      {"Initial values/Temperature", 150., unbounded, "degC"},
      {"Rod/Density", 20., unbounded, "g/cm^3"},
      {"Rod/Density", 0., 3e4, "g/m^3"},
      {"Rod/Heat capacity", 10., unbounded, "kJ/(kg K)"},
      {"Rod/Length", 0., 100., "mm"},
      {"Rod/Linear expansion", -1e-3, 1e-3, "um/(m K)"},
      {"Rod/Reference temperature", 150., unbounded, "degC"},
      {"Rod/Young's modulus", 1e4, unbounded, "GPa"},
      {"Rod/Young's modulus", 1e8, unbounded, "MPa"}};

    /** Lengths of a rod over its thickness, and stiffnesses over its own. */
    constexpr double most_slender = 1e3, stiffest = 1e4;



    /** The number of an entry in SI base units; NaN if it is none. */
    double
    number_of(const std::vector<Assignment> &assignments,
              const std::string             &path)
    {
      const Assignment *const last = last_assignment(assignments, path);
      return (last == nullptr ? std::nullopt :
                                parse_number(without_unit(*last)))
        .value_or(std::numeric_limits<double>::quiet_NaN());
    }



    /** A temperature that an expression has at first, where x = 0; or NaN. */
    double
    first_temperature(const std::vector<Assignment> &assignments,
                      const Assignment              &expression)
    {
      constexpr double                   room = 293.15;
      std::map<std::string, std::string> constants;
      for (const Assignment &assignment : assignments)
        if (is_constant_path(assignment.path))
          constants[assignment.path.substr(assignment.path.find('/') + 1)] =
            assignment.value;
      ExpressionNames names;
      names.variables          = {"theta_A", "t", "x", "y", "z"};
      names.folder             = folder_of_tables(assignments);
      names.has_units          = true;
      names.checks_values      = false;
      const double variables[] = {room, 0., 0., 0., 0.};
      try
        {
          names.constants = evaluate_constants(constants);
          return Expression(expression.path, expression.value, names)
            .evaluate(variables);
        }
      catch (const InputError &)
        {
          return std::numeric_limits<double>::quiet_NaN(); // refused elsewhere
        }
    }



    /** What does not fit to the rod, with whatever unit. */
    void
    add_doubts_of_sizes(const std::vector<Assignment> &assignments,
                        std::vector<std::string>      &doubts)
    {
      const auto number = [&assignments](const std::string &path) {
        return number_of(assignments, path);
      };
      const auto add_if = [&](const bool         is_doubted,
                              const std::string &path,
                              const std::string &words) {
        if (is_doubted)
          doubts.push_back(path + " = " +
                           last_assignment(assignments, path)->value + ": " +
                           words + "; is that its unit?");
      };
      const double length = number("Rod/Length"),
                   area   = number("Rod/Cross-section area"),
                   own    = number("Rod/Young's modulus") * area / length;
      for (const std::string path : {"Contact/Gap", "Contact/Rear gap"})
        add_if(std::abs(number(path)) > length,
               path,
               "more than the length of the rod");
      add_if(area > length * length,
             "Rod/Cross-section area",
             "more than the square of the length of the rod");
      add_if(length > most_slender * std::sqrt(area),
             "Rod/Length",
             "more than 1000 times the thickness of the rod");
      add_if(number("Contact/Stiffness") > stiffest * own &&
               last_assignment(assignments, "Contact/Exponent") == nullptr,
             "Contact/Stiffness",
             "more than 10000 times that of the rod");
    }
  } // namespace



  std::vector<std::string>
  implausible_numbers(const std::vector<Assignment> &assignments)
  {
    std::vector<std::string> doubts;
    if (last_assignment(assignments, "Rod/Length") == nullptr)
      return doubts;
    for (const Range &range : ranges)
      {
        const Assignment *const last = last_assignment(assignments, range.path);
        if (last == nullptr)
          continue;
        const auto split = split_unit(last->value);
        const bool is_doubted =
          split && split->unit.empty() &&
          !(split->number >= range.low && split->number <= range.high);
        if (const double first = split || std::string(range.unit) != "degC" ?
                                   unbounded :
                                   first_temperature(assignments, *last);
            first < range.low)
          doubts.push_back(
            text(range.path,
                 " = ",
                 quote(last->value),
                 ": at t = 0 that is ",
                 first,
                 " K; numbers in an expression are in SI base units"));
        const std::string number = is_doubted ? last->value : "";
        const std::string begin  = std::string(range.path) + " = ";
        if (is_doubted &&
            (doubts.empty() || doubts.back().rfind(begin, 0) != 0))
          doubts.push_back(begin + number + ": is that in " +
                           unit_of_entry(range.path) + ", or " + number + ' ' +
                           range.unit + "? With its unit it is not doubted");
      }
    add_doubts_of_sizes(assignments, doubts);
    return doubts;
  }
} // namespace ThermoContact
