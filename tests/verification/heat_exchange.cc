// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Heat exchange that depends on gap and pressure, doc/contact-in-time.md
// section 5.
//
// 1. prm/examples/thermal-switch.prm: the states of rest are roots of the
//    quadratic equations in the file, derived by hand there; forecast to 1e-12,
//    the second unstable. Runs that start with the profiles of c = 0.35 and
//    0.36, on both sides of the unstable one, reach the first and the third:
//    u(1), theta(1) and force to 1e-6.
// 2. k = if(pressure > 0, 10, 0.1), a hot rod before a cold obstacle: without
//    contact it is too long and with contact too short, so that at rest it
//    touches without pressure: G = a (theta_A - c theta_A/2) = g = 0.12, c =
//    2 (1 - g/(a theta_A)) = 0.588235, k/(k+1) = c between the two. Forecast,
//    and the ends of a run in equilibrium and of one with inertia: theta(1) to
//    1e-6.
// 3. Orders of the schemes with an exchange that varies with the gap: theta(1)
//    at t = 0.5 against sdirk4 with small steps, rates to 0.15.
// 4. A body with mass whose exchange rises steeply with the pressure, thrown
//    at the obstacle: the step ends next to the events miss them by a hundredth
//    of the tolerance of max |u(1)| at most, (C3.1), although the impulse alone
//    would allow more.
// 5. k = if(gap > 0, 0, 3), bodies in equilibrium that are pressed on a rigid
//    obstacle at the start, theta = 5: what goes with a pressure has no gap,
//    whatever rounding its place has, so that the first flux is 3 * 5 at all
//    nodes, of rods and strips with eight gaps each.

#include <thermocontact/forecast/forecast.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../tests.h"

#include "../lateral_runs.h"

using namespace ThermoContact;

namespace
{
  void
  check_switch()
  {
    const std::string file = "examples/thermal-switch.prm";
    const double      open = (0.045 - std::sqrt(0.002025 - 0.0017)) / 0.17;
    const double      root = std::sqrt(21.485 * 21.485 - 4. * 17. * 5.495);
    const std::array<double, 3> drops{
      {open, (21.485 - root) / 34., (21.485 + root) / 34.}};

    const Scene scene(read_parameters(file));
    const auto  states = steady_state(scene).states;
    deallog << "switch: states " << states.size() << ", stable";
    double error = 0.;
    for (unsigned int i = 0; i < states.size() && i < 3; ++i)
      {
        deallog << ' ' << states[i].is_stable;
        raise(error, std::abs(states[i].temperature_end - 10. * drops[i]));
      }
    deallog << ", theta(1) " << within(error, 1e-12) << std::endl;

    for (const auto &[start, drop] :
         {std::pair("0.35", drops[0]), std::pair("0.36", drops[2])})
      {
        const StepRecord end =
          run<1>(
            read_parameters(file,
                            {std::string("Initial values/Temperature=10*") +
                             start + "*x"}))
            .back();
        const double expansion = 0.085 * drop;
        const double force     = std::max(0., (expansion - 0.03) / 1.01);
        deallog << "switch from c = " << start << ": in contact "
                << end.in_contact << ", theta(1), force, u(1) "
                << within(std::abs(end.temperature_end - 10. * drop), 1e-6)
                << ' ' << within(std::abs(end.contact_force - force), 1e-6)
                << ' '
                << within(std::abs(end.displacement_end - expansion + force),
                          1e-6)
                << std::endl;
      }
  }



  void
  check_imperfect_contact()
  {
    const double    theta = 10. * (1. - 2. * (1. - 0.12 / 0.17));
    const Overrides scene{
      "Boundary/right/Heat exchange=if(pressure > 0, 10, 0.1)",
      "Contact/Gap=0.12",
      "Time/End time=40"};
    for (const Overrides &inertia :
         {Overrides{"Model/Inertia=0", "Model/Viscosity=0"},
          Overrides{"Time/Scheme=backward euler", "Time/Step size=0.02"}})
      {
        const Parameters parameters = read_parameters("", scene + inertia);
        const auto       states     = steady_state(Scene(parameters)).states;
        const StepRecord end        = run<1>(parameters).back();
        deallog << "imperfect contact: states " << states.size()
                << ", theta(1) forecast "
                << within(std::abs(states[0].temperature_end - theta), 1e-12)
                << ", reached "
                << within(std::abs(end.temperature_end - theta), 1e-6)
                << ", flux " << end.heat_flux_end / (10. - theta) << std::endl;
      }
  }



  /** A rod that is thrown at a warm obstacle, and its exchange. */
  const Overrides thrown{
    "Model/Coupling=0.3",
    "Boundary/left/Temperature=1",
    "Boundary/right/Surroundings=0.5",
    "Boundary/right/Heat exchange=0.05/(0.05+gap)+20*pressure",
    "Contact/Gap=0.05",
    "Contact/Compliance=0.1",
    "Initial values/Temperature=theta_A*(1-x^2)",
    "Initial values/Velocity=x",
    "Time/Step size=0.01",
    "Time/End time=2"};



  void
  check_misses_of_events()
  {
    const double tolerance            = 1e-5;
    const auto [rows, events, counts] = run<1>("examples/thermal-switch.prm",
                                               {"Model/Inertia=1",
                                                "Model/Viscosity=0.1",
                                                "Initial values/Velocity=x",
                                                "Mesh/Cells=8",
                                                "Mesh/Degree=3",
                                                "Time/Tolerance=1e-5",
                                                "Time/End time=13"});
    double largest = 0., miss = 0.;
    for (const StepRecord &r : rows)
      raise(largest, std::abs(r.displacement_end));
    unsigned int n_events = 0;
    for (const ContactEvent &event : events)
      {
        if (event.time == 0.)
          continue;
        ++n_events;
        const auto nearest =
          std::min_element(rows.begin(),
                           rows.end(),
                           [&](const StepRecord &a, const StepRecord &b) {
                             return std::abs(a.time - event.time) <
                                    std::abs(b.time - event.time);
                           });
        raise(miss, std::abs(nearest->gap));
      }
    const double ratio = miss / (0.01 * tolerance * largest);
    deallog << "misses of events, several " << (n_events >= 4)
            << ", within their bound " << within(ratio, 1.) << std::endl;
    if (!(ratio <= 1.))
      deallog << ratio << std::endl;
  }



  double
  temperature_end(const std::string &scheme, const unsigned int n_steps)
  {
    return run<1>(
             read_parameters("",
                             {"Time/Scheme=" + scheme,
                              "Time/Start=consistent",
                              "Time/End time=0.5",
                              "Time/Step size=" + std::to_string(0.5 / n_steps),
                              "Model/Coupling=0.3",
                              "Boundary/left/Temperature=1",
                              "Boundary/right/Heat exchange=0.5/(0.5+gap)",
                              "Contact/Gap=2",
                              "Initial values/Temperature=theta_A*(1+x*(2-x))",
                              "Initial values/Velocity=0",
                              "Mesh/Cells=1",
                              "Mesh/Degree=3"}))
      .back()
      .temperature_end;
  }



  void
  check_orders()
  {
    const double reference = temperature_end("sdirk4", 1280);
    for (const auto &[scheme, order] : {std::pair("backward euler", 1.),
                                        std::pair("sdirk2", 2.),
                                        std::pair("sdirk3", 3.),
                                        std::pair("sdirk4", 4.)})
      {
        const double coarse = temperature_end(scheme, 40) - reference;
        const double fine   = temperature_end(scheme, 80) - reference;
        const double rate   = std::log2(std::abs(coarse / fine));
        deallog << "order of " << scheme << " "
                << within(std::abs(rate - order), 0.15) << std::endl;
      }
  }



  template <int dim>
  double
  error_of_first_flux()
  {
    double error = 0.;
    for (unsigned int i = 1; i <= 8; ++i)
      {
        Simulation<dim> simulation(
          read_parameters("",
                          {"Dimension=" + std::to_string(dim),
                           "Model/Inertia=0",
                           "Model/Viscosity=0",
                           "Model/Poisson ratio=" +
                             std::string(dim == 1 ? "0" : "0.3"),
                           "Contact/Condition=rigid",
                           "Contact/Gap=-0.01*" + std::to_string(i) + "/3",
                           "Boundary/right/Heat exchange=if(gap>0,0,3)",
                           "Initial values/Temperature=5",
                           "Mesh/Cells=4",
                           "Time/End time=0.01"}),
          MPI_COMM_SELF);
        raise(error, std::abs(simulation.record().heat_flux_end / 15. - 1.));
      }
    return error;
  }
} // namespace



void
main_heat_exchange()
{
  initlog();
  check_switch();
  check_imperfect_contact();
  check_misses_of_events();
  check_orders();
  deallog << "first flux through a pressed end, rod "
          << within(error_of_first_flux<1>(), 1e-10) << ", strip "
          << within(error_of_first_flux<2>(), 1e-10) << std::endl;
}
