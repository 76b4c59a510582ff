// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/constants.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/study/scene_reader.h>

#include <algorithm>

namespace ThermoContact
{
  SceneReader::SceneReader(const std::vector<Assignment> &assignments)
    : own_assignments(assignments)
    , assignments_(assignments)
  {
    scene_.add_parameters(prm_);
    assign_entries(assignments, prm_);
    own_scene          = scene_;
    own_entries        = declared_entries(prm_);
    is_read_as_a_whole = is_in_si(assignments) ||
                         std::any_of(assignments.begin(),
                                     assignments.end(),
                                     [](const Assignment &assignment) {
                                       return is_constant_path(assignment.path);
                                     });
  }



  void
  SceneReader::read(const std::string &place, const Overrides &overrides)
  {
    reset();
    std::vector<Assignment> changes;
    for (const auto &[path, value] : overrides)
      {
        changes.push_back({place, path, value});
        assignments_.erase(std::remove_if(assignments_.begin(),
                                          assignments_.end(),
                                          [&path =
                                             path](const Assignment &own) {
                                            return own.path == path;
                                          }),
                           assignments_.end());
      }
    assignments_.insert(assignments_.end(), changes.begin(), changes.end());
    for (const Assignment &change : changes)
      overridden.push_back(change.path);
    // scales follow from entries, numbers from constants
    assign_entries(is_read_as_a_whole ? assignments_ : changes,
                   own_entries,
                   prm_);
  }



  void
  SceneReader::reset()
  {
    for (const auto &entry : own_entries)
      if (is_read_as_a_whole ||
          std::find(overridden.begin(), overridden.end(), entry.path) !=
            overridden.end())
        set_entry({"", entry.path, entry.value}, prm_);
    overridden.clear();
    assignments_ = own_assignments;
    scene_       = own_scene; // texts of default values may have fewer digits
  }



  const std::string &
  SceneReader::own_value(const std::string &path) const
  {
    for (auto own = own_assignments.rbegin(); own != own_assignments.rend();
         ++own)
      if (own->path == path)
        return own->value;
    return std::find_if(own_entries.begin(),
                        own_entries.end(),
                        [&](const auto &entry) { return entry.path == path; })
      ->value;
  }
} // namespace ThermoContact
