// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/constants.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>
#include <thermocontact/input/unknown_names.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <functional>
#include <sstream>

namespace ThermoContact
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    const std::string constants_section = "Constants";



    std::string
    constant_name(const std::string &path)
    {
      return path.substr(constants_section.size() + 1);
    }



    /** True for a word of letters, digits and '_' that means nothing else. */
    bool
    can_name_constant(const std::string &name)
    {
      std::vector<std::string> taken = Expression::function_names();
      for (const char *const variable : {"x",
                                         "y",
                                         "z",
                                         "t",
                                         "gap",
                                         "pressure",
                                         "theta_A",
                                         "pi",
                                         "_pi",
                                         "_e"})
        taken.emplace_back(variable);
      return identifiers_in(name) == std::vector<std::string>{name} &&
             name.find('.') == std::string::npos &&
             std::find(taken.begin(), taken.end(), name) == taken.end();
    }



    void
    check_constant(const Assignment &constant)
    {
      const std::string name = constant_name(constant.path);
      if (name == name_of_constants || !can_name_constant(name))
        refuse(constant,
               name == name_of_constants ?
                 "NAME stands for a name of yours" :
                 "'" + quote(name) + "' cannot be the name of a constant",
               "letters, digits and '_' that begin with a letter, and are no "
               "function, variable or pi",
               "");
    }



    /** One that the file has not, and that nobody names, is a misprint. */
    void
    check_use(const Assignment              &constant,
              const std::vector<Assignment> &assignments)
    {
      const std::string        name = constant_name(constant.path);
      std::vector<std::string> known;
      for (const Assignment &other : assignments)
        {
          const std::vector<std::string> names = identifiers_in(other.value);
          if ((other.path == constant.path &&
               other.place != command_line_place) ||
              std::find(names.begin(), names.end(), name) != names.end())
            return;
          if (is_constant_path(other.path) && other.path != constant.path)
            known.push_back(constant_name(other.path));
        }
      refuse(constant,
             "no entry names " + name + did_you_mean(name, known),
             "",
             "a constant that an expression or a number of the file names");
    }



    /** The values of constants, by the texts that stand for them. */
    std::map<std::string, double>
    evaluate_constants(const std::map<std::string, std::string> &texts)
    {
      std::map<std::string, double>                  known;
      std::vector<std::string>                       open; // being evaluated
      const std::function<void(const std::string &)> evaluate =
        [&](const std::string &name) {
          if (known.count(name) > 0)
            return;
          const std::string path = "Constants/" + name, &text = texts.at(name);
          const auto        first = std::find(open.begin(), open.end(), name);
          if (first != open.end())
            {
              std::string circle;
              for (auto other = first; other != open.end(); ++other)
                circle += *other + " -> ";
              throw InputError(
                path + " = " + quote(text) +
                ": it depends on itself: " + circle + name +
                "\n  allowed: numbers, or expressions in other constants");
            }
          open.push_back(name);
          for (const std::string &other : identifiers_in(text))
            if (texts.count(other) > 0)
              evaluate(other);
          known[name] =
            Expression(path, text, {{}, known}).evaluate<double>(nullptr);
          open.pop_back();
        };
      // numbers first, so that a misprint of their names is answered with them
      for (const bool is_number : {true, false})
        for (const auto &[name, text] : texts)
          if (parse_number(text).has_value() == is_number)
            evaluate(name);
      return known;
    }
  } // namespace



  bool
  is_constant_path(const std::string &path)
  {
    return begins_with(path, constants_section + "/") &&
           path.size() > constants_section.size() + 1;
  }



  std::map<std::string, double>
  assign_constants(const std::vector<Assignment> &assignments,
                   dealii::ParameterHandler      &prm)
  {
    std::map<std::string, std::string> texts;
    for (const Assignment &assignment : assignments)
      {
        if (!is_constant_path(assignment.path))
          continue;
        check_constant(assignment);
        texts[constant_name(assignment.path)] = assignment.value;
        if (assignment.place == command_line_place)
          check_use(assignment, assignments);
      }
    const SectionOfEntries section(prm, constants_section);
    for (const auto &[name, text] : texts)
      try
        {
          prm.set(name, text);
        }
      catch (const ParameterHandler::ExcEntryUndeclared &)
        {
          prm.declare_entry(name, "", Patterns::Anything(), "A constant.");
          prm.set(name, text);
        }
    return evaluate_constants(texts);
  }



  std::string
  as_numbers(const Assignment                    &assignment,
             const std::map<std::string, double> &constants)
  {
    std::string        numbers;
    std::istringstream list(assignment.value);
    for (std::string item; std::getline(list, item, ';');)
      {
        item = dealii::Utilities::trim(item);
        if (!parse_number(item))
          item = significant(Expression(assignment.path, item, {{}, constants})
                               .evaluate<double>(nullptr),
                             all_digits);
        numbers += (numbers.empty() ? "" : "; ") + item;
      }
    return numbers;
  }



  bool
  is_numeric(const DeclaredEntry &entry)
  {
    return entry.pattern.find("Double") != std::string::npos ||
           entry.pattern.find("Integer") != std::string::npos;
  }



  std::vector<Assignment>
  with_numbers(std::vector<Assignment>              assignments,
               const std::map<std::string, double> &constants)
  {
    for (Assignment &assignment : assignments)
      if (const DeclaredEntry *const entry = find_entry(assignment.path);
          entry != nullptr && is_numeric(*entry) &&
          !parse_number(assignment.value) &&
          assignment.value.find_first_not_of(" \t") != std::string::npos)
        try
          {
            assignment.value = as_numbers(assignment, constants);
          }
        catch (const InputError &)
          {} // a word, a unit, an expression in t, or a fault
    return assignments;
  }
} // namespace ThermoContact
