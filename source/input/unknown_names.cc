// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/scope_page.h>
#include <thermocontact/input/unknown_names.h>

#include <deal.II/base/table.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace ThermoContact
{
  namespace
  {
    /** The sections, in the order of declaration. */
    std::vector<std::string>
    declared_sections()
    {
      std::vector<std::string> sections;
      for (const DeclaredEntry &entry : entries_of_program())
        if (const std::string section = section_of(entry.path);
            !section.empty() &&
            (sections.empty() || sections.back() != section))
          sections.push_back(section);
      return sections;
    }



    /** Whether it is a section, or one that has others; "": outside of all. */
    bool
    is_section(const std::string &any_name)
    {
      const std::string name     = declared_path(any_name);
      const auto        sections = declared_sections();
      return std::any_of(sections.begin(),
                         sections.end(),
                         [&name](const std::string &known) {
                           return name.empty() ||
                                  begins_with(known + "/", name + "/");
                         });
    }



    /** The entries of a section, or nothing if there is no such section. */
    std::string
    list_entries(const std::string &section)
    {
      std::string names;
      for (const DeclaredEntry &entry : entries_of_program())
        if (section_of(entry.path) == declared_path(section))
          names += (names.empty() ? "" : ", ") + name_of(entry.path);
      return names;
    }



    /**
     * Number of insertions, deletions, substitutions and exchanges of
     * neighbours that turn one name into the other, each letter changed once;
     * upper and lower case are the same.
     */
    unsigned int
    edit_distance(const std::string &a, const std::string &b)
    {
      dealii::Table<2, unsigned int> distance(a.size() + 1, b.size() + 1);
      const auto are_same = [&](const unsigned int i, const unsigned int j) {
        return std::tolower(a[i - 1]) == std::tolower(b[j - 1]);
      };
      for (unsigned int i = 0; i <= a.size(); ++i)
        for (unsigned int j = 0; j <= b.size(); ++j)
          {
            unsigned int &d = distance(i, j);
            if (i == 0 || j == 0)
              d = i + j;
            else
              d = std::min({distance(i - 1, j) + 1,
                            distance(i, j - 1) + 1,
                            distance(i - 1, j - 1) + (are_same(i, j) ? 0 : 1)});
            if (i > 1 && j > 1 && are_same(i - 1, j) && are_same(i, j - 1))
              d = std::min(d, distance(i - 2, j - 2) + 1);
          }
      return distance(a.size(), b.size());
    }



    /**
     * The one of @p known that @p path most likely means, or nothing if none is
     * near: one letter of three of the name of the entry may be wrong, and its
     * section counts as one.
     */
    std::string
    nearest(const std::string &path, const std::vector<std::string> &known)
    {
      const std::string name = name_of(path), section = section_of(path);
      std::string       result;
      unsigned int      least = (name.size() + 1) / 3 + 1;
      if (path.size() <= 100) // no typo, and the distance takes long
        for (const std::string &other : known)
          if (const unsigned int d =
                edit_distance(name, name_of(other)) +
                (edit_distance(section, section_of(other)) == 0 ? 0 : 1);
              d < least)
            {
              least  = d;
              result = other;
            }
      return result;
    }



    /** The entry that says what these words ask for, or nothing. */
    std::string
    entry_of_other_words(const std::string &name)
    {
      static const std::map<std::string, std::string> entries = {
        {"Fixed end temperature", "Boundary/left/Temperature"},
        {"Fixed end displacement", "Boundary/left/Displacement"},
        {"Fixed end support", "Boundary/left/Support"},
        {"Heat exchange", "Boundary/right/Heat exchange"},
        {"Obstacle temperature", "Boundary/right/Surroundings"},
        {"Lateral support", "Boundary/sides/Support"},
        {"Lateral heat exchange", "Boundary/sides/Heat exchange"},
        {"Ambient temperature", "Boundary/sides/Surroundings"},
        {"End traction", "Boundary/right/Traction"},
        {"End heat flux", "Boundary/right/Heat flux"}};
      const auto found = entries.find(name);
      return found == entries.end() ? "" : found->second;
    }



    /** Whether the entry is there, in one other section. */
    bool
    is_in_one_section(const std::string              &path,
                      const std::vector<std::string> &known)
    {
      return std::count_if(
               known.begin(), known.end(), [&path](const std::string &other) {
                 return edit_distance(name_of(path), name_of(other)) == 0;
               }) == 1;
    }
  } // namespace



  std::string
  did_you_mean(const std::string &name, const std::vector<std::string> &known)
  {
    const std::string near = nearest(name, known);
    return near.empty() ? "" : "; did you mean " + near + "?";
  }



  std::string
  section_of(const std::string &path)
  {
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
  }



  std::string
  name_of(const std::string &path)
  {
    return path.substr(path.rfind('/') + 1);
  }



  void
  check_section(const std::string &place, const std::string &section)
  {
    if (is_section(section))
      return;
    const auto sections = declared_sections();
    if (const std::string answer = scope_answer(section); !answer.empty())
      throw InputError(place + ": there is no section " + quote(section) +
                       answer);
    std::string remedy, all;
    if (const std::string near = nearest(section, sections); !near.empty())
      remedy = "did you mean " + near + "? ";
    for (const std::string &known : sections)
      {
        all += (all.empty() ? "" : ", ") + known;
        if (begins_with(section, known + "/"))
          remedy = "close section " + known + " with 'end' first; ";
      }
    throw InputError(place + ": there is no section " + quote(section) +
                     "\n  remedy:  " + remedy + "sections are " + all);
  }



  void
  refuse_entry(const Assignment &assignment)
  {
    const std::string        section = section_of(assignment.path);
    const std::string        all     = list_entries(section);
    std::vector<std::string> paths, of_any_name;
    for (const DeclaredEntry &entry : entries_of_program())
      if (!is_template_path(entry.path))
        paths.push_back(entry.path);
      else if (section_of(entry.path) == declared_path(section))
        paths.push_back(section + "/" + name_of(entry.path));
      else
        of_any_name.push_back(entry.path);
    paths.insert(paths.end(), of_any_name.begin(), of_any_name.end());
    const std::string other = entry_of_other_words(name_of(assignment.path));
    const std::string near =
      other.empty() ? nearest(assignment.path, paths) : other;
    const std::string answer =
      !other.empty() || is_in_one_section(assignment.path, paths) ?
        "" :
        scope_answer(name_of(assignment.path));
    if (near.empty() && answer.empty())
      check_section(assignment.place, section);
    const std::string fault =
      !is_section(section) ? "there is no section " + quote(section) :
      section.empty()      ? "there is no entry " + quote(assignment.path) +
                          " outside of the sections" :
                        "section " + section + " has no entry " +
                          quote(name_of(assignment.path));
    if (!answer.empty())
      throw InputError(assignment.place + ": " + fault + answer);
    throw InputError(assignment.place + ": " + fault + "\n  remedy:  " +
                     (near.empty() ? "entries there are " + all :
                                     "did you mean " + near +
                                       "? --print-parameters lists all "
                                       "entries"));
  }
} // namespace ThermoContact
