// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/unknown_names.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace ThermoContact
{
  namespace
  {
    std::string
    name_of(const std::string &path)
    {
      return path.substr(path.rfind('/') + 1);
    }



    /** The sections, in the order of declaration. */
    std::vector<std::string>
    declared_sections(const std::vector<DeclaredEntry> &entries)
    {
      std::vector<std::string> sections;
      for (const DeclaredEntry &entry : entries)
        if (const std::string section = section_of(entry.path);
            !section.empty() &&
            (sections.empty() || sections.back() != section))
          sections.push_back(section);
      return sections;
    }



    /** The entries of a section, or nothing if there is no such section. */
    std::string
    list_entries(const std::string                &section,
                 const std::vector<DeclaredEntry> &entries)
    {
      std::string names;
      for (const DeclaredEntry &entry : entries)
        if (section_of(entry.path) == section)
          names += (names.empty() ? "" : ", ") + name_of(entry.path);
      return names;
    }



    /**
     * Number of single-letter insertions, deletions and substitutions that turn
     * one name into the other (Levenshtein distance); upper and lower case are
     * the same.
     */
    unsigned int
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<unsigned int> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0u);
      for (unsigned int i = 0; i < a.size(); ++i)
        {
          unsigned int diagonal = row[0]++;
          for (unsigned int j = 0; j < b.size(); ++j)
            {
              const unsigned int substituted =
                diagonal + (std::tolower(a[i]) == std::tolower(b[j]) ? 0 : 1);
              diagonal   = row[j + 1];
              row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
            }
        }
      return row.back();
    }



    bool
    is_near(const unsigned int distance, const std::string &name)
    {
      return distance <= name.size() / 3;
    }



    /**
     * The known path that @p path most likely means: nearest in letters, where
     * the right entry name in a wrong section counts as near. Nothing if none
     * is near.
     */
    std::string
    suggest_path(const std::string                &path,
                 const std::vector<DeclaredEntry> &entries)
    {
      if (path.size() > 100)
        return ""; // no typo, and the distance takes long
      const auto distance = [&path](const DeclaredEntry &entry) {
        return std::min(edit_distance(path, entry.path),
                        1 + edit_distance(name_of(path), name_of(entry.path)));
      };
      const auto nearest =
        std::min_element(entries.begin(),
                         entries.end(),
                         [&](const DeclaredEntry &a, const DeclaredEntry &b) {
                           return distance(a) < distance(b);
                         });
      return is_near(distance(*nearest), path) ? nearest->path : "";
    }

  } // namespace



  std::string
  did_you_mean(const std::string &name, const std::vector<std::string> &known)
  {
    if (name.size() > 100 || known.empty())
      return ""; // no typo, and the distance takes long
    const auto nearest =
      std::min_element(known.begin(),
                       known.end(),
                       [&](const std::string &a, const std::string &b) {
                         return edit_distance(name, a) < edit_distance(name, b);
                       });
    // one letter of two may be wrong
    return edit_distance(name, *nearest) <= (name.size() + 1) / 3 ?
             "; did you mean " + *nearest + "?" :
             "";
  }



  std::string
  section_of(const std::string &path)
  {
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
  }



  void
  check_section(const std::string                &place,
                const std::string                &section,
                const std::vector<DeclaredEntry> &entries)
  {
    if (!list_entries(section, entries).empty())
      return;
    const auto  sections = declared_sections(entries);
    std::string remedy, all;
    for (const std::string &known : sections)
      {
        all += (all.empty() ? "" : ", ") + known;
        if (section.size() <= 100 &&
            is_near(edit_distance(section, known), known))
          remedy = "did you mean " + known + "? ";
        if (section.rfind(known + "/", 0) == 0)
          remedy = "close section " + known + " with 'end' first; ";
      }
    throw InputError(place + ": there is no section " + quote(section, 60) +
                     "\n  remedy:  " + remedy + "sections are " + all);
  }



  void
  refuse_entry(const Assignment                 &assignment,
               const std::vector<DeclaredEntry> &entries)
  {
    const std::string section = section_of(assignment.path);
    const std::string all     = list_entries(section, entries);
    const std::string near    = suggest_path(assignment.path, entries);
    if (near.empty())
      check_section(assignment.place, section, entries);
    const std::string fault =
      all.empty()     ? "there is no section " + quote(section, 60) :
      section.empty() ? "there is no entry " + quote(assignment.path, 60) +
                          " outside of the sections" :
                        "section " + section + " has no entry " +
                          quote(name_of(assignment.path), 60);
    throw InputError(assignment.place + ": " + fault + "\n  remedy:  " +
                     (near.empty() ? "entries there are " + all :
                                     "did you mean " + near +
                                       "? --print-parameters lists all "
                                       "entries"));
  }
} // namespace ThermoContact
