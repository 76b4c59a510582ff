// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Rods at obstacles with p = ([s]_+/eps)^m [1 + c s_t]_+, doc/model.md
// section 4; audits and bodies are in laws_and_drives.
//
// 1. Start in contact without inertia, one cell, u = -x/10, g = -0.3, eps =
//    0.4, m = 1, c = 2: zeta v + u + (s/eps)(1 + c v) = 0, s = 0.2, zeta = 1/2
//    gives v = (0.1 - 0.5)/(0.5 + 1) = -4/15 and the force 1/2 (1 - 8/15) =
//    7/30.
// 2. Orders: a preload in equilibrium, u = -x/10, g = -0.2, eps =
//    0.1^(1-1/m), so that p = 1/10 at rest, and the traction t^4/2, c = 1/2, m
//    = 1 and 3/2: u(1) at t = 1 in contact, one cell of degree 2, steps of 1/80
//    and 1/160 against sdirk4 with 1/1280: order of the scheme to 0.15.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  Overrides
  law(const double m, const double c)
  {
    return Overrides{"Contact/Condition=power law",
                     "Contact/Exponent=" + number(m),
                     "Contact/Damping=" + number(c)};
  }



  const Overrides one_cell{"Model/Fields=displacement",
                           "Mesh/Cells=1",
                           "Mesh/Degree=1"};



  void
  check_start_in_contact()
  {
    const RecordedRun result =
      run<1>("",
             one_cell + law(1., 2.) +
               Overrides{"Model/Inertia=0",
                         "Model/Viscosity=0.5",
                         "Contact/Gap=-0.3",
                         "Contact/Compliance=0.4",
                         "Initial values/Displacement=-x/10",
                         "Time/End time=0.01"});
    const StepRecord &first = result.rows.front();
    deallog << "start in contact: velocity over -4/15 "
            << within(std::abs(first.velocity_end * -15. / 4. - 1.), 1e-12)
            << ", force over 7/30 "
            << within(std::abs(first.contact_force * 30. / 7. - 1.), 1e-12)
            << std::endl;
  }



  double
  end_of_preload(const std::string &scheme, const double m, const double step)
  {
    return run<1>("",
                  law(m, 0.5) + Overrides{"Contact/Gap=-0.2",
                                          "Contact/Compliance=" +
                                            number(std::pow(0.1, 1. - 1. / m)),
                                          "Model/Fields=displacement",
                                          "Initial values/Displacement=-x/10",
                                          "Initial values/Velocity=0",
                                          "Sources/End traction=t^4/2",
                                          "Time/Scheme=" + scheme,
                                          "Time/Step size=" + number(step),
                                          "Time/Start=consistent",
                                          "Mesh/Cells=1",
                                          "Mesh/Degree=2",
                                          "Time/End time=1"})
      .rows.back()
      .displacement_end;
  }



  void
  check_orders(const double m)
  {
    const double exact = end_of_preload("sdirk4", m, 1. / 1280.);
    for (const auto &[scheme, order] : {std::pair("backward euler", 1.),
                                        std::pair("sdirk2", 2.),
                                        std::pair("sdirk3", 3.),
                                        std::pair("sdirk4", 4.)})
      {
        const double coarse = end_of_preload(scheme, m, 1. / 80.) - exact;
        const double fine   = end_of_preload(scheme, m, 1. / 160.) - exact;
        const double rate   = std::log2(std::abs(coarse / fine));
        deallog << "m = " << m << ", " << scheme << ": order " << order
                << ", missed by " << within(std::abs(rate - order), 0.15)
                << std::endl;
      }
  }
} // namespace



void
main_damped_orders()
{
  initlog();
  check_start_in_contact();
  for (const double m : {1., 1.5})
    check_orders(m);
}
