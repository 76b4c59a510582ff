// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_refusals_h
#define thermocontact_extremes_refusals_h

#include "test_scene.h"

namespace ThermoContact
{
  /** Entries that exclude each other; the first one named is at fault. */
  inline void
  add_contradictions(std::vector<TestScene> &scenes)
  {
    const Overrides conserving = {"Time/Step size=0.01",
                                  "Time/Scheme=energy conserving"};
    const Overrides rigid      = {"Contact/Condition=rigid"};
    const auto add = [&](const std::string &path, const Overrides &overrides) {
      scenes.push_back({join(overrides), overrides, TestScene::refused, path});
    };
    add("Contact/Compliance", rigid + Overrides{"Contact/Compliance=1"});
    add("Contact/Gap", rigid + Overrides{"Contact/Gap=-0.1"});
    add("rigid obstacle",
        rigid + Overrides{"Initial values/Displacement=0.2*x"});
    add("Time/Scheme", conserving + Overrides{"Model/Inertia=0"});
    add("Contact/Massless nodes",
        conserving + Overrides{"Contact/Massless nodes=off"});
    add("Time/Locate contact events",
        conserving + Overrides{"Time/Locate contact events=true"});
    add("Time/Step size", {"Time/Scheme=energy conserving"});
    add("Time/Step size", {"Time/Scheme=backward euler"});
    add("Mesh/Cells",
        {"Contact/Massless nodes=on", "Mesh/Cells=1", "Mesh/Degree=1"});
    add("Time/Start",
        {"Time/Scheme=backward euler",
         "Time/Step size=0.01",
         "Time/Start=paper",
         "Model/Inertia=0"});
    const Overrides by_contact = {"Boundary/Heat exchange=1+gap"};
    const Overrides shaken     = {"Boundary/Fixed end displacement=sin(t)"};
    add("Time/Scheme", conserving + Overrides{"Contact/Condition=power law"});
    add("Contact/Damping", conserving + Overrides{"Contact/Damping=1e6"});
    add("Boundary/Heat exchange", conserving + by_contact);
    add("Boundary/Heat exchange",
        by_contact + Overrides{"Contact/Condition=none"});
    add("Boundary/Obstacle temperature",
        by_contact + Overrides{"Boundary/Obstacle temperature=sin(t)"});
    add("Boundary/Fixed end displacement", conserving + shaken);
    add("Boundary/Fixed end displacement",
        shaken + Overrides{"Time/Scheme=backward euler",
                           "Time/Step size=0.01",
                           "Time/Start=paper"});
    add("Mesh/Mass matrix",
        {"Mesh/Mass matrix=midpoint", "Time/Step size=0.01"});
    add("Mesh/Mass matrix",
        conserving + Overrides{"Mesh/Mass matrix=midpoint", "Mesh/Degree=1"});
    add("Contact/Damping",
        {"Contact/Damping=1e6",
         "Contact/Massless nodes=on",
         "Model/Viscosity=0"});
    add("Contact/Gap", {"Model/Fields=temperature", "Contact/Gap=1"});
    add("Model/Coupling", {"Model/Fields=displacement", "Model/Coupling=1"});
  }



  inline void
  add_refusals(std::vector<TestScene> &scenes)
  {
    const auto add = [&](const std::string &override,
                         const std::string &message = "") {
      const std::string path = override.substr(0, override.find('='));
      scenes.push_back({override,
                        {"Time/Step size=0.01", override},
                        TestScene::refused,
                        message.empty() ? path : message});
    };
    for (const char *path : {"Model/Coupling",
                             "Model/Inertia",
                             "Model/Viscosity",
                             "Boundary/Heat exchange",
                             "Boundary/Fixed end temperature",
                             "Boundary/Obstacle temperature",
                             "Boundary/Lateral heat exchange",
                             "Boundary/Ambient temperature",
                             "Contact/Compliance",
                             "Contact/Gap",
                             "Contact/Damping",
                             "Contact/Exponent",
                             "Mesh/Grading",
                             "Time/Step size",
                             "Time/End time"})
      {
        add(std::string(path) + "=nan");
        add(std::string(path) + "=inf");
      }
    for (const char *path : {"Model/Inertia",
                             "Model/Viscosity",
                             "Boundary/Heat exchange",
                             "Boundary/Lateral heat exchange",
                             "Contact/Compliance",
                             "Contact/Damping",
                             "Contact/Exponent",
                             "Output/Period",
                             "Time/Break points",
                             "Mesh/Grading",
                             "Mesh/Cells",
                             "Mesh/Degree",
                             "Time/Step size",
                             "Time/End time"})
      add(std::string(path) + "=-1");
    add("Contact/Compliance=0", "rigid");
    add("Mesh/Cells=0");
    add("Mesh/Degree=0");
    add("Time/Step size=0");
    add("Time/Step size=1e-9", "1e9 steps");
    add("Contact/Exponent=11");
    add("Boundary/Heat exchange=gap-1e-3");
    add("Boundary/Heat exchange=1/pressure");
    add("Boundary/Fixed end displacement=1+t");
    add("Boundary/Fixed end displacement=sqrt(t)");
    add("Boundary/Fixed end displacement=if(t<1,0,1)");
    add("Boundary/Fixed end temperature=1/t");
    add("Initial values/Temperature=1/(x-x)");
    add("Initial values/Displacement=1");
    add_contradictions(scenes);
  }
} // namespace ThermoContact

#endif
