// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/si_scene.h>

#include "seeds.h"

#include <algorithm>
#include <filesystem>

#include "entries.h"
#include "reading.h"

namespace ThermoContact
{
  namespace
  {
    namespace fs = std::filesystem;

    std::string
    in_prm(const char *const path)
    {
      return read_text(fs::path(PRM_DIR) / path);
    }



    /** The scene on a mesh whose matrices cost next to nothing. */
    std::string
    small_body(const std::string &scene, const unsigned int dimension)
    {
      std::string text = scene;
      for (const Assignment &entry :
           {Assignment{"", "Dimension", std::to_string(dimension)},
            Assignment{"", "Mesh/Cells", "3"},
            Assignment{"", "Mesh/Cells across", "2"},
            Assignment{"", "Mesh/Degree", "2"},
            Assignment{"", "Mesh/Refinements", "0"}})
        text = with_entry(text, entry);
      return text;
    }



    /** Strips, round rods and blocks of prm, and rods as bodies. */
    std::vector<std::string>
    small_bodies()
    {
      std::vector<std::string> texts;
      for (const char *const plane : {"examples/strip.prm",
                                      "examples/round-rod.prm",
                                      "examples/lateral-waves.prm"})
        texts.push_back(small_body(in_prm(plane), 2));
      for (const char *const block :
           {"examples/block-on-sphere.prm", "examples/tilted-block.prm"})
        texts.push_back(small_body(in_prm(block), 3));
      for (const char *const rod : {"paper/experiment-1.prm",
                                    "examples/cooling-rod.prm",
                                    "examples/damped-stop.prm",
                                    "examples/hammered-rod.prm",
                                    "examples/shaken-base.prm",
                                    "examples/thermal-switch.prm",
                                    "examples/two-stops.prm"})
        for (const unsigned int dimension : {2, 3})
          texts.push_back(small_body(in_prm(rod), dimension));
      return texts;
    }
  } // namespace



  std::vector<std::string>
  valid_files()
  {
    std::vector<fs::path> paths;
    for (const auto &entry : fs::recursive_directory_iterator(PRM_DIR))
      if (entry.path().extension() == ".prm")
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> texts, scenes;
    for (const fs::path &path : paths)
      {
        texts.push_back(read_text(path));
        if (const auto rod = statements(texts.back()); is_in_si(rod))
          scenes.push_back(scene_without_units(rod));
      }
    texts.insert(texts.end(), scenes.begin(), scenes.end());

    const std::vector<std::string> bodies = small_bodies();
    texts.insert(texts.end(), bodies.begin(), bodies.end());

    const Assignment plane{"", "Dimension", "2"};
    texts.push_back(all_entries({}));
    texts.push_back(all_entries({plane}));
    texts.push_back(all_entries(statements(scenes.front())));
    for (const char *const path : {"paper/experiment-1.prm",
                                   "examples/shaken-base.prm",
                                   "units/steel-impact.prm"})
      texts.push_back(
        with_entry(in_prm(path), {"", "Output/Error bars", "true"}));
    return texts;
  }
} // namespace ThermoContact
