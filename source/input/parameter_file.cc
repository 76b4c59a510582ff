// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/unknown_names.h>

#include <algorithm>
#include <map>

namespace ThermoContact
{
  namespace
  {
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
  } // namespace



  void
  assign_entries(const std::vector<Assignment> &assignments,
                 ParameterHandler              &prm)
  {
    assign_entries(assignments, declared_entries(prm), prm);
  }



  void
  assign_entries(const std::vector<Assignment>    &assignments,
                 const std::vector<DeclaredEntry> &entries,
                 ParameterHandler                 &prm)
  {
    std::map<std::string, std::string> places;

    for (const Assignment &assignment : assignments)
      {
        if (assignment.is_section())
          {
            check_section(assignment.place,
                          section_of(assignment.path),
                          entries);
            continue;
          }
        const auto entry = std::find_if(entries.begin(),
                                        entries.end(),
                                        [&](const DeclaredEntry &e) {
                                          return e.path == assignment.path;
                                        });
        if (entry == entries.end())
          refuse_entry(assignment, entries);

        // The command line may override what a file sets, and itself.
        const bool is_override = assignment.place == command_line_place;
        const auto [earlier, is_new] =
          places.emplace(assignment.path, assignment.place);
        if (!is_new && !is_override)
          throw InputError(assignment.place + ": " + assignment.path +
                           " is set a second time, first at " +
                           earlier->second + "\n  remedy:  remove one of them");

        const std::string statement = assignment.place + ": " +
                                      assignment.path + " = " +
                                      quote(assignment.value);
        if (!is_plain_text(assignment.value) ||
            assignment.value.find('#') != std::string::npos ||
            (!assignment.value.empty() && assignment.value.back() == '\\'))
          throw InputError(statement +
                           "\n  allowed: one line of text in UTF-8 without "
                           "'#', not ending in '\\', since used.prm repeats "
                           "it");

        try
          {
            set_entry(assignment, prm);
          }
        catch (const dealii::ExceptionBase &)
          {
            throw InputError(
              statement + "\n  allowed: " + describe_pattern(entry->pattern) +
              "\n  meaning: " + entry->text +
              "\n  default: " + entry->default_value);
          }
      }
  }



  std::string
  complete_message(const std::string             &message,
                   const std::vector<Assignment> &assignments,
                   const ParameterHandler        &prm)
  {
    const auto is_about = [&message](const std::string &path) {
      return message.rfind(path + " =", 0) == 0 ||
             message.rfind(path + ":", 0) == 0;
    };
    std::string place;
    for (const Assignment &assignment : assignments)
      if (is_about(assignment.path))
        place = assignment.place + ": ";
    // a default value that something else makes wrong
    for (const Assignment &assignment : assignments)
      if (place.empty() && !assignment.is_section() &&
          message.find(assignment.path + " = " + assignment.value) !=
            std::string::npos)
        place = assignment.place + ": ";

    std::string meaning;
    if (message.find("\n  meaning: ") == std::string::npos &&
        message.find(" has no effect") == std::string::npos)
      for (const DeclaredEntry &entry : declared_entries(prm))
        if (is_about(entry.path))
          meaning = "\n  meaning: " + entry.text;
    return place + message + meaning;
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
