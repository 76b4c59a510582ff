// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/study/scene_reader.h>

#include <algorithm>

namespace ThermoContact
{
  SceneReader::SceneReader(const std::vector<Assignment> &assignments)
  {
    scene_.add_parameters(prm_);
    assign_entries(assignments, prm_);
    own_scene   = scene_;
    own_entries = declared_entries(prm_);
  }



  void
  SceneReader::read(const std::string &place, const Overrides &overrides)
  {
    reset();
    std::vector<Assignment> assignments;
    for (const auto &[path, value] : overrides)
      {
        assignments.push_back({place, path, value});
        overridden.push_back(path);
      }
    assign_entries(assignments, own_entries, prm_);
  }



  void
  SceneReader::reset()
  {
    std::vector<Assignment> assignments;
    for (const auto &entry : own_entries)
      if (std::find(overridden.begin(), overridden.end(), entry.path) !=
          overridden.end())
        assignments.push_back({"", entry.path, entry.value});
    assign_entries(assignments, own_entries, prm_);
    overridden.clear();
    scene_ = own_scene; // texts of default values may have fewer digits
  }



  const std::string &
  SceneReader::own_value(const std::string &path) const
  {
    return std::find_if(own_entries.begin(),
                        own_entries.end(),
                        [&](const auto &entry) { return entry.path == path; })
      ->value;
  }
} // namespace ThermoContact
