// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Heat that is lost along the rod, doc/model.md section 5: states of rest,
// limits. Bodies: lateral_bodies.cc.
//
// 1. prm/verification/lateral-loss.prm, derived there: at the end of the run
//    all nodes, the forecast of theta(1), the mean (the integral of the
//    profile) and the heat flux of the end to 1e-10; the lateral heat flux is
//    m (mean - theta_inf), and what enters at x = 0, mu B, is what leaves.
// 2. m = 1e-12 is m = 0 to 1e-9, among it the steady profile and the forecast
//    with and without a cosh; a large m, whose cosh would overflow, has
//    theta(1) = theta_inf + k (theta_obs - theta_inf)/(mu + k).
// 3. The thermal switch with m = 0.05: its states of rest are the roots of
//      k(c) = k(gap, p) of G = a int theta dx for the profile of k(c)
//    found by bisection between the bounds in the code, open and closed
//    separately; forecast to 1e-10, the second unstable; runs from 0.02 below
//    and above its c reach the first and the third: theta(1) to 1e-6.

#include <thermocontact/base/dealii_versions.h>
#include <thermocontact/forecast/forecast.h>

#include <array>

#include "../tests.h"

#include "../lateral_runs.h"

using namespace ThermoContact;

namespace
{
  /** theta - theta_inf = fixed cosh(mu x) - B sinh(mu x). */
  struct Fin
  {
    double mu, fixed, B, ambient;

    Fin(const double m,
        const double theta_A,
        const double k,
        const double theta_obs,
        const double theta_inf)
      : mu(std::sqrt(m))
      , fixed(theta_A - theta_inf)
      , B((fixed * (mu * std::sinh(mu) + k * std::cosh(mu)) -
           k * (theta_obs - theta_inf)) /
          (mu * std::cosh(mu) + k * std::sinh(mu)))
      , ambient(theta_inf)
    {}

    double
    value(const double x) const
    {
      return ambient + fixed * std::cosh(mu * x) - B * std::sinh(mu * x);
    }

    double
    integral() const
    {
      return ambient + (fixed * std::sinh(mu) - B * (std::cosh(mu) - 1.)) / mu;
    }
  };


  void
  check_rest()
  {
    const double     m = 9., k = 2., theta_inf = 3., theta_obs = -1.;
    const Fin        fin(m, 10., k, theta_obs, theta_inf);
    const Parameters parameters =
      read_parameters("verification/lateral-loss.prm");
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    simulation.run({[](const Simulation<1> &) {}});

    const Discretization<1> &space = simulation.discretization();
    const auto points = support_points(space.mapping(), space.dof_handler());
    double     nodes  = 0.;
    for (const auto &[dof, point] : points)
      raise(nodes,
            std::abs(simulation.state().temperature[dof] -
                     fin.value(point[0])));

    const StepRecord &end    = simulation.record();
    double            others = 0.;
    raise(others,
          std::abs(steady_state(simulation.scene()).states[0].temperature_end -
                   fin.value(1.)));
    raise(others, std::abs(end.temperature_mean - fin.integral()));
    raise(others,
          std::abs(end.heat_flux_end - k * (fin.value(1.) - theta_obs)));
    deallog << "rest: " << points.size() << " nodes " << within(nodes, 1e-10)
            << ", forecast, mean and flux " << within(others, 1e-10)
            << ", lateral flux is m (mean - theta_inf) "
            << within(std::abs(end.lateral_heat_flux -
                               m * (end.temperature_mean - theta_inf)),
                      1e-11)
            << ", what enters leaves "
            << within(std::abs(fin.mu * fin.B - end.heat_flux_end -
                               end.lateral_heat_flux),
                      1e-9)
            << std::endl;
  }


  void
  check_limits()
  {
    const auto with = [](const std::string &m) {
      return read_parameters("",
                             thrown +
                               Overrides{"Boundary/sides/Heat exchange=" + m,
                                         "Boundary/sides/Surroundings=" +
                                           std::string(m == "0" ? "0" : "-2")});
    };
    const auto rest = [&](const std::string &m) {
      return steady_state(Scene(with(m))).states[0];
    };
    const SteadyState none = rest("0"), little = rest("1e-12");
    const double      near =
      std::max(std::abs(none.temperature_end - little.temperature_end),
               std::abs(none.displacement_end - little.displacement_end));
    // k = 1, theta_obs = 1/2
    const double mu = 1e6, far = -2. + 2.5 / (mu + 1.);
    deallog << "limits: little loss is none "
            << within(difference(run<1>(with("0")), run<1>(with("1e-12"))),
                      1e-9)
            << ", forecast " << within(near, 1e-11) << ", of a large one "
            << within(std::abs(rest("1e12").temperature_end - far), 1e-12)
            << std::endl;
  }



  void
  check_switch()
  {
    const std::string file = "examples/thermal-switch.prm";
    const Overrides   loss{"Boundary/sides/Heat exchange=0.05",
                         "Boundary/sides/Surroundings=1"};
    const auto        fin = [](const double c) {
      return Fin(0.05, 0., c / (1. - c), 10., 1.);
    };
    const auto excess = [&](const double c) { // G - g
      return 0.017 * fin(c).integral() - 0.03;
    };
    const auto open = [&](const double c) {
      return c / (1. - c) - 0.005 / (0.01 - excess(c));
    };
    const auto closed = [&](const double c) {
      return c / (1. - c) - 0.5 - 200. * excess(c) / 1.01;
    };
    // contact begins between the first two
    const double                touch = bisect(excess, 0.1, 0.9);
    const std::array<double, 3> drops{{bisect(open, 0.01, 0.8 * touch),
                                       bisect(closed, touch, 0.6),
                                       bisect(closed, 0.6, 0.999)}};

    const Scene scene(read_parameters(file, loss));
    const auto  states = steady_state(scene).states;
    deallog << "switch: states " << states.size() << ", stable";
    double error = states.size() == 3 ? 0. : 1.;
    for (unsigned int i = 0; i < states.size() && i < 3; ++i)
      {
        deallog << ' ' << states[i].is_stable;
        raise(error,
              std::abs(states[i].temperature_end - fin(drops[i]).value(1.)));
      }
    deallog << ", theta(1) " << within(error, 1e-10);
    for (const int side : {-1, 1})
      {
        const Fin   start   = fin(drops[1] + 0.02 * side);
        std::string profile = "1-cosh(0.223606797749979*x)-(" +
                              std::to_string(start.B) +
                              ")*sinh(0.223606797749979*x)";
        const StepRecord end =
          run<1>(
            read_parameters(
              file, loss + Overrides{"Initial values/Temperature=" + profile}))
            .back();
        deallog << ", reached from " << (side < 0 ? "below" : "above") << ' '
                << (std::abs(end.temperature_end -
                             fin(drops[side < 0 ? 0 : 2]).value(1.)) < 1e-6);
      }
    deallog << std::endl;
  }
} // namespace



void
main_lateral_exchange()
{
  initlog();
  check_rest();
  check_limits();
  check_switch();
}
