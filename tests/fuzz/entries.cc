// SPDX-License-Identifier: LGPL-2.1-or-later

#include "entries.h"

#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /** "Contact/" of "Contact/Gap"; nothing outside sections. */
    std::string
    section_of(const std::string &path)
    {
      return path.substr(0, path.find('/') + 1);
    }



    /** The name that a line sets; nothing if it sets none. */
    std::string
    name_of(const std::string &line)
    {
      std::istringstream stream(line.substr(0, line.find('=')));
      std::string        verb, name;
      stream >> verb;
      if (verb != "set")
        return "";
      for (std::string word; stream >> word;)
        name += (name.empty() ? "" : " ") + word;
      return name;
    }
  } // namespace



  std::vector<Assignment>
  statements(const std::string &text)
  {
    std::istringstream stream(text);
    return read_assignments(stream, "fuzz.prm");
  }



  std::vector<Group>
  listed_values(const std::string &file_name)
  {
    const std::string  separator = " & ";
    std::istringstream lines(read_text(FUZZ_DIR "/" + file_name));
    std::vector<Group> groups;
    for (std::string line; std::getline(lines, line);)
      {
        if (line.empty() || line[0] == '#')
          continue;
        groups.emplace_back();
        for (std::size_t begin = 0, end = 0; end != std::string::npos;
             begin = end + separator.size())
          {
            end = line.find(separator, begin);
            groups.back().push_back(
              parse_override(line.substr(begin, end - begin)));
          }
      }
    return groups;
  }



  std::string
  with_entry(const std::string &text, const Assignment &entry)
  {
    const std::string  section = section_of(entry.path);
    const std::string  name    = entry.path.substr(section.size());
    const std::string  set     = "set " + name + " = " + entry.value + "\n";
    std::string        result  = section.empty() ? set : "";
    std::string        at; // the section of the line
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      {
        std::istringstream words(line);
        std::string        verb, title;
        words >> verb;
        if (verb == "subsection" && std::getline(words >> std::ws, title))
          at = title + '/';
        else if (verb == "end")
          at.clear();
        const bool is_replaced = at == section && name_of(line) == name;
        while (is_replaced && line.back() == '\\' && std::getline(lines, line))
          {}
        if (!is_replaced)
          result += line + '\n';
      }
    if (!section.empty())
      result += "subsection " + section.substr(0, section.size() - 1) + "\n  " +
                set + "end\n";
    return result;
  }
} // namespace ThermoContact
