// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Two stops, Contact/Rear gap, doc/model.md section 4, on two processes.
//
// 1. A static rod under traction F, without thermal stress: u = F - p, and p by
//    hand. F = -1/2, g_2 = 0.2, eps = 1/2: p = -(0.5 - 0.2)/1.5 = -0.2, rigid
//    -0.3; power law m = 2, eps = 1/2: p = -4 s^2, s + 4 s^2 = 0.3, so that
//    s = (sqrt(5.8) - 1)/8: to 1e-12. With k = 2 if pressed by more than 0.1,
//    else 1, theta_A = 0, theta_obs = 1: theta(1) = 2/3 at rest, to 1e-6.
// 2. A strip whose lower part is drawn back and whose upper part is pushed, and
//    then the other way round: its nodes are at both stops at once. Two
//    processes have the columns of one, and the iterative solver those of the
//    direct one, to 1e-9; the audit closes to 1e-11.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../recorded_run.h"
#include "../row_checks.h"

using namespace ThermoContact;

namespace
{
  /** @param has_both_signs out: pressures of both signs at the same time */
  template <int dim>
  std::vector<StepRecord>
  rows_of(const Overrides &overrides,
          const MPI_Comm   communicator,
          bool            *has_both_signs = nullptr)
  {
    std::vector<StepRecord> rows;
    Simulation<dim> simulation(read_parameters("", overrides), communicator);
    simulation.run({[&](const Simulation<dim> &s) {
      rows.push_back(s.record());
      const auto [smallest, largest] =
        std::minmax_element(s.state().contact.pressure.begin(),
                            s.state().contact.pressure.end());
      if (has_both_signs != nullptr)
        *has_both_signs |= *smallest < -0.1 && *largest > 0.1;
    }});
    return rows;
  }



  const Overrides euler{"Time/Scheme=backward euler",
                        "Time/Start=consistent",
                        "Time/Step size=0.02"};
  const Overrides elastic{"Contact/Compliance=0.1"};
  const Overrides rigid{"Contact/Condition=rigid"};
  const Overrides power{"Contact/Condition=power law"};
  const Overrides damped{"Contact/Damping=0.3"};
  const Overrides is_static{"Model/Inertia=0", "Model/Viscosity=0"};
  const Overrides quasi_static{"Model/Inertia=0"};
  const Overrides massless{"Contact/Massless nodes=on"};
  const Overrides by_gap{
    "Boundary/right/Heat exchange=if(pressure>0,1+pressure,"
    "0.1/(0.1+gap))",
    "Boundary/right/Surroundings=2"};
  const Overrides iterative{"Solver/Linear solver=iterative",
                            "Solver/Linear tolerance=1e-13"};



  void
  check_rest()
  {
    const Overrides scene =
      is_static + Overrides{"Contact/Rear gap=0.2",
                            "Model/Coupling=0",
                            "Mesh/Cells=2",
                            "Mesh/Degree=1",
                            "Boundary/right/Traction=-0.5",
                            "Time/End time=0.1"};
    const Overrides soft{"Contact/Compliance=0.5"};
    const double    s = (std::sqrt(5.8) - 1.) / 8.;
    for (const auto &[name, choice, exact] :
         {std::make_tuple("linear", soft, -0.2),
          std::make_tuple("rigid", rigid, -0.3),
          std::make_tuple("power law",
                          soft + power + Overrides{"Contact/Exponent=2"},
                          -4. * s * s)})
      {
        const StepRecord last =
          rows_of<1>(scene + choice, MPI_COMM_SELF).back();
        deallog << "at rest, " << name << ": force "
                << within(std::abs(last.contact_force - exact), 1e-12)
                << ", displacement "
                << within(std::abs(last.displacement_end + 0.5 + exact), 1e-12)
                << std::endl;
      }
    const StepRecord last =
      rows_of<1>(
        scene + soft +
          Overrides{"Boundary/right/Heat exchange=if(pressure>0.1,2,1)",
                    "Boundary/left/Temperature=0",
                    "Boundary/right/Surroundings=1",
                    "Initial values/Temperature=0",
                    "Time/End time=12"},
        MPI_COMM_SELF)
        .back();
    deallog << "at rest, heat exchange of the rear stop "
            << within(std::abs(last.temperature_end - 2. / 3.), 1e-6)
            << std::endl;
  }



  void
  check_both_at_once(const std::string &name,
                     const Overrides   &choice,
                     const bool         has_iterative_solver)
  {
    const Overrides scene =
      euler + choice +
      Overrides{"Dimension=2",
                "Model/Coupling=0.05",
                "Boundary/left/Temperature=0",
                "Initial values/Temperature=0",
                "Contact/Gap=0.01",
                "Contact/Rear gap=0.012",
                "Mesh/Width=0.6",
                "Mesh/Cells=2",
                "Mesh/Cells across=3",
                "Mesh/Degree=2",
                "Boundary/sides/Support=free",
                "Boundary/right/Traction=2*sin(9*t)*(y-0.27)",
                "Time/End time=0.5"};
    const Overrides direct{"Solver/Linear solver=direct"};
    bool            is_at_both = false;
    const auto one = rows_of<2>(scene + direct, MPI_COMM_SELF, &is_at_both);
    const auto two = rows_of<2>(scene + direct, MPI_COMM_WORLD);
    deallog << "at once, " << name << ": " << 1 + is_at_both << " stops, audit "
            << within(audit(one).defect, 1e-11) << ", two processes "
            << within(difference(table_of(one), table_of(two)), 1e-9);
    if (has_iterative_solver)
      deallog << ", iterative "
              << within(difference(table_of(one),
                                   table_of(rows_of<2>(scene + iterative,
                                                       MPI_COMM_WORLD))),
                        1e-9);
    deallog << std::endl;
  }
} // namespace



void
main_stops_of_bodies()
{
  initlog();
  check_rest();

  const Overrides at_rest{"Initial values/Velocity=0"};
  const Overrides soft{"Contact/Compliance=0.02"};
  check_both_at_once("elastic", at_rest + soft, true);
  check_both_at_once("damped power law",
                     at_rest + soft + power + damped,
                     false);
  check_both_at_once("rigid", at_rest + rigid + massless, true);
  check_both_at_once("quasi-static rigid", rigid + quasi_static, true);
  check_both_at_once("heat exchange", at_rest + soft + by_gap, false);
}
