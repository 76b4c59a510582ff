// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What happens at once where an obstacle changes its velocity, and what a mesh
// says of the force behind an impact.
//
// 1. A rod with viscosity alone, b = 0, zeta = 1/5, at a rigid obstacle: the
//    stress u_x + zeta v_x is the same everywhere, so that u = x u(1) and, in
//    contact, u(1) = g and F = -(g + zeta g'). g = -1/10 - t/5 up to t = 1. At
//    the kink, where g = -3/10, the row of t = 1 has
//      g' = -1/2: the velocity -1/2 and F = 3/10 + 1/10 = 2/5;
//      g' = 2: no force holds the rod there, F would be -1/10. It is left
//        behind, u(1) + zeta v(1) = 0, with v = 3/2, and contact ends at t = 1
//        with the velocity 3/2 - 2 = -1/2.
// 2. The largest force of the default scene on hard obstacles, eps = 1e-3, 1e-4
//    and 1e-7, is that of viscosity within (D7.3), t = 5.9e-3, 1.26e-3 and
//    1.3e-5, which reaches sqrt(zeta t) = 0.034, 0.016 and 0.0016 far; with 8
//    cells of degree 4 the node of the end stands for 1/160: a warning of the
//    last one, and none of the others, also with Mesh/Grading = 1e4. The forces
//    against those of 16 cells of degree 8 with that grading and the tolerance
//    1e-8, 5.61045, 11.7309 and 116.365 (the same to six digits with 48 and 96
//    cells of degree 10): to 1 % where there is no warning, off by more than
//    20 % where there is one; automatic cells to 1e-4, as their node has 10.5
//    of its lengths in that layer (measured 7e-6).
// 3. A thermal switch with mass whose contact node is static, so that its
//    velocity jumps where contact begins and ends. The row of an event has the
//    velocity behind it, with the heat that k(gap, pressure) conducts: it and
//    the one of the next row have the mean (u_1 - u_0)/h, to second order in
//    the steps that follow an event.
// 4. The rod of 1 pushed by a traction of 1/2: u = x U, zeta U' + U = 1/2,
//    until it meets a rigid obstacle, g = 3/10, at t = zeta log(5/2) with the
//    velocity 1. Its row has velocity 0 and F = 1/2 - 3/10 = 1/5.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  void
  check_kink(const std::string &name,
             const std::string &rate,
             const double       velocity,
             const double       force)
  {
    const RecordedRun result =
      run<1>("",
             {"Model/Fields=displacement",
              "Model/Inertia=0",
              "Model/Viscosity=0.2",
              "Mesh/Cells=2",
              "Contact/Condition=rigid",
              "Contact/Gap=-0.1-0.2*min(t,1)+" + rate + "*max(t-1,0)",
              "Initial values/Displacement=-0.1*x",
              "Time/End time=1.5"});
    const auto row =
      std::find_if(result.rows.begin(),
                   result.rows.end(),
                   [](const StepRecord &r) { return r.time >= 1. - 1e-9; });
    deallog << name << ": velocity "
            << within(std::abs(row->velocity_end - velocity), 1e-10)
            << ", force "
            << within(std::abs(row->contact_force - force), 1e-10);
    if (force == 0.)
      deallog << ", end of contact at "
              << within(std::abs(result.events.back().time - 1.), 1e-9)
              << " with velocity "
              << within(std::abs(result.events.back().velocity + 0.5), 1e-10);
    else
      deallog << ", events " << result.events.size();
    deallog << std::endl;
  }



  void
  check_peak(const std::string &compliance,
             const double       fine,
             const std::string &cells,
             const std::string &grading)
  {
    Simulation<1> simulation(read_parameters("",
                                             {"Contact/Compliance=" +
                                                compliance,
                                              "Mesh/Cells=" + cells,
                                              "Mesh/Grading=" + grading,
                                              "Time/End time=0.5"}),
                             MPI_COMM_SELF);
    simulation.run();
    const auto &warnings = simulation.history().warnings;
    const auto  n_warnings =
      std::count_if(warnings.begin(), warnings.end(), [](const std::string &w) {
        return w.find("largest force is that of the mesh") != std::string::npos;
      });
    const double error =
      std::abs(simulation.history().max_contact_force / fine - 1.);
    deallog << "compliance " << compliance << ", cells " << cells
            << ", grading " << grading << ": warnings " << n_warnings << ", ";
    if (n_warnings == 0)
      deallog << "error of the force "
              << within(error, cells == "8" ? 0.01 : 1e-4) << std::endl;
    else
      deallog << "a fifth over the error of the force "
              << within(0.2 / error, 1.) << std::endl;
  }



  void
  check_touch()
  {
    const RecordedRun   result = run<1>("",
                                      {"Model/Fields=displacement",
                                         "Model/Inertia=0",
                                         "Model/Viscosity=0.2",
                                         "Mesh/Cells=2",
                                         "Boundary/right/Traction=0.5",
                                         "Contact/Condition=rigid",
                                         "Contact/Gap=0.3",
                                         "Time/Tolerance=1e-6",
                                         "Time/End time=0.4"});
    const auto          row    = std::find_if(result.rows.begin(),
                                  result.rows.end(),
                                  [](const StepRecord &r) {
                                    return r.displacement_end == 0.3;
                                  });
    const ContactEvent &event  = result.events.front();
    deallog << "pushed to an obstacle: contact at "
            << within(std::abs(row->time - 0.2 * std::log(2.5)), 1e-5)
            << " with velocity " << within(std::abs(event.velocity - 1.), 1e-4)
            << ", behind it velocity "
            << within(std::abs(row->velocity_end), 1e-10) << ", force "
            << within(std::abs(row->contact_force - 0.2), 1e-10) << std::endl;
  }



  void
  check_velocities_behind_events()
  {
    const RecordedRun result = run<1>("examples/thermal-switch.prm",
                                      {"Time/Tolerance=1e-7",
                                       "Contact/Gap=0.04",
                                       "Initial values/Temperature=0",
                                       "Boundary/right/Surroundings=40",
                                       "Model/Inertia=0.01",
                                       "Contact/Massless nodes=on",
                                       "Time/End time=1"});
    double            error  = 0.;
    unsigned int      n      = 0;
    for (unsigned int i = 0; i + 1 < result.rows.size(); ++i)
      for (const ContactEvent &event : result.events)
        if (std::abs(event.time - result.rows[i].time) < 1e-11)
          {
            const StepRecord &a = result.rows[i], &b = result.rows[i + 1];
            const double      mean =
              (b.displacement_end - a.displacement_end) / (b.time - a.time);
            error =
              std::max(error,
                       std::abs(a.velocity_end + b.velocity_end - 2. * mean) /
                         std::abs(mean));
            ++n;
          }
    deallog << "velocities behind events, of " << result.events.size()
            << " all but " << result.events.size() - n << ": "
            << within(error, 0.01) << std::endl;
  }
} // namespace



void
main_obstacle_kinks()
{
  initlog();
  check_kink("faster towards the rod", "-0.5", -0.5, 0.4);
  check_kink("away faster than the rod follows", "2", 1.5, 0.);
  for (const auto &[compliance, fine] : {std::pair("1e-3", 5.61045),
                                         std::pair("1e-4", 11.7309),
                                         std::pair("1e-7", 116.365)})
    {
      check_peak(compliance, fine, "8", "1");
      check_peak(compliance, fine, "automatic", "1");
    }
  check_peak("1e-3", 5.61045, "8", "1e4");
  check_peak("1e-4", 11.7309, "8", "1e4");
  check_velocities_behind_events();
  check_touch();
}
