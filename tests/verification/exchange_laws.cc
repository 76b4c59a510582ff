// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Heat exchange that depends on the temperatures and on time, doc/model.md
// (M5.1).
//
// 1. k = (theta^2 + theta_obs^2)(theta + theta_obs)/2, as of radiation, so that
//    the end loses (theta^4 - theta_obs^4)/2: a rod between theta_A = 2 and
//    theta_obs = 1 rests where 2 - theta(1) = (theta(1)^4 - 1)/2, by bisection.
//    The forecast to 1e-12; the end of a run, of heat alone and with both
//    fields and no obstacle, to 1e-9.
// 2. theta = t + x^2/2 solves the heat equation, -theta_x = -1 at x = 1, where
//    theta = t + 1/2 =: T. With k = T^2, or k = 1/(1 + t), it is the solution
//    for theta_obs = T + 1/k. Each stage of a method of Runge and Kutta is
//    exact, so that rods, strips and blocks have it to 1e-11 (iterative: 1e-6,
//    its tolerance is 1e-9), and the scheme box, whose k goes evenly through a
//    step, with an error of order 2 (to 0.3) in its steps.
//    What goes in and out is the energy, doc/model.md (M6.1): with backward
//    Euler the balance of each step closes to 1e-13.
// 3. k = if(t < 0.3, 0, 2): a step ends at t = 0.3, and before it nothing
//    flows, to the last bit.
// 4. What depends on nothing more than before by name: k(gap, p) + 0 theta +
//    0 t gives theta(1), force and impulse of k(gap, p) to 1e-10, of a rod with
//    both schemes and of a strip with both solvers (iterative: 1e-6).

#include <thermocontact/forecast/forecast.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../tests.h"

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const std::string k = "Boundary/right/Heat exchange=";

  const Overrides heat_alone{"Model/Fields=temperature"};

  const Overrides both{"Model/Fields=temperature and displacement",
                       "Contact/Condition=none",
                       "Model/Coupling=0",
                       "Initial values/Velocity=0"};



  void
  check_radiation()
  {
    double low = 1., high = 2.;
    while (high - low > 1e-15)
      {
        const double middle = 0.5 * (low + high);
        (2. - middle > 0.5 * (std::pow(middle, 4) - 1.) ? low : high) = middle;
        if (middle == low && 0.5 * (low + high) == low)
          break;
      }
    const Overrides scene{k + "(theta^2+theta_obs^2)*(theta+theta_obs)/2",
                          "Boundary/left/Temperature=2",
                          "Boundary/right/Surroundings=1",
                          "Initial values/Temperature=2",
                          "Time/Tolerance=1e-9",
                          "Time/End time=12"};
    for (const Overrides &fields : {heat_alone, both})
      {
        const Parameters parameters = read_parameters("", scene + fields);
        const auto       states     = steady_state(Scene(parameters)).states;
        const StepRecord end        = run<1>("", scene + fields).rows.back();
        deallog << "radiation: states " << states.size() << ", forecast "
                << within(std::abs(states.at(0).temperature_end - low), 1e-12)
                << ", run " << within(std::abs(end.temperature_end - low), 1e-9)
                << std::endl;
      }
  }



  const Overrides exact{"Boundary/left/Temperature=t",
                        "Initial values/Temperature=x^2/2",
                        "Time/End time=1"};

  const std::vector<std::pair<std::string, std::string>> exchanges{
    {"theta^2", "t+0.5+1/(t+0.5)^2"},
    {"1/(1+t)", "t+0.5+1+t"},
    {"theta_obs-theta", "t+0.5+1"}};



  /** The largest error of the end in all rows. */
  template <int dim>
  double
  error_of(const Overrides &scene)
  {
    double error = 0.;
    for (const StepRecord &r : run<dim>("", exact + scene).rows)
      {
        raise(error, std::abs(r.temperature_end - r.time - 0.5));
        raise(error, std::abs(r.temperature_mean - r.time - 1. / 6.));
        raise(error, std::abs(r.heat_flux_end + 1.));
      }
    return error;
  }



  void
  check_exact()
  {
    for (const auto &[coefficient, surroundings] : exchanges)
      {
        const Overrides scene{k + coefficient,
                              "Boundary/right/Surroundings=" + surroundings};
        double          rods = 0., bodies = 0., iterative = 0., balance = 0.;
        for (const Overrides &fields : {heat_alone, both})
          for (const std::string scheme :
               {"backward euler", "sdirk2", "sdirk3", "sdirk4"})
            raise(rods,
                  error_of<1>(
                    scene + fields +
                    Overrides{"Time/Scheme=" + scheme, "Time/Step size=0.05"}));
        const Overrides stepped =
          scene + heat_alone +
          Overrides{"Time/Scheme=sdirk2", "Time/Step size=0.1"};
        raise(bodies, error_of<2>(stepped + Overrides{"Dimension=2"}));
        raise(bodies,
              error_of<3>(stepped + Overrides{"Dimension=3",
                                              "Mesh/Cells=4",
                                              "Mesh/Cells across=1"}));
        raise(iterative,
              error_of<2>(
                stepped +
                Overrides{"Dimension=2", "Solver/Linear solver=iterative"}));
        const Overrides euler{"Time/Scheme=backward euler",
                              "Time/Step size=0.1"};
        const auto rows = run<1>("", exact + scene + heat_alone + euler).rows;
        for (const StepRecord &r : rows)
          raise(balance,
                std::abs(r.energy + r.dissipation + r.numerical_dissipation -
                         r.work - rows[0].energy));
        deallog << "k = " << coefficient << ": rods " << within(rods, 1e-11)
                << ", bodies " << within(bodies, 1e-11) << ", iterative "
                << within(iterative, 1e-6) << ", balance "
                << within(balance, 1e-13) << std::endl;
        double       errors[2];
        unsigned int i = 0;
        for (const std::string cells : {"20", "40"})
          errors[i++] = error_of<1>(scene + both +
                                    Overrides{"Model/Viscosity=0",
                                              "Time/Scheme=box",
                                              "Mesh/Cells=" + cells});
        deallog << "  box: "
                << (errors[1] < 1e-11 ||
                    std::abs(std::log2(errors[0] / errors[1]) - 2.) < 0.3)
                << std::endl;
      }
  }



  void
  check_jump()
  {
    bool   has_step = false;
    double early    = 0.;
    for (const StepRecord &r :
         run<1>("",
                heat_alone + Overrides{k + "if(t<0.3,0,2)",
                                       "Boundary/left/Temperature=1",
                                       "Boundary/right/Surroundings=0",
                                       "Initial values/Temperature=1",
                                       "Time/End time=1"})
           .rows)
      {
        has_step |= std::abs(r.time - 0.3) < 1e-14;
        if (r.time < 0.3)
          raise(early,
                std::max(std::abs(r.heat_flux_end),
                         std::abs(r.temperature_end - 1.)));
      }
    deallog << "jump in time: a step ends there " << has_step
            << ", before it nothing " << (early == 0.) << std::endl;
  }



  void
  check_names()
  {
    const std::string law = "if(pressure>0,1+pressure,0.1/(0.1+gap))";
    const Overrides   scene{"Contact/Condition=normal compliance",
                          "Time/End time=2"};
    const auto        compare = [&](const auto &of, const double bound) {
      const StepRecord one = of(scene + Overrides{k + law}).rows.back();
      const StepRecord other =
        of(scene + Overrides{k + law + "+0*theta+0*t"}).rows.back();
      double error = std::abs(one.temperature_end - other.temperature_end);
      raise(error, std::abs(one.contact_force - other.contact_force));
      raise(error, std::abs(one.contact_impulse - other.contact_impulse));
      return within(error, bound);
    };
    const auto rod = [](const Overrides &scene) { return run<1>("", scene); };
    const auto box = [](const Overrides &scene) {
      return run<1>("",
                    scene + Overrides{"Time/Scheme=box",
                                      "Model/Viscosity=0",
                                      "Mesh/Cells=40"});
    };
    const Overrides body{"Dimension=2",
                         "Mesh/Cells=6",
                         "Mesh/Cells across=2",
                         "Mesh/Degree=2",
                         "Time/Scheme=sdirk2",
                         "Time/Step size=0.05"};
    const auto      strip = [&](const Overrides &scene) {
      return run<2>("", scene + body);
    };
    const auto iterative = [&](const Overrides &scene) {
      return run<2>("",
                    scene + body + Overrides{"Solver/Linear solver=iterative"});
    };
    deallog << "by name: sdirk4 " << compare(rod, 1e-10) << ", box "
            << compare(box, 1e-10) << ", strip " << compare(strip, 1e-10)
            << ", iterative " << compare(iterative, 1e-6) << std::endl;
  }
} // namespace



void
main_exchange_laws()
{
  initlog();
  check_radiation();
  check_exact();
  check_jump();
  check_names();
}
