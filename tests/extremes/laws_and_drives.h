// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_laws_and_drives_h
#define thermocontact_extremes_laws_and_drives_h

#include "test_scene.h"

namespace ThermoContact
{
  /** What is not in the paper, at ends of ranges. */
  inline std::vector<Overrides>
  laws_and_drives()
  {
    const std::string power = "Contact/Condition=power law";
    return {
      {power, "Contact/Exponent=10", "Contact/Compliance=1e-6"},
      {power, "Contact/Exponent=1.001", "Contact/Compliance=1e12"},
      {power, "Contact/Exponent=10", "Contact/Damping=1e6"},
      {"Contact/Damping=1e6", "Contact/Compliance=1e-14"},
      {"Contact/Damping=1e-6"},
      {"Boundary/Fixed end displacement=1e-3*sin(1e4*t)",
       "Time/Break points=0.05;0.1001;0.15;0.3;1"},
      {"Boundary/Fixed end displacement=100*t^2", "Contact/Condition=rigid"},
      {"Contact/Gap=0.01-1e-3*sin(1e4*t)", "Contact/Damping=10"},
      {"Contact/Gap=0.01-100*t^2", "Contact/Condition=rigid"},
      {"Contact/Gap=0.05-0.1*sin(15*t)",
       "Contact/Condition=rigid",
       "Contact/Massless nodes=off",
       "Boundary/Heat exchange=1+pressure^0.95"},
      {"Contact/Gap=0.01-min(1e3*t,5)", "Contact/Compliance=1e-6"},
      {"Contact/Gap=0.01-0.05*sin(40*t)",
       "Initial values/Velocity=-10*sin(pi*x)",
       "Initial values/Temperature=theta_A+5*sin(4*x)",
       "Mesh/Cells=18",
       "Mesh/Degree=2",
       "Model/Inertia=0.04",
       "Model/Viscosity=0",
       "Model/Coupling=0.1",
       "Contact/Condition=rigid",
       "Contact/Massless nodes=off",
       "Boundary/Heat exchange=if(pressure>0,1e3,1)"},
      {power,
       "Contact/Exponent=5",
       "Contact/Gap=1e-6",
       "Contact/Rear gap=2e-7",
       "Initial values/Velocity=-1e4*sin(9*x)"},
      {"Boundary/Lateral heat exchange=1e6", "Boundary/Ambient temperature=-5"},
      {"Boundary/Heat exchange=if(pressure>0,1e6,1e-6)"},
      {"Boundary/Heat exchange=if(gap>0,1e-4/(1e-4+gap),1+1e9*pressure)"},
      {"Boundary/Fixed end temperature=if(t<0.1,10,-1e4)",
       "Boundary/Obstacle temperature=5*sin(1e4*t)"},
      {"Sources/Heat source=if(t<0.1,0,if(t<0.1001,1e6,0))",
       "Sources/End traction=if(sin(100*t)>0,1e3,-1e3)"},
      {"Boundary/Fixed end displacement=0.01*sin(50*t)",
       "Model/Inertia=0",
       "Model/Viscosity=0",
       "Output/Period=0.05"}};
  }
} // namespace ThermoContact

#endif
