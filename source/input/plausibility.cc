// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/input/unit_text.h>

namespace ThermoContact
{
  namespace
  {
    /** The range of a quantity, and the unit of numbers that are not in it. */
    struct Range
    {
      std::string path;
      double      low, high;
      std::string unit;
    };

    /** Of the length of the rod: to close it takes no small strain. */
    constexpr double widest_gap = 0.1;

    // softer than rubber, heavier than osmium, colder than any rod but in a
    // cryostat
    const Range ranges[] = {
      {"Boundary/sides/Surroundings", 150., infinity, "degC"},
      {"Boundary/left/Temperature", 150., infinity, "degC"},
      {"Boundary/right/Surroundings", 150., infinity, "degC"},
      {"Contact/Gap", -1., 1., "um"},
      {"Contact/Rear gap", -1., 1., "um"},
      {"Contact/Stiffness", 1e3, infinity, "N/mm"},
      {"Initial values/Temperature", 150., infinity, "degC"},
      {"Rod/Cross-section area", 0., 1., "mm^2"},
      {"Rod/Density", 20., infinity, "g/cm^3"},
      {"Rod/Density", 0., 3e4, "g/m^3"},
      {"Rod/Heat capacity", 10., infinity, "kJ/(kg K)"},
      {"Rod/Length", 0., 100., "mm"},
      {"Rod/Linear expansion", -1e-3, 1e-3, "um/(m K)"},
      {"Rod/Reference temperature", 150., infinity, "degC"},
      {"Rod/Young's modulus", 1e4, infinity, "GPa"},
      {"Rod/Young's modulus", 1e8, infinity, "MPa"}};
  } // namespace



  std::vector<std::string>
  implausible_numbers(const std::vector<Assignment> &assignments)
  {
    std::vector<std::string> doubts;
    if (!is_in_si(assignments))
      return doubts;
    // a stiffness of a power law has a unit that no number can carry
    const Assignment *const law =
      last_assignment(assignments, "Contact/Condition");
    const bool has_power = law != nullptr && law->value == "power law";
    for (const Range &range : ranges)
      {
        if (has_power && range.path == "Contact/Stiffness")
          continue;
        const Assignment *const last = last_assignment(assignments, range.path);
        const auto        split = last ? split_unit(last->value) : std::nullopt;
        const std::string begin = range.path + " = ";
        if (split && split->unit.empty() &&
            !(split->number >= range.low && split->number <= range.high) &&
            (doubts.empty() || !begins_with(doubts.back(), begin)))
          doubts.push_back(begin + last->value + ": is that in " +
                           unit_of_entry(range.path) + ", or " + last->value +
                           ' ' + range.unit +
                           "? With its unit it is not doubted");
      }
    const auto in_metres = [&](const std::string &path) {
      const Assignment *const last = last_assignment(assignments, path);
      const auto split = last ? split_unit(last->value) : std::nullopt;
      return !split ?
               nan :
             split->unit.empty() ?
               split->number :
               convert_unit(split->number, split->unit, "m").value_or(nan);
    };
    if (have_masses_alone(assignments))
      return doubts; // they have no strains
    const double length = in_metres("Rod/Length");
    for (const std::string path : {"Contact/Gap", "Contact/Rear gap"})
      if (const double gap = in_metres(path); gap > widest_gap * length)
        doubts.push_back(text(path,
                              " = ",
                              last_assignment(assignments, path)->value,
                              ": that is ",
                              significant(100. * gap / length, 2),
                              " % of Rod/Length, and the model is one of small "
                              "strains"));
    return doubts;
  }
} // namespace ThermoContact
