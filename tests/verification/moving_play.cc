// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A rod between an obstacle in front of it that moves and one behind it that
// rests.
//
// 1. A base that shakes, u_A = 0.3 sin t, pushes a rod without inertia against
//    both, g = 0.1 + 0.05 sin 2t and g_2 = 0.15. The stress u_x + zeta v_x is
//    the same everywhere, so that u = u_A + (u(1) - u_A) x, and
//      F = u_A - u(1) + zeta (u_A' - v(1)).
//    In contact u(1) = c, v(1) = c' with c = g or c = -g_2, c' = 0: F follows
//    from the time alone. An elastic obstacle has u(1) = c + eps F, without
//    viscosity F = (u_A - c)/(1 + eps). Two begins and two ends up to t = 6:
//    without viscosity those behind are where u_A = -0.15, t = 7 pi/6 and
//    11 pi/6.
// 2. Thrown back by u_t = -x a rod meets the obstacle behind it alone, thrown
//    forward by u_t = x the one in front: then the motion of the other one, or
//    that it is there, changes nothing, what the scheme takes included.

#include <thermocontact/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const double pi = 3.14159265358979323846;



  void
  check_forces(const std::string &name,
               const double       zeta,
               const double       eps,
               const double       bound)
  {
    const RecordedRun result =
      run<1>("",
             {"Model/Fields=displacement",
              "Model/Inertia=0",
              "Model/Viscosity=" + std::to_string(zeta),
              "Mesh/Cells=2",
              eps > 0. ? "Contact/Compliance=" + std::to_string(eps) :
                         "Contact/Condition=rigid",
              "Contact/Gap=0.1+0.05*sin(2*t)",
              "Contact/Rear gap=0.15",
              "Boundary/left/Displacement=0.3*sin(t)",
              "Initial values/Displacement=0",
              "Time/Tolerance=1e-7",
              "Time/End time=6"});
    double   error = 0., pull = 0.;
    unsigned n_front = 0, n_rear = 0;
    for (const StepRecord &row : result.rows)
      if (const double t = row.time, F = row.contact_force; F != 0.)
        {
          const bool   is_front = F > 0.;
          const double c    = is_front ? 0.1 + 0.05 * std::sin(2. * t) : -0.15;
          const double rate = is_front ? 0.1 * std::cos(2. * t) : 0.;
          const double exact =
            (0.3 * std::sin(t) - c + zeta * (0.3 * std::cos(t) - rate)) /
            (1. + eps);
          error = std::max(error, std::abs(F - exact));
          ++(is_front ? n_front : n_rear);
        }
      else
        pull = std::max(pull, std::abs(row.contact_force));
    deallog << name << ": events " << result.events.size() << ", rows "
            << (n_front > 5 && n_rear > 5 ? "at both" : "missing")
            << ", error of the force " << within(error, bound);
    if (zeta == 0.)
      for (const double exact : {7. * pi / 6., 11. * pi / 6.})
        {
          double nearest = 10.;
          for (const ContactEvent &event : result.events)
            if (event.side < 0)
              nearest = std::min(nearest, std::abs(event.time - exact));
          deallog << ", of an event behind " << within(nearest, 1e-6);
        }
    deallog << std::endl;
  }



  /** Largest difference of end, velocity, force and impulse at the end. */
  void
  compare(const std::string              &name,
          const std::string              &direction,
          const std::vector<std::string> &law,
          const std::string              &one,
          const std::string              &other)
  {
    StepRecord   last[2];
    unsigned int n_events[2];
    for (const unsigned int i : {0, 1})
      {
        std::vector<std::string> overrides = {"Mesh/Cells=4",
                                              "Mesh/Degree=2",
                                              "Initial values/Temperature=0",
                                              "Initial values/Displacement=0",
                                              "Initial values/Velocity=" +
                                                direction,
                                              "Time/End time=2"};
        overrides.insert(overrides.end(), law.begin(), law.end());
        if (law.back() != "Model/Viscosity=0")
          overrides.push_back("Model/Viscosity=0.05");
        const std::string gaps  = i == 0 ? one : other;
        const auto        comma = gaps.find(';');
        overrides.push_back("Contact/Gap=" + gaps.substr(0, comma));
        overrides.push_back("Contact/Rear gap=" + gaps.substr(comma + 1));
        const RecordedRun result = run<1>("", overrides);
        last[i]                  = result.rows.back();
        n_events[i]              = result.events.size();
      }
    double difference = 0.;
    for (const auto value : {&StepRecord::displacement_end,
                             &StepRecord::velocity_end,
                             &StepRecord::contact_force,
                             &StepRecord::contact_impulse,
                             &StepRecord::work,
                             &StepRecord::dissipation,
                             &StepRecord::numerical_dissipation,
                             &StepRecord::contact_dissipation,
                             &StepRecord::energy})
      difference =
        std::max(difference, std::abs(last[0].*value - last[1].*value));
    deallog << name << ": events " << n_events[0] << " and " << n_events[1]
            << ", impulse "
            << (last[0].contact_impulse == 0. ? "missing" : "there")
            << ", difference " << within(difference, 1e-7) << std::endl;
  }
} // namespace



void
main_moving_play()
{
  initlog();
  check_forces("static, rigid", 0., 0., 1e-10);
  check_forces("static, elastic", 0., 0.1, 1e-10);
  check_forces("viscous, rigid", 0.2, 0., 1e-4);
  for (const auto &[name, law] :
       std::vector<std::pair<std::string, std::vector<std::string>>>{
         {"rigid", {"Contact/Condition=rigid"}},
         {"elastic", {"Contact/Compliance=0.01"}},
         {"elastic, backward Euler",
          {"Contact/Compliance=0.01",
           "Time/Scheme=backward euler",
           "Time/Start=consistent",
           "Time/Step size=0.001"}},
         {"damped", {"Contact/Compliance=0.01", "Contact/Damping=0.5"}},
         {"viscous nodes, rigid",
          {"Contact/Condition=rigid", "Contact/Massless nodes=on"}},
         {"viscous nodes, damped",
          {"Contact/Compliance=0.01",
           "Contact/Damping=0.5",
           "Contact/Massless nodes=on"}},
         {"static nodes",
          {"Contact/Compliance=0.01",
           "Contact/Massless nodes=on",
           "Model/Viscosity=0"}},
         {"left faster than damping allows",
          {"Contact/Compliance=0.01",
           "Contact/Damping=20",
           "Time/Scheme=backward euler",
           "Time/Start=consistent",
           "Time/Step size=0.001"}}})
    {
      compare("behind, " + name, "-x", law, "5+0.3*sin(5*t);0.1", "5;0.1");
      compare("in front, " + name,
              "x",
              law,
              "0.1+0.05*sin(5*t);50",
              "0.1+0.05*sin(5*t);none");
    }
}
