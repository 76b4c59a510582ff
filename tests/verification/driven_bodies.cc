// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A fixed end that is heated or moved: what holds for every scene,
// doc/discretisation.md section 6.
//
// 1. The audit (D4.1) of experiment 1, backward Euler, each line by its own
//    formula, to 1e-11 of the largest term: theta_A or u_A or both vary, with
//    and without heating, a jump of theta_A, a kink of u_A, no inertia, a rigid
//    obstacle, heat that is lost along the rod, the iteration of the paper and
//    its first step, and the midpoint rule with theta_A; a strip with free
//    sides.
// 2. A strip on rollers (clamped or sliding, direct or iterative), a round rod
//    and a block with theta_A(t) and u_A(t) in contact give the rod's numbers,
//    to 1e-9.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../tests.h"

#include "../overrides.h"

using namespace ThermoContact;

namespace
{
  template <int dim>
  std::vector<StepRecord>
  run(const std::string &file, const Overrides &overrides)
  {
    std::vector<StepRecord> rows;
    Simulation<dim> simulation(read_parameters(file, overrides), MPI_COMM_SELF);
    simulation.run(
      {[&rows](const Simulation<dim> &s) { rows.push_back(s.record()); }});
    return rows;
  }



  /** Defect of (D4.1) over its largest term. */
  template <int dim>
  double
  audit_defect(const Overrides &overrides)
  {
    const auto rows    = run<dim>("paper/experiment-1.prm",
                               Overrides{"Time/Scheme=backward euler",
                                         "Time/Step size=0.01",
                                         "Time/Start=consistent",
                                         "Time/End time=1"} +
                                 overrides);
    double     largest = 0., defect = 0.;
    for (const StepRecord &r : rows)
      {
        for (const double term :
             {r.energy, r.work, r.dissipation, r.numerical_dissipation})
          raise(largest, std::abs(term));
        raise(defect,
              std::abs(rows[0].energy + r.work - r.energy - r.dissipation -
                       r.numerical_dissipation));
      }
    if (std::abs(rows.back().work) < 1e-6 * largest)
      return 1.; // a drive works
    return defect / largest;
  }



  void
  check_audit()
  {
    const std::string heated = "Boundary/Fixed end temperature=10+5*sin(7*t)";
    const std::string moved  = "Boundary/Fixed end displacement=0.02*sin(9*t)";
    const std::vector<Overrides> scenes = {
      {heated},
      {moved},
      {heated, moved},
      {heated, moved, "Model/Thermoelastic heating=false"},
      {heated, moved, "Mesh/Cells=1", "Mesh/Degree=1", "Model/Coupling=0.5"},
      {"Boundary/Fixed end temperature=if(t<0.505,10,3)"},
      {"Boundary/Fixed end displacement=max(0,t-0.305)/5"},
      {heated, moved, "Model/Inertia=0"},
      {heated, moved, "Model/Inertia=0", "Model/Viscosity=0"},
      {heated, moved, "Contact/Condition=rigid", "Contact/Gap=0.11"},
      {heated,
       moved,
       "Solver/Step solver=fixed point",
       "Time/Step size=0.001",
       "Solver/Fixed point tolerance=1e-15",
       "Time/End time=0.1"},
      {moved, "Model/Fields=displacement", "Mesh/Mass matrix=lumped"},
      {heated,
       "Boundary/Lateral heat exchange=3",
       "Boundary/Ambient temperature=-4"},
      {heated, "Time/Start=paper"},
      {heated, "Time/Scheme=energy conserving"}};
    deallog << "audit to 1e-11 ";
    for (const Overrides &scene : scenes)
      {
        const double defect = audit_defect<1>(scene);
        deallog << (defect < 1e-11);
      }
    deallog << (audit_defect<2>({"Dimension=2",
                                 "Mesh/Cells=6",
                                 "Mesh/Cells across=2",
                                 "Boundary/Lateral support=free",
                                 heated,
                                 moved}) < 1e-11)
            << std::endl;
  }



  double
  difference(const StepRecord &a, const StepRecord &b)
  {
    double error = 0.;
    for (const auto &[x, y] :
         {std::pair(a.displacement_end, b.displacement_end),
          std::pair(a.velocity_end, b.velocity_end),
          std::pair(a.temperature_end, b.temperature_end),
          std::pair(a.contact_force, b.contact_force),
          std::pair(a.contact_impulse, b.contact_impulse),
          std::pair(a.energy, b.energy),
          std::pair(a.work, b.work)})
      raise(error, std::abs(x - y) / std::max(1., std::abs(x)));
    return error;
  }



  void
  check_bodies()
  {
    const Overrides scene{"Boundary/Fixed end temperature=10+5*sin(7*t)",
                          "Boundary/Fixed end displacement=0.1*sin(9*t)",
                          "Time/Scheme=sdirk2",
                          "Time/Start=consistent",
                          "Time/Step size=0.01",
                          "Time/End time=0.4",
                          "Mesh/Cells=6",
                          "Mesh/Degree=2"};
    const Overrides body = {"Mesh/Cells across=2", "Model/Poisson ratio=0.3"};
    const Overrides iterate = {"Solver/Linear solver=iterative",
                               "Solver/Linear tolerance=1e-13"};
    const auto      last    = [&](const auto dimension, const Overrides &more) {
      return run<decltype(dimension)::value>("paper/experiment-1.prm",
                                             scene + more)
        .back();
    };
    using Rod                            = std::integral_constant<int, 1>;
    using Strip                          = std::integral_constant<int, 2>;
    using Block                          = std::integral_constant<int, 3>;
    const StepRecord              rod    = last(Rod(), {});
    const std::vector<StepRecord> bodies = {
      last(Strip(), body + Overrides{"Dimension=2"}),
      last(Strip(),
           body +
             Overrides{"Dimension=2", "Boundary/Fixed end support=sliding"}),
      last(Strip(), body + iterate + Overrides{"Dimension=2"}),
      last(Strip(),
           body + Overrides{"Dimension=2", "Mesh/Geometry=axisymmetric"}),
      last(Block(),
           body + iterate + Overrides{"Dimension=3", "Mesh/Cells across=1"})};
    deallog << "rod in contact " << (rod.contact_impulse > 1e-3)
            << ", strips and block to 1e-9 ";
    for (const StepRecord &r : bodies)
      {
        deallog << (difference(rod, r) < 1e-9);
      }
    deallog << std::endl;
  }
} // namespace



void
main_driven_bodies()
{
  initlog();
  check_audit();
  check_bodies();
}
