// SPDX-License-Identifier: LGPL-2.1-or-later

#include "parameter_file.h"

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "edit_distance.h"
#include "exceptions.h"

namespace ThermoContact
{
  namespace
  {
    using dealii::Utilities::trim;
    using Json = nlohmann::ordered_json;

    /** What a ParameterHandler says about one entry. */
    struct Entry
    {
      std::string path;
      std::string value;
      std::string default_value;
      std::string text;
      std::string pattern;
    };



    void
    collect_entries(const Json         &node,
                    const std::string  &prefix,
                    std::vector<Entry> &entries)
    {
      for (const auto &item : node.items())
        if (item.value().contains("pattern_description"))
          entries.push_back({prefix + item.key(),
                             item.value().at("value"),
                             item.value().at("default_value"),
                             item.value().at("documentation"),
                             item.value().at("pattern_description")});
        else
          collect_entries(item.value(), prefix + item.key() + "/", entries);
    }



    /** All declared entries, in the order of declaration. */
    std::vector<Entry>
    declared_entries(const ParameterHandler &prm)
    {
      std::stringstream text;
      prm.print_parameters(text,
                           ParameterHandler::JSON |
                             ParameterHandler::KeepDeclarationOrder);
      std::vector<Entry> entries;
      collect_entries(Json::parse(text), "", entries);
      return entries;
    }



    /**
     * Asks for the known path that @p path most likely means: nearest in
     * letters, where the right entry name in a wrong section counts as near.
     * Nothing if none is near.
     */
    std::string
    suggest_path(const std::string &path, const std::vector<Entry> &entries)
    {
      const auto name = [](const std::string &p) {
        return p.substr(p.rfind('/') + 1);
      };
      const auto distance = [&](const Entry &entry) {
        return std::min(edit_distance(path, entry.path),
                        1 + edit_distance(name(path), name(entry.path)));
      };
      const auto nearest =
        std::min_element(entries.begin(),
                         entries.end(),
                         [&](const Entry &a, const Entry &b) {
                           return distance(a) < distance(b);
                         });
      return distance(*nearest) <= path.size() / 3 ?
               "did you mean " + nearest->path + "? " :
               "";
    }



    /** "[Double 0...MAX_DOUBLE (inclusive)]" in words. */
    std::string
    describe_pattern(std::string pattern)
    {
      const auto replace = [&pattern](const std::string &from,
                                      const std::string &to) {
        for (auto at = pattern.find(from); at != std::string::npos;
             at      = pattern.find(from, at + to.size()))
          pattern.replace(at, from.size(), to);
      };
      replace("[", "");
      replace("]", "");
      replace(" (inclusive)", "");
      replace("-MAX_DOUBLE...MAX_DOUBLE", "");
      replace("...MAX_DOUBLE", " or more");
      replace("...", " to ");
      const bool is_range = pattern.find(" to ") != std::string::npos;
      replace("Integer range", "Integer");
      replace("Double", is_range ? "a number from" : "a number");
      replace("Integer", is_range ? "a whole number from" : "a whole number");
      replace("Bool", "true | false");
      replace("Anything", "any text");
      if (pattern.rfind("Selection ", 0) == 0)
        {
          pattern.erase(0, std::strlen("Selection "));
          replace("|", " | ");
        }
      return trim(pattern);
    }



    void
    set_entry(const Assignment &assignment, ParameterHandler &prm)
    {
      const auto slash = assignment.path.rfind('/');
      if (slash == std::string::npos)
        prm.set(assignment.path, assignment.value);
      else
        {
          // leave the section again whatever happens to the value
          prm.enter_subsection(assignment.path.substr(0, slash));
          try
            {
              prm.set(assignment.path.substr(slash + 1), assignment.value);
            }
          catch (...)
            {
              prm.leave_subsection();
              throw;
            }
          prm.leave_subsection();
        }
    }



    std::string
    join_path(const std::vector<std::string> &sections, const std::string &name)
    {
      std::string path;
      for (const std::string &section : sections)
        path += section + "/";
      return path + name;
    }
  } // namespace



  std::vector<Assignment>
  read_assignments(std::istream &input, const std::string &name)
  {
    std::vector<Assignment>  assignments;
    std::vector<std::string> sections;
    std::string              line, physical_line;
    unsigned int             n_lines = 0;

    while (std::getline(input, physical_line))
      {
        ++n_lines;
        const std::string place = name + ", line " + std::to_string(n_lines);
        const auto        fail  = [&place](const std::string &fault,
                                   const std::string &remedy) {
          throw InputError(place + ": " + fault + "\n  remedy:  " + remedy);
        };

        if (physical_line.find('\0') != std::string::npos)
          fail("not a text file", "give a parameter file");
        line += physical_line.substr(0, physical_line.find('#'));
        if (const std::string trimmed = trim(line);
            !trimmed.empty() && trimmed.back() == '\\')
          {
            line = trimmed.substr(0, trimmed.size() - 1) + " ";
            continue;
          }
        const std::string statement = trim(line);
        line.clear();
        if (statement.empty())
          continue;

        const auto        blank = statement.find_first_of(" \t");
        const std::string verb  = statement.substr(0, blank);
        const std::string rest =
          blank == std::string::npos ? "" : trim(statement.substr(blank));
        const auto equal_sign = rest.find('=');

        if (verb == "subsection" && !rest.empty())
          sections.push_back(rest);
        else if (verb == "end" && rest.empty())
          {
            if (sections.empty())
              fail("'end' without 'subsection'", "remove the line");
            sections.pop_back();
          }
        else if (verb == "set" && equal_sign != std::string::npos)
          assignments.push_back(
            {place,
             join_path(sections, trim(rest.substr(0, equal_sign))),
             trim(rest.substr(equal_sign + 1))});
        else
          fail("cannot read '" + statement.substr(0, 60) + "'",
               "a line is 'set Entry = value', 'subsection Name', 'end', a "
               "comment after '#', or empty");
      }

    if (!trim(line).empty())
      throw InputError(name + ": the last line ends in '\\'\n  remedy:  "
                              "complete the line or remove the '\\'");
    if (!sections.empty())
      throw InputError(name + ": 'end' is missing for subsection " +
                       sections.back() +
                       "\n  remedy:  close each subsection with 'end'");
    return assignments;
  }



  std::string
  read_text(const std::string &file_name)
  {
    if (std::filesystem::is_directory(file_name))
      throw InputError(file_name + ": is a directory\n  remedy:  give a "
                                   "parameter file (.prm)");
    std::ifstream input(file_name);
    if (!input)
      throw InputError(file_name +
                       ": cannot be opened: " + std::strerror(errno) +
                       "\n  remedy:  check the path of the parameter file");
    std::ostringstream text;
    if (input.peek() != EOF)
      text << input.rdbuf();
    if (input.bad() || text.fail())
      throw InputError(file_name + ": cannot be read to its end\n  remedy:  "
                                   "check the file and the disk");
    return text.str();
  }



  Assignment
  parse_override(const std::string &argument)
  {
    const auto equal_sign = argument.find('=');
    if (equal_sign == std::string::npos)
      throw InputError("--set " + argument +
                       ": no '='\n  allowed: --set 'Section/Entry=value'");
    return {command_line_place,
            trim(argument.substr(0, equal_sign)),
            trim(argument.substr(equal_sign + 1))};
  }



  void
  assign_entries(const std::vector<Assignment> &assignments,
                 ParameterHandler              &prm)
  {
    const std::vector<Entry>           entries = declared_entries(prm);
    std::map<std::string, std::string> places;

    for (const Assignment &assignment : assignments)
      {
        const auto entry =
          std::find_if(entries.begin(), entries.end(), [&](const Entry &e) {
            return e.path == assignment.path;
          });
        if (entry == entries.end())
          throw InputError(
            assignment.place + ": unknown entry " + assignment.path +
            "\n  remedy:  " + suggest_path(assignment.path, entries) +
            "--print-parameters lists all entries");

        // The command line may override what a file sets, and itself.
        const bool is_override = assignment.place == command_line_place;
        const auto [earlier, is_new] =
          places.emplace(assignment.path, assignment.place);
        if (!is_new && !is_override)
          throw InputError(assignment.place + ": " + assignment.path +
                           " is set a second time, first at " +
                           earlier->second + "\n  remedy:  remove one of them");

        if (assignment.value.find_first_of("#\n") != std::string::npos ||
            (!assignment.value.empty() && assignment.value.back() == '\\'))
          throw InputError(assignment.place + ": " + assignment.path + " = " +
                           assignment.value +
                           "\n  allowed: one line without '#', not ending in "
                           "'\\', since used.prm repeats it");

        try
          {
            set_entry(assignment, prm);
          }
        catch (const dealii::ExceptionBase &)
          {
            throw InputError(assignment.place + ": " + assignment.path + " = " +
                             assignment.value + "\n  allowed: " +
                             describe_pattern(entry->pattern) +
                             "\n  meaning: " + entry->text +
                             "\n  default: " + entry->default_value);
          }
      }
  }



  std::string
  add_place(const std::string             &message,
            const std::vector<Assignment> &assignments)
  {
    for (auto a = assignments.rbegin(); a != assignments.rend(); ++a)
      if (message.rfind(a->path + " =", 0) == 0 ||
          message.rfind(a->path + ":", 0) == 0)
        return a->place + ": " + message;
    return message;
  }



  std::map<std::string, std::string>
  entry_values(const ParameterHandler &prm)
  {
    std::map<std::string, std::string> values;
    for (const Entry &entry : declared_entries(prm))
      values.emplace(entry.path, entry.value);
    return values;
  }



  bool
  equal_values(const std::string &a, const std::string &b)
  {
    if (a == b)
      return true;
    std::istringstream stream_a(a), stream_b(b);
    double             number_a = 0., number_b = 0.;
    return (stream_a >> number_a) && (stream_b >> number_b) &&
           stream_a.peek() == EOF && stream_b.peek() == EOF &&
           number_a == number_b;
  }



  void
  check_unused_entries(const Parameters &parameters, ParameterHandler &prm)
  {
    const std::vector<Entry> entries = declared_entries(prm);
    for (const Parameters::UnusedEntry &unused : parameters.unused_entries())
      for (const Entry &entry : entries)
        if (entry.path == unused.path &&
            !equal_values(entry.value, entry.default_value))
          throw InputError(entry.path + " = " + entry.value +
                           " has no effect, since " + unused.reason +
                           "\n  remedy:  remove the entry or change " +
                           unused.reason.substr(0, unused.reason.find(" =")));
  }



  void
  write_entries(const ParameterHandler      &prm,
                const std::set<std::string> &omit,
                std::ostream                &output)
  {
    std::string open_section;
    for (const Entry &entry : declared_entries(prm))
      {
        if (omit.count(entry.path) != 0)
          continue;
        const auto        slash = entry.path.find('/');
        const std::string section =
          slash == std::string::npos ? "" : entry.path.substr(0, slash);
        if (section != open_section)
          {
            if (!open_section.empty())
              output << "end\n";
            if (!section.empty())
              output << "subsection " << section << '\n';
            open_section = section;
          }
        output << (section.empty() ? "" : "  ") << "set "
               << entry.path.substr(section.empty() ? 0 : slash + 1) << " = "
               << entry.value << '\n';
      }
    if (!open_section.empty())
      output << "end\n";
  }
} // namespace ThermoContact
