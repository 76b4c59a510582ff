// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_scene_text_h
#define thermocontact_input_scene_text_h

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/parameter_text.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** A parameter file that grows by entries. */
  class SceneText
  {
  public:
    /**
     * @param own of the user, which stand behind the others
     * @throw InputError if the rod decides one of them by having nothing of
     *   the kind
     */
    explicit SceneText(const std::vector<Assignment> &own)
    {
      for (const Assignment &assignment : own)
        values[assignment.path] = assignment.value;
      for (const char *path : {"Boundary/Ambient temperature",
                               "Boundary/Fixed end displacement",
                               "Boundary/Lateral heat exchange",
                               "Contact/Compliance",
                               "Contact/Damping",
                               "Contact/Exponent",
                               "Contact/Rear gap"})
        reserve(path);
    }

    /** Adds an entry that is not the user's to set. */
    void
    set(const std::string &path,
        const std::string &value,
        const std::string &comment = "")
    {
      reserve(path);
      add(path, value, comment);
    }

    /** Adds an entry unless the user has set it. */
    void
    suggest(const std::string &path, const std::string &value)
    {
      if (values.count(path) == 0)
        add(path, value, "");
    }

    /** True if the user has set an entry of this section. */
    bool
    has_own(const std::string &section) const
    {
      const auto next = values.lower_bound(section + "/");
      return next != values.end() && next->first.rfind(section + "/", 0) == 0;
    }

    /** All of it. */
    std::string
    str()
    {
      for (const auto &[path, value] : values)
        add(path, value, "");
      std::string all;
      for (const auto &[section, lines] : sections)
        all += section.empty() ?
                 lines :
                 "subsection " + section + '\n' + lines + "end\n";
      return all;
    }

  private:
    std::map<std::string, std::string>               values; ///< of the user
    std::vector<std::pair<std::string, std::string>> sections;

    /** Refuses an entry that is not the user's to set. */
    void
    reserve(const std::string &path) const
    {
      if (values.count(path) > 0)
        throw InputError(path +
                         ": the rod in units decides it\n  remedy:  change "
                         "the rod, or the scene that --units prints");
    }

    void
    add(const std::string &path,
        const std::string &value,
        const std::string &comment)
    {
      const auto        slash = path.find('/');
      const std::string section =
        slash == std::string::npos ? "" : path.substr(0, slash);
      auto found =
        std::find_if(sections.begin(), sections.end(), [&](const auto &known) {
          return known.first == section;
        });
      if (found == sections.end())
        found =
          sections.insert(section.empty() ? sections.begin() : sections.end(),
                          {section, ""});
      found->second += (section.empty() ? "set " : "  set ") +
                       path.substr(section.empty() ? 0 : slash + 1) + " = " +
                       value + (comment.empty() ? "" : " # " + comment) + '\n';
    }
  };
} // namespace ThermoContact

#endif
