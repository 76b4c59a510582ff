// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/constants.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/measured_table.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/input/unit_text.h>
#include <thermocontact/input/unknown_names.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <optional>

namespace ThermoContact
{
  void
  set_entry(const Assignment &assignment, ParameterHandler &prm)
  {
    const std::string name = name_of(assignment.path);
    if (name == assignment.path)
      return prm.set(name, assignment.value);
    const SectionOfEntries section(prm, section_of(assignment.path));
    prm.set(name, assignment.value);
  }



  namespace
  {
    /** Whether the assignment is to an entry of the program. */
    bool
    is_program_entry(const Assignment &assignment)
    {
      return find_entry(assignment.path) != nullptr &&
             !is_constant_path(assignment.path);
    }



    /**
     * Refuses a section, an entry that is unknown or is set twice.
     *
     * @param places of the assignments before, by their paths
     */
    void
    check_name(const Assignment                   &assignment,
               std::map<std::string, std::string> &places)
    {
      if (assignment.is_section())
        return check_section(assignment.place, section_of(assignment.path));
      if (!is_constant_path(assignment.path) && !is_program_entry(assignment))
        refuse_entry(assignment);
      // The command line may override what a file sets, and itself; so may a
      // file what it includes.
      const auto file_of = [](const std::string &place) {
        return place.substr(0, place.rfind(", line "));
      };
      const auto [earlier, is_new] =
        places.emplace(assignment.path, assignment.place);
      if (!is_new && assignment.place != command_line_place &&
          file_of(earlier->second) == file_of(assignment.place))
        throw InputError(assignment.place + ": " + assignment.path +
                         " is set a second time, first at " + earlier->second +
                         "\n  remedy:  remove one of them");
    }



    bool
    has_table(const std::string &value)
    {
      const std::vector<std::string> names = identifiers_in(value);
      return std::any_of(names.begin(),
                         names.end(),
                         [](const std::string &name) {
                           return name == "table" || name == "smooth";
                         });
    }



    /** The entries that may be expressions in t. */
    std::vector<std::string>
    functions_of_time()
    {
      std::vector<std::string> paths;
      for (const DeclaredEntry &entry : entries_of_program())
        {
          const std::vector<std::string> variables = entry.variables(1);
          if (std::find(variables.begin(), variables.end(), "t") !=
              variables.end())
            paths.push_back(entry.path);
        }
      return paths;
    }



    /** The unit of the first number of a list of lengths. */
    std::string
    unit_of_first(const std::string &list)
    {
      const auto first = split_unit(list.substr(0, list.find_first_of(",;")));
      return first && !first->unit.empty() ? first->unit : "m";
    }



    /** The default of an entry; of a file in SI units what it is there. */
    std::string
    default_of(const DeclaredEntry &entry, const bool is_si)
    {
      const auto number = parse_number(entry.default_value);
      if (!is_si || entry.kind.empty() || section_of(entry.path) == "Rod" ||
          !number || (*number == 0. && entry.kind != "temperature"))
        return entry.default_value;
      return entry.path == "Output/Fields interval" ? "Time/End time / 20" :
             entry.kind == "temperature"        ? "Rod/Reference temperature" :
             begins_with(entry.path, "Bodies/") ? "that of section Rod" :
                                                  "none, in SI units";
    }



    /** Throws the fault of a value: as an expression, if it looks so. */
    [[noreturn]] void
    refuse_value(const Assignment                    &assignment,
                 const std::map<std::string, double> &constants,
                 const bool                           is_si)
    {
      const DeclaredEntry &entry   = entry_of_program(assignment.path);
      const std::string   &value   = assignment.value;
      const std::string    allowed = describe_allowed(entry);
      std::string          fault   = assignment.path + " = " + quote(value);
      if (is_numeric(entry))
        {
          if (has_table(value))
            fault += ": a table is a function, and this entry is one number; "
                     "functions of t are " +
                     join_words(functions_of_time());
          else if (!split_unit(value) &&
                   (!constants.empty() ||
                    value.find_first_of("*/^(+") != std::string::npos))
            try
              {
                fault += " = " + as_numbers(assignment, constants);
              }
            catch (const InputError &error)
              {
                fault = error.what();
                fault.erase(
                  std::min(fault.find("\n  allowed: "), fault.size()));
              }
          std::string with_point = value;
          std::replace(with_point.begin(), with_point.end(), ',', '.');
          if (with_point != value && parse_number(with_point))
            fault += "; did you mean " + with_point + "?";
          if (value.find(':') != std::string::npos)
            fault += "; ranges are for Study/Vary: 1e-3 .. 1 (7)";
        }
      else if (allowed.find(" | ") != std::string::npos)
        fault +=
          did_you_mean(value,
                       dealii::Utilities::split_string_list(allowed, '|'));
      throw InputError(assignment.place + ": " + fault + "\n  allowed: " +
                       allowed + "\n  meaning: " + entry.text +
                       "\n  default: " + default_of(entry, is_si));
    }



    /**
     * @param assignment as it was written
     * @param value of the scene: as in the statement, without its unit
     * @throw InputError as assign_entries()
     */
    void
    assign(const Assignment                    &assignment,
           const std::string                   &value,
           const std::map<std::string, double> &constants,
           ParameterHandler                    &prm)
    {
      const std::string &text = assignment.value;
      if (!is_plain_text(text) || text.find('#') != std::string::npos ||
          (!text.empty() && text.back() == '\\'))
        throw InputError(
          assignment.place + ": " + assignment.path + " = " + quote(text) +
          "\n  allowed: one line of text in UTF-8 without '#', not ending in "
          "'\\', since used.prm repeats it");
      try
        {
          set_entry({assignment.place, assignment.path, value}, prm);
        }
      catch (const dealii::ExceptionBase &)
        {
          refuse_value(assignment,
                       constants,
                       *parse_number(prm.get({"Rod"}, "Length")) > 0.);
        }
    }



    /** Reads the value of an entry that may be an expression. */
    void
    check_expression(const Assignment  &assignment,
                     const unsigned int dim,
                     ExpressionNames    names)
    {
      const DeclaredEntry &entry = entry_of_program(assignment.path);
      names.variables            = entry.variables(dim);
      const std::string &text    = assignment.value;
      const bool         is_word = begins_with(entry.pattern, "[" + text + ",");
      if (!names.variables.empty() && !is_word && !parse_number(text))
        read_components(assignment.path,
                        text,
                        1 + std::count(text.begin(), text.end(), ';'),
                        names);
    }
  } // namespace



  std::vector<Assignment>
  assign_entries(const std::vector<Assignment> &given,
                 ParameterHandler              &prm,
                 Parameters                    &parameters)
  {
    std::vector<std::string> faults;
    const auto               collect = [&](const auto &action) {
      try
        {
          action();
        }
      catch (const InputError &error)
        {
          faults.push_back(complete_message(error.what(), given, prm));
        }
    };
    collect([&]() { parameters.constants = assign_constants(given, prm); });
    collect([&]() { parameters.row.add_parameters(given, prm); });
    throw_faults(faults);
    const std::map<std::string, double> &constants = parameters.constants;
    parameters.folder                              = folder_of_tables(given);
    const std::vector<Assignment> assignments = with_numbers(given, constants);
    std::map<std::string, std::string> places;
    std::string unknown_section; // its entries are no faults of their own
    for (const Assignment &assignment : assignments)
      if (unknown_section.empty() ||
          !begins_with(assignment.path, unknown_section))
        {
          const std::size_t n_faults = faults.size();
          collect([&]() { check_name(assignment, places); });
          if (assignment.is_section() && faults.size() > n_faults)
            unknown_section = assignment.path;
        }
    const auto assign_if = [&](const auto &is_one, const auto &value) {
      for (unsigned int i = 0; i < assignments.size(); ++i)
        if (const Assignment &assignment = assignments[i];
            is_program_entry(assignment) && is_one(assignment.path) &&
            last_assignment(assignments, assignment.path) == &assignment)
          collect(
            [&]() { assign(given[i], value(assignment), constants, prm); });
    };
    const auto is_dimension = [](const std::string &path) {
      return path == "Dimension";
    };
    const auto is_rod_entry = [](const std::string &path) {
      return begins_with(path, "Rod/");
    };
    assign_if(is_dimension, without_unit);
    if (!is_in_si(assignments))
      {
        ExpressionNames names;
        names.constants        = constants;
        names.folder           = parameters.folder;
        names.checks_values    = false;
        const unsigned int dim = *parse_number(prm.get("Dimension"));
        assign_if([&](const std::string &path) { return !is_dimension(path); },
                  [&](const Assignment &assignment) {
                    refuse_units(assignment);
                    check_expression(assignment, dim, names);
                    return assignment.value;
                  });
        throw_faults(faults);
        return {};
      }
    assign_if(is_rod_entry, without_unit);
    for (unsigned int i = 0; i < assignments.size(); ++i)
      if (const DeclaredEntry *const entry = find_entry(assignments[i].path);
          entry != nullptr && !is_rod_entry(entry->path) &&
          is_numeric(*entry) && entry->variables(1).empty() &&
          has_table(assignments[i].value))
        collect([&]() { refuse_value(given[i], constants, true); });
    throw_faults(faults);
    std::optional<SiScene> scene;
    collect([&]() { scene.emplace(assignments, constants); });
    throw_faults(faults);
    assign_if([&](const std::string &path) { return !is_rod_entry(path); },
              [&](const Assignment &assignment) {
                return scene->value(assignment);
              });
    throw_faults(faults);
    if (const Assignment *const probes =
          last_assignment(assignments, "Output/Probes"))
      parameters.output.unit_of_probes = unit_of_first(probes->value);
    const std::vector<Assignment> derived = scene->derived();
    for (const Assignment &assignment : derived)
      assign(assignment, assignment.value, constants, prm);
    return derived;
  }



  namespace
  {
    /**
     * Gives a message that begins with the value of an entry the value as the
     * file has it, with its unit.
     */
    void
    replace_value(const DeclaredEntry           &entry,
                  const std::vector<Assignment> &assignments,
                  std::string                   &message)
    {
      const std::string       head = entry.path + " = ";
      const Assignment *const last = last_assignment(assignments, entry.path);
      if (last == nullptr || !begins_with(message, head))
        return;
      const std::string rest  = message.substr(head.size()),
                        shown = quote(entry.value), given = quote(last->value);
      const std::string behind =
        rest.substr(std::min(given.size(), rest.size()), 1);
      // 1 is no beginning of 1.5
      if (!begins_with(rest, given) ||
          std::string(" \n:").find(behind) == std::string::npos)
        message.replace(head.size(),
                        begins_with(rest, shown) ? shown.size() :
                                                   rest.find_first_of(" \n:"),
                        given);
    }
  } // namespace



  std::string
  complete_message(const std::string             &message,
                   const std::vector<Assignment> &assignments,
                   const ParameterHandler        &prm)
  {
    const auto is_about = [&message](const std::string &path) {
      return begins_with(message, path + " =") ||
             begins_with(message, path + ":");
    };
    std::string place, reason;
    for (const Assignment &assignment : assignments)
      if (begins_with(message, assignment.place + ": ") ||
          message.find('\n' + assignment.place + ": ") != std::string::npos)
        return message; // complete, or several that are
      else if (is_about(assignment.path))
        place = assignment.place + ": ";
      else if (reason.empty() && !assignment.is_section() &&
               message.find(assignment.path + " = " + assignment.value) !=
                 std::string::npos)
        reason = assignment.place + ": "; // why a default value is wrong

    std::string complete = message, meaning;
    const bool  has_meaning =
      message.find("\n  meaning: ") != std::string::npos ||
      message.find(" has no effect") != std::string::npos;
    for (const DeclaredEntry &entry : declared_entries(prm))
      if (is_about(entry.path))
        {
          if (is_in_si(assignments))
            replace_value(entry, assignments, complete);
          meaning = has_meaning ? "" : "\n  meaning: " + entry.text;
        }
    return (place.empty() ? reason : place) + complete + meaning;
  }



  std::map<std::string, std::string>
  entry_values(const ParameterHandler &prm)
  {
    std::map<std::string, std::string> values;
    for (const DeclaredEntry &entry : declared_entries(prm))
      values.emplace(entry.path, entry.value);
    return values;
  }



  bool
  equal_values(const std::string &a, const std::string &b)
  {
    if (a == b)
      return true;
    const auto number = parse_number(a);
    return number && number == parse_number(b);
  }



  void
  write_entries(const std::vector<DeclaredEntry> &entries,
                const std::set<std::string>      &omit,
                std::ostream                     &output)
  {
    std::string open_section;
    for (const DeclaredEntry &entry : entries)
      {
        if (omit.count(entry.path) != 0 || is_template_path(entry.path) ||
            entry.path == "Constants/" + name_of_constants)
          continue;
        const std::string section = section_of(entry.path);
        if (section != open_section)
          {
            if (!open_section.empty())
              output << "end\n";
            if (!section.empty())
              output << "subsection " << section << '\n';
            open_section = section;
          }
        output << (section.empty() ? "" : "  ")
               << (entry.is_remark ? "# set " : "set ") << name_of(entry.path)
               << " = " << entry.value
               << (entry.remark.empty() ? "" : " # " + entry.remark) << '\n';
      }
    if (!open_section.empty())
      output << "end\n";
  }
} // namespace ThermoContact
