// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_table_h
#define thermocontact_extremes_table_h

#include <algorithm>

#include "laws_and_drives.h"
#include "refusals.h"
#include "test_scene.h"

namespace ThermoContact
{
  /** The schemes, with 15 steps of a body that soon touches the obstacle. */
  inline std::vector<Overrides>
  scheme_settings()
  {
    const Overrides fixed = {"Time/Step size=0.02", "Time/End time=0.3"};
    return {Overrides{"Time/Scheme=backward euler"} + fixed,
            Overrides{"Time/Scheme=backward euler", "Time/Start=consistent"} +
              fixed,
            Overrides{"Time/Scheme=sdirk2"} + fixed,
            Overrides{"Time/Scheme=sdirk3"} + fixed,
            Overrides{"Time/Scheme=sdirk4"} + fixed,
            {"Time/Scheme=sdirk4", "Time/Tolerance=1e-4", "Time/End time=0.3"},
            Overrides{"Time/Scheme=energy conserving"} + fixed};
  }



  inline Overrides
  small_mesh()
  {
    return {"Mesh/Cells=4", "Mesh/Degree=3"};
  }



  /** One parameter at an end of its range, the others as in experiment 1. */
  inline std::vector<Overrides>
  ends_of_ranges()
  {
    std::vector<Overrides> ends;
    const auto             add = [&](const std::string              &entry,
                         const std::vector<std::string> &values) {
      for (const std::string &value : values)
        ends.push_back({entry + "=" + value});
    };
    add("Model/Coupling",
        {"0", "1e-300", "0.017", "1", "10", "1e3", "-0.017", "-10"});
    add("Model/Inertia", {"0", "4e-18", "1e-12", "1", "1e8"});
    add("Model/Viscosity", {"0", "1e-12", "0.2", "1e6"});
    add("Contact/Compliance", {"1e-14", "1e-8", "1", "1e12"});
    add("Boundary/Heat exchange", {"0", "1e-12", "1e12"});
    add("Contact/Gap", {"0", "1e-15", "1e30"});
    add("Boundary/Fixed end temperature",
        {"0", "1e-300", "-1e-300", "1e6", "-1e6"});
    add("Model/Fields", {"temperature", "displacement"});
    add("Model/Thermoelastic heating", {"false"});
    add("Contact/Massless nodes", {"on", "off"});
    add("Mesh/Mass matrix", {"lumped"});
    ends.push_back({"Model/Inertia=0", "Model/Viscosity=0"});
    ends.push_back({"Contact/Condition=rigid"});
    ends.push_back({"Contact/Condition=none"});
    return ends;
  }



  /** A gap that the body covers, unless the end of the range is a gap. */
  inline Overrides
  small_gap(const Overrides &overrides)
  {
    for (const std::string &o : overrides)
      if (o.rfind("Contact/Gap", 0) == 0 || o == "Contact/Condition=none" ||
          o == "Model/Fields=temperature")
        return {};
    return {"Contact/Gap=0.01"};
  }



  inline bool
  has(const Overrides &overrides, const std::string &text)
  {
    return std::find(overrides.begin(), overrides.end(), text) !=
           overrides.end();
  }



  /** False for what is refused, see check_scene() and unused_entries().
   */
  inline bool
  is_possible(const Overrides &scene)
  {
    if (has(scene, "Model/Fields=temperature") &&
        has(scene, "Time/Start=consistent"))
      return false;
    for (const std::string &o : scene)
      if (has(scene, "Time/Scheme=energy conserving") &&
          (o.rfind("Contact/Exponent", 0) == 0 ||
           o.rfind("Contact/Damping", 0) == 0 ||
           o.rfind("Boundary/Heat exchange=if", 0) == 0 ||
           o.rfind("Boundary/Fixed end displacement", 0) == 0))
        return false;
    return !has(scene, "Time/Scheme=energy conserving") ||
           !(has(scene, "Model/Inertia=0") ||
             has(scene, "Contact/Massless nodes=off") ||
             has(scene, "Mesh/Degree=1"));
  }



  inline void
  add_ends(std::vector<TestScene> &scenes)
  {
    for (const Overrides &end : ends_of_ranges())
      for (const Overrides &scheme : scheme_settings())
        if (is_possible(end + scheme))
          scenes.push_back({join(end) + "; " + join(scheme),
                            scheme + small_mesh() + small_gap(end) + end});
  }



  /** All combinations of ends of five parameters, each with one scheme. */
  inline void
  add_corners(std::vector<TestScene> &scenes)
  {
    const std::vector<Overrides> schemes = scheme_settings();
    unsigned int                 i       = 0;
    for (const char *a : {"0", "1e3"})
      for (const char *b : {"0", "4e-18", "1e8"})
        for (const char *zeta : {"0", "1e6"})
          for (const char *k : {"0", "1e12"})
            for (const Overrides &contact :
                 {Overrides{"Contact/Compliance=1e-14"},
                  Overrides{"Contact/Compliance=1e12"},
                  Overrides{"Contact/Condition=rigid"}})
              {
                const Overrides corner =
                  Overrides{std::string("Model/Coupling=") + a,
                            std::string("Model/Inertia=") + b,
                            std::string("Model/Viscosity=") + zeta,
                            std::string("Boundary/Heat exchange=") + k} +
                  contact;
                while (!is_possible(corner + schemes[i % 7]))
                  ++i;
                const Overrides &scheme = schemes[i++ % 7];
                scenes.push_back(
                  {join(corner) + "; " + join(scheme),
                   scheme + small_mesh() + small_gap(corner) + corner});
              }
  }



  inline void
  add_meshes_and_times(std::vector<TestScene> &scenes)
  {
    const std::vector<Overrides> meshes = {
      {"Mesh/Cells=1", "Mesh/Degree=1"},
      {"Mesh/Cells=1", "Mesh/Degree=20"},
      {"Mesh/Cells=20", "Mesh/Degree=2", "Mesh/Grading=1e4"},
      {"Mesh/Cells=20", "Mesh/Degree=2", "Mesh/Grading=1e-4"}};
    for (const Overrides &mesh : meshes)
      for (const Overrides &scheme : scheme_settings())
        if (is_possible(mesh + scheme))
          scenes.push_back({join(mesh) + "; " + join(scheme),
                            scheme + mesh + Overrides{"Contact/Gap=0.01"}});
    const Overrides long_mesh = {"Mesh/Cells=100000", "Mesh/Degree=1"};
    scenes.push_back({"1e5 cells",
                      long_mesh + Overrides{"Time/Scheme=sdirk2",
                                            "Time/Step size=0.02",
                                            "Time/End time=0.04"}});

    for (const char *scheme :
         {"backward euler", "sdirk2", "sdirk3", "sdirk4", "energy conserving"})
      {
        const Overrides body =
          small_mesh() +
          Overrides{"Contact/Gap=0.01", std::string("Time/Scheme=") + scheme};
        const auto add = [&](const std::string &dt, const std::string &T) {
          scenes.push_back(
            {"dt = " + dt + ", T = " + T + ", " + scheme,
             body + Overrides{"Time/Step size=" + dt, "Time/End time=" + T}});
        };
        add("0.3", "0.3");
        add("0.07", "0.3");
        add("1e-12", "2e-11");
        add("0.02", "0");
      }
  }



  inline void
  add_laws_and_drives(std::vector<TestScene> &scenes)
  {
    for (const Overrides &law : laws_and_drives())
      for (const Overrides &scheme : scheme_settings())
        if (is_possible(law + scheme))
          scenes.push_back({join(law) + "; " + join(scheme),
                            scheme + small_mesh() + small_gap(law) + law});
  }



  /** Steps and times so long that nothing but the steady state is left. */
  inline void
  add_steady(std::vector<TestScene> &scenes)
  {
    const std::vector<Overrides> obstacles = {{"Contact/Gap=0.01"},
                                              {"Contact/Gap=-0.01"},
                                              {"Contact/Gap=0.2"},
                                              {"Contact/Condition=rigid"},
                                              {"Contact/Condition=none"},
                                              {"Contact/Condition=power law",
                                               "Contact/Exponent=3",
                                               "Contact/Gap=0.01",
                                               "Contact/Damping=10"},
                                              {"Contact/Gap=0.02",
                                               "Boundary/Lateral heat "
                                               "exchange=0.25",
                                               "Boundary/Ambient "
                                               "temperature=-3"},
                                              {"Contact/Gap=0.02",
                                               "Boundary/Heat exchange=1/(1+"
                                               "20*gap)+9*pressure"}};
    const auto add = [&](const std::string &name, const Overrides &overrides) {
      for (const Overrides &obstacle : obstacles)
        {
          scenes.push_back({name + "; " + join(obstacle),
                            small_mesh() + overrides + obstacle});
          scenes.back().ends_steady = true;
          scenes.back().max_steps   = 10000;
        }
    };
    for (const char *scheme : {"backward euler", "sdirk2", "sdirk3", "sdirk4"})
      {
        const Overrides time  = {std::string("Time/Scheme=") + scheme,
                                 "Time/Start=consistent",
                                 "Time/Step size=1e6"};
        const Overrides start = scheme == std::string("backward euler") ?
                                  time :
                                  Overrides{time[0], time[2]};
        add("one step of 1e6, " + start[0],
            start + Overrides{"Time/End time=1e6"});
        add("20 steps of 1e6, " + start[0],
            start + Overrides{"Time/End time=2e7"});
      }
    add("T = 1e6, error control", {"Time/Tolerance=1e-4", "Time/End time=1e6"});
    add("heated at first, error control",
        {"Time/Tolerance=1e-4",
         "Time/End time=1e6",
         "Boundary/Fixed end temperature=if(t<1,-5,10)"});
  }



  inline void
  add_two_dimensional(std::vector<TestScene> &scenes)
  {
    const Overrides              body     = {"Dimension=2",
                                             "Mesh/Cells=4",
                                             "Mesh/Cells across=2",
                                             "Mesh/Degree=2",
                                             "Mesh/Width=0.5",
                                             "Contact/Gap=0.01"};
    const std::vector<Overrides> settings = {
      {},
      {"Model/Poisson ratio=0.49", "Boundary/Lateral support=free"},
      {"Model/Poisson ratio=-0.9", "Boundary/Lateral support=free"},
      {"Contact/Condition=rigid", "Boundary/Lateral support=free"},
      {"Mesh/Geometry=axisymmetric",
       "Model/Poisson ratio=0.49",
       "Boundary/Lateral support=free"},
      {"Mesh/Geometry=axisymmetric",
       "Contact/Condition=rigid",
       "Boundary/Lateral support=free"},
      {"Contact/Condition=rigid",
       "Contact/Gap=0.01+(y-0.2)^2",
       "Mesh/Grading across=0.01",
       "Model/Poisson ratio=0.3",
       "Boundary/Lateral support=free",
       "Boundary/Fixed end support=sliding"},
      {"Contact/Compliance=1e-14",
       "Model/Poisson ratio=0.3",
       "Boundary/Lateral support=free",
       "Initial values/Velocity=5*x*(1+sin(5*y));x*y"},
      {"Contact/Condition=rigid",
       "Boundary/Lateral support=free",
       "Initial values/Velocity=5*x*(1+sin(5*y));x*y"},
      {"Contact/Condition=power law",
       "Contact/Exponent=10",
       "Contact/Damping=1e6",
       "Boundary/Lateral heat exchange=1e6",
       "Boundary/Fixed end displacement=1e-3*sin(1e4*t)",
       "Boundary/Heat exchange=if(pressure>0,1e6,1e-6)",
       "Boundary/Lateral support=free"}};
    for (const Overrides &setting : settings)
      for (const Overrides &scheme : scheme_settings())
        if (is_possible(setting + scheme) &&
            (scheme[0] != "Time/Scheme=backward euler" ||
             scheme[1] == "Time/Start=consistent"))
          scenes.push_back({"2-D " + join(setting) + "; " + join(scheme),
                            scheme + body + setting});
    scenes.push_back({"2-D, nodes at the jump of the heat exchange",
                      scheme_settings()[1] + body +
                        Overrides{"Contact/Gap=0.01+0.02*(1+y)*sin(10*t)^2",
                                  "Contact/Compliance=0.01",
                                  "Model/Poisson ratio=0.45",
                                  "Boundary/Lateral support=free",
                                  "Boundary/Heat exchange=if(pressure>0,1e-6,"
                                  "1e6)"}});
  }



  inline void
  add_warnings(std::vector<TestScene> &scenes)
  {
    for (const Overrides &scheme : scheme_settings())
      {
        const Overrides base = scheme + small_mesh();
        scenes.push_back({"preload; " + join(scheme),
                          base + Overrides{"Contact/Gap=-0.05"},
                          TestScene::warns,
                          "initial pressure"});
        scenes.push_back({"u_0(1) beyond the gap; " + join(scheme),
                          base + Overrides{"Initial values/Displacement=0.2*x"},
                          TestScene::warns,
                          "initial pressure"});
        scenes.push_back({"corner layer; " + join(scheme),
                          base + Overrides{"Initial values/Temperature=5"},
                          TestScene::warns,
                          "corner layer"});
      }
  }



  /** Every scene that is written down, as opposed to drawn. */
  inline std::vector<TestScene>
  table_scenes()
  {
    std::vector<TestScene> scenes;
    add_ends(scenes);
    add_corners(scenes);
    add_meshes_and_times(scenes);
    add_laws_and_drives(scenes);
    add_steady(scenes);
    add_two_dimensional(scenes);
    add_warnings(scenes);
    add_refusals(scenes);
    // there are seven schemes, so that each parameter has both
    for (unsigned int i = 0; i < scenes.size(); ++i)
      scenes[i].variations =
        i % 2 == 0 ? TestScene::scaling_alone : TestScene::sign_alone;
    return scenes;
  }
} // namespace ThermoContact

#endif
