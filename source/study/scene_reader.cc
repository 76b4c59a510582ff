// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/study/scene_reader.h>

#include <algorithm>

namespace ThermoContact
{
  SceneReader::SceneReader(const std::vector<Assignment> &assignments)
    : own_assignments(assignments)
    , assignments_(assignments)
  {
    scene_.add_parameters(prm_);
    assign_entries(assignments, prm_, scene_);
    own_scene   = scene_;
    own_entries = declared_entries(prm_);
  }



  void
  SceneReader::read(const std::string &place, const Overrides &overrides)
  {
    for (const DeclaredEntry &entry : own_entries)
      if (changed.empty() || changed.count(entry.path) > 0)
        set_entry({"", entry.path, entry.value}, prm_);
    assignments_ = own_assignments;
    scene_       = own_scene; // texts of default values may have fewer digits
    for (const auto &[path, value] : overrides)
      {
        const auto is_it = [&path = path](const Assignment &own) {
          return own.path == path;
        };
        assignments_.erase(std::remove_if(assignments_.begin(),
                                          assignments_.end(),
                                          is_it),
                           assignments_.end());
        assignments_.push_back({place, path, value});
      }
    changed.clear(); // if something is wrong
    // as a whole: scales follow from entries, numbers from constants
    const auto derived = assign_entries(assignments_, prm_, scene_);
    for (const auto &all : {assignments_, derived})
      for (const Assignment &assignment : all)
        changed.insert(assignment.path);
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
