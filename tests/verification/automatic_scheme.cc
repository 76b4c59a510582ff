// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Time/Scheme = automatic, and what the defaults say of fronts in a rod.
//
// 1. Which scheme, cells and degree. The length of a front is
//    L = (zeta/b^(1/2))^(1/2), or that of a linear obstacle, eps. It needs
//    eight nodes of the default mesh, which has 32 to the rod: L >= 1/4, that
//    is zeta >= 1/16 for b = 1, 1/4 for b = 16, or eps >= 1/4. A sharper one
//    has n cells of degree p = 8: n >= 10.5/(p (p + 1) l), l = (zeta t/b)^(1/2)
//    with t^3 = b eps^2 (t + zeta), and the smaller one of two numbers: n >=
//    8/(p L) and so many that zeta >= 2 w (b (1 + w/eps))^(1/2), w = 1/(n p (p
//    + 1)), or on a rigid obstacle zeta >= b^(1/2)/(n p); or n >= 16/(p eps).
//    b = 1: zeta = 0.0624, eps = 0.01: L = 0.2498, 4.003 -> 5, l = 0.0355, 4.1;
//    0.01, eps = 0.05: L = 0.1, 10, l = 0.0231, 6.3, at degree 3 26.7 and 37.9
//    -> 38; eps = 0.002: t = 0.00381, l = 0.00617, 23.6 -> 24; rigid 12.5 ->
//    13; without an obstacle 10; 0.001, eps = 0.05: 31.6 -> 32, w = 4.34e-4, 2
//    w (1 + w/eps)^(1/2) = 8.72e-4, instead of 40; l = 0.0071, 20.5; 3e-4: 40,
//    as w <= 1.5e-4 needs 93, l = 0.00388, 37.6; 1e-4: l = 0.00224, 65.1 -> 66.
//    The box scheme has 2 tolerance^(-1/2) cells, in multiples of 8: 632.5 ->
//    640, 200, 64, and not less than 40, but where cells times steps are more
//    than 1e8 for T = 10 at 1e-9 3162 -> 3160, and takes over where n p is more
//    than twice that: 1e-5 needs l = 7.07e-4, 206, more than 160; 0.003 at a
//    tolerance of 1e-3 18.3 -> 19, more than 16. At 1e-7 n is 100^(1/8) = 1.78
//    times as much: 0.01 has 17.8 -> 18. Fewer cells than n that are given are
//    those of box, too. Where waves are smooth, n is for layers l below 10.5 of
//    the lengths 1/(8 4 5) of the default mesh, 0.0656, with zeta = 0.2 below
//    eps = (l^6/(zeta^2 (l^2 + zeta^2)))^(1/2) = 0.00671: 0.0066 has 2.24 -> 3;
//    zeta = 0.1, eps = 0.005: t = 0.0142, l = 0.0377, 3.87 -> 4, at 1e-7 6.9 ->
//    7; zeta = 0.2, eps = 1e-4: t = 0.00126, l = 0.0159, 9.2 -> 10; 1e-9: l
//    = 3.4e-4, 427, more than 160: the default mesh, as on a power law, below a
//    mass, and beside cells or a degree that are given. Without an obstacle
//    fronts are made by a traction that jumps in the run or at its start (where
//    u_x - a theta is not the traction), by the velocity of the fixed end, and
//    by initial values that jump, but not by inputs that bend or begin like
//    t^2. A mass m on the end swings on a stop, also on a damped one, with a
//    wave of 2 pi (eps m/b)^(1/2): 1.4 and, for m = 0.03, 0.243 with eps =
//    0.05. Masses alone have no waves, and no impacts where all contacts give
//    way; side by side they send impacts on.
// 2. A second choice on top of the first changes nothing.
// 3. An obstacle at g = -V t meets a rod at rest, b = 1, zeta = 0: the force is
//    V until the wave returns at t = 2, the impulse V t. On any number of
//    cells, also with b = 4, where the force is V b^(1/2) until t = 4. A strip
//    between rollers says that its largest force is that of the mesh, and so
//    does sdirk4.
// 4. A rod under gravity f = 1, rigid at g = 0.3. The end falls like t^2/2 and
//    meets the obstacle at t = 0.6^(1/2) = 0.77460. By d'Alembert contact
//    begins again at 3.1056, 5.5528, 8.6325, 11.000; the largest force
//    is 1.000, the impulse up to t = 12 3.300 (box_bars.cc).
// 5. Two masses 1 and a wall, eps = 1e-8, by default: the first one, with
//    velocity 1, meets the second one, that the wall, and the second one the
//    first one again, so that the forces begin at 1/2, 3/2 and 5/2 and what
//    contacts take, up to 2 pi (eps/2)^(1/2) = 4.4e-4, and are half waves of
//    sines with the peak (1/eps)^(1/2) = 1e4 at the wall. Steps of a fiftieth
//    of a contact would be more than 1e6 up to t = 3.

#include <thermocontact/scene/scheme_choice.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/simulation/spatial_error_monitor.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../tests.h"

#include "../overrides.h"

using namespace ThermoContact;

namespace
{
  const Overrides elastic = {"Model/Fields=displacement",
                             "Model/Viscosity=0",
                             "Contact/Condition=rigid",
                             "Initial values/Velocity=0"};

  void
  choose(const std::string &name, const Overrides &overrides)
  {
    const SchemeChoice choice = choose_scheme(read_parameters("", overrides));
    const Parameters  &chosen = choice.parameters;
    deallog << name << ": " << chosen.time.scheme << ", degree "
            << chosen.mesh.degree << ", " << chosen.mesh.cells << " cells"
            << (choice.has_unresolved_fronts ? ", fronts unresolved" : "")
            << std::endl;
    const SchemeChoice again = choose_scheme(chosen);
    if (!again.entries.empty() ||
        again.parameters.time.scheme != chosen.time.scheme ||
        again.parameters.mesh.cells != chosen.mesh.cells ||
        again.parameters.time.step_size != chosen.time.step_size)
      deallog << "a second choice differs" << std::endl;
  }



  template <int dim>
  void
  meet_moving_wall(const std::string &name, const Overrides &more)
  {
    const Parameters parameters =
      read_parameters("", elastic + Overrides{"Contact/Gap=-0.01*t"} + more);
    Simulation<dim> simulation(parameters, MPI_COMM_SELF);
    simulation.run();
    const RunHistory &history = simulation.history();
    const double      root    = std::sqrt(parameters.model.inertia);
    deallog << name << ": ";
    if (is_largest_force_of_mesh(simulation.scene(), history.events))
      deallog << "the largest force is that of the mesh" << std::endl;
    else
      deallog << "force "
              << noise_within(std::abs(
                                history.max_contact_force / (0.01 * root) - 1.),
                              1e-11)
              << ", impulse "
              << noise_within(std::abs(history.record.contact_impulse /
                                         (0.01 * root * history.record.time) -
                                       1.),
                              1e-11)
              << std::endl;
  }



  void
  fall()
  {
    Simulation<1> simulation(read_parameters("",
                                             elastic +
                                               Overrides{"Contact/Gap=0.3",
                                                         "Sources/Body force=1",
                                                         "Time/End time=12"}),
                             MPI_COMM_SELF);
    simulation.run();
    const double begins[] = {std::sqrt(0.6),
                             4. - std::sqrt(0.8),
                             6. - std::sqrt(0.2),
                             8. + std::sqrt(0.4),
                             11.};
    double       error    = 0.;
    for (const double begin : begins)
      {
        double nearest = 1.; // touches without pressure are others
        for (const ContactEvent &event : simulation.events())
          if (event.kind == ContactEvent::begin)
            nearest = std::min(nearest, std::abs(event.time - begin));
        raise(error, nearest);
      }
    const RunHistory &history = simulation.history();
    deallog << "gravity: begins " << noise_within(error, 1e-4) << ", force "
            << noise_within(std::abs(history.max_contact_force - 1.), 0.01)
            << ", impulse "
            << noise_within(std::abs(history.record.contact_impulse / 3.3 - 1.),
                            1e-3)
            << std::endl;
  }



  void
  throw_masses(const Overrides &masses)
  {
    Simulation<1> simulation(
      read_parameters("",
                      masses + Overrides{"Contacts/a b/Gap=0.5",
                                         "Contact/Gap=1",
                                         "Contact/Compliance=1e-8",
                                         "Time/End time=3"}),
      MPI_COMM_SELF);
    simulation.run();
    double       error = 0.;
    unsigned int n     = 0;
    for (const ContactEvent &event : simulation.events())
      if (event.kind == ContactEvent::begin)
        raise(error, std::abs(event.time - 0.5 - n++));
    const RunHistory &history = simulation.history();
    deallog << "two masses and a wall: begins " << n << ", at "
            << within(error, 5e-4) << ", force "
            << within(std::abs(history.max_contact_force / 1e4 - 1.), 1e-4)
            << ", steps up to a thousand: "
            << (history.record.step <= 1000 ? "yes" : "no") << std::endl;
  }
} // namespace



void
main_automatic_scheme()
{
  initlog();

  choose("default", {});
  const Overrides rigid = {"Contact/Condition=rigid"};
  choose("zeta 0.0626", rigid + Overrides{"Model/Viscosity=0.0626"});
  choose("zeta 0.0624", rigid + Overrides{"Model/Viscosity=0.0624"});
  const Overrides heavy = rigid + Overrides{"Model/Inertia=16"};
  choose("b 16, zeta 0.251", heavy + Overrides{"Model/Viscosity=0.251"});
  choose("b 16, zeta 0.249", heavy + Overrides{"Model/Viscosity=0.249"});
  choose("eps 0.0068", {"Contact/Compliance=0.0068"});
  choose("eps 0.0066", {"Contact/Compliance=0.0066"});
  const Overrides hard = {"Model/Viscosity=0.1", "Contact/Compliance=0.005"};
  choose("hard", hard);
  choose("hard, tolerance 1e-7", hard + Overrides{"Time/Tolerance=1e-7"});
  choose("hard, 12 cells", hard + Overrides{"Mesh/Cells=12"});
  choose("hard, degree 5", hard + Overrides{"Mesh/Degree=5"});
  choose("hard, a mass", hard + Overrides{"Boundary/right/Mass=1"});
  choose("hard, a power law", hard + Overrides{"Contact/Condition=power law"});
  choose("harder", {"Contact/Compliance=1e-4"});
  choose("hardest", {"Contact/Compliance=1e-9"});
  const Overrides weak = {"Model/Viscosity=0.01", "Contact/Compliance=0.05"};
  choose("zeta 0.01", weak);
  choose("zeta 0.01, degree 3", weak + Overrides{"Mesh/Degree=3"});
  choose("zeta 0.01, fixed steps", weak + Overrides{"Time/Step size=0.01"});
  choose("zeta 0.01, 12 cells", weak + Overrides{"Mesh/Cells=12"});
  choose("zeta 0.01, 9 cells", weak + Overrides{"Mesh/Cells=9"});
  choose("zeta 0.01, degree 1", weak + Overrides{"Mesh/Degree=1"});
  choose("zeta 0.003, tolerance 1e-3",
         weak + Overrides{"Model/Viscosity=0.003", "Time/Tolerance=1e-3"});
  choose("zeta 0.01, tolerance 1e-7", weak + Overrides{"Time/Tolerance=1e-7"});
  choose("zeta 0.01, sdirk4", weak + Overrides{"Time/Scheme=sdirk4"});
  choose("zeta 0.01, eps 0.002", weak + Overrides{"Contact/Compliance=0.002"});
  choose("zeta 0.01, rigid",
         {"Model/Viscosity=0.01", "Contact/Condition=rigid"});
  choose("zeta 0.01, pulled",
         {"Model/Viscosity=0.01",
          "Contact/Condition=none",
          "Boundary/right/Traction=1"});
  choose("zeta 0.001", weak + Overrides{"Model/Viscosity=0.001"});
  choose("zeta 3e-4", weak + Overrides{"Model/Viscosity=3e-4"});
  choose("zeta 1e-4", weak + Overrides{"Model/Viscosity=1e-4"});
  choose("zeta 1e-5", weak + Overrides{"Model/Viscosity=1e-5"});
  choose("no inertia", {"Model/Inertia=0", "Model/Viscosity=0"});
  choose("heat alone", {"Model/Fields=temperature"});
  choose("rigid", elastic);
  choose("tolerance 1e-4", elastic + Overrides{"Time/Tolerance=1e-4"});
  choose("tolerance 1e-9", elastic + Overrides{"Time/Tolerance=1e-9"});
  choose("tolerance 0.1", elastic + Overrides{"Time/Tolerance=0.1"});
  choose("12 cells", elastic + Overrides{"Mesh/Cells=12"});
  choose("degree 1", elastic + Overrides{"Mesh/Degree=1"});
  choose("degree 3", elastic + Overrides{"Mesh/Degree=3"});
  choose("fixed steps", elastic + Overrides{"Time/Step size=0.01"});
  choose("sdirk4", elastic + Overrides{"Time/Scheme=sdirk4"});
  choose("box", {"Time/Scheme=box", "Model/Viscosity=0"});
  choose("T 1e4", elastic + Overrides{"Time/End time=1e4"});
  choose("strip", elastic + Overrides{"Dimension=2"});
  const Overrides soft = {"Model/Viscosity=0"};
  choose("eps 0.26", soft + Overrides{"Contact/Compliance=0.26"});
  choose("eps 0.24", soft + Overrides{"Contact/Compliance=0.24"});
  const Overrides swung = {"Model/Viscosity=0",
                           "Contact/Compliance=0.05",
                           "Contact/Damping=1",
                           "Initial values/Velocity=x"};
  choose("mass on a damped stop", swung + Overrides{"Boundary/right/Mass=1"});
  choose("light mass", swung + Overrides{"Boundary/right/Mass=0.03"});
  choose("damped stop", swung);
  const Overrides free = {"Model/Viscosity=0", "Contact/Condition=none"};
  choose("free", free);
  choose("pull from the start", free + Overrides{"Boundary/right/Traction=1"});
  choose("pull that grows", free + Overrides{"Boundary/right/Traction=sin(t)"});
  choose("pull that jumps",
         free + Overrides{"Boundary/right/Traction=if(t<1,0,t)"});
  choose("initial strain in balance",
         free + Overrides{"Initial values/Displacement=0.5*x",
                          "Boundary/right/Traction=0.5"});
  const Overrides driven = free + Overrides{"Initial values/Velocity=0"};
  choose("end with a velocity",
         driven + Overrides{"Boundary/left/Displacement=0.01*t"});
  choose("end that begins like t^2",
         driven + Overrides{"Boundary/left/Displacement=0.01*t^2"});
  choose("velocity that jumps",
         free + Overrides{"Initial values/Velocity=if(x>0.3,1,0)"});
  choose("velocity that bends",
         free + Overrides{"Initial values/Velocity=abs(x-0.3)-0.3"});
  choose("strain that jumps",
         free + Overrides{"Initial values/Displacement=if(x>0.3,0.3,x)"});
  choose("end that bends",
         driven + Overrides{"Boundary/left/Displacement=if(t<1,0,(t-1)/10)"});
  const Overrides masses =
    Overrides{"Model/Fields=displacement", "Boundary/left/Support=free"} +
    body("a", {"Kind=mass", "Mass=1", "Velocity=1"}) +
    body("b", {"Kind=mass", "Mass=1"});
  choose("masses", masses);
  choose("masses, a rigid contact",
         masses +
           Overrides{"Contacts/a b/Condition=rigid", "Contact/Restitution=1"});
  choose("masses side by side",
         masses + Overrides{"Contacts/a b/Gap=0", "Contact/Gap=1"});
  choose("masses and a rod", masses + body("c", {"Length=1"}));

  meet_moving_wall<1>("defaults", {"Time/End time=1.75"});
  for (const std::string cells : {"12", "48", "192"})
    meet_moving_wall<1>(cells + " cells",
                        {"Mesh/Cells=" + cells, "Time/End time=1.75"});
  meet_moving_wall<1>("b = 4", {"Model/Inertia=4", "Time/End time=3.5"});
  meet_moving_wall<1>("sdirk4", {"Time/Scheme=sdirk4", "Time/End time=1.75"});
  meet_moving_wall<2>("strip",
                      {"Dimension=2",
                       "Mesh/Cells across=1",
                       "Mesh/Degree=2",
                       "Time/End time=0.5"});
  fall();
  throw_masses(masses);
}
