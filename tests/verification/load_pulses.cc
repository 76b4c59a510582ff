// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Loads that come as pulses and jumps, error-controlled: each is seen, and the
// error stays within 30 tolerances of the largest value.
//
// 1. 48 scenes: a pulse phi(t) of width w T, w = 1e-4, 1e-3, 1e-2, 0.1, 0.3, 1,
//    around t = 0.37 T, T = 5, rectangular or exp(-((t - 0.37 T)/(w T/2))^2),
//    without obstacle, exchange and coupling, from rest. A load that varies
//    along the rod as sin(k_n x), k_n = (n + 1/2) pi, moves its mode alone:
//    heat source sin(k_0 x) phi:  theta(1) = a,  a' + k_0^2 a = phi,
//    body force sin(k_0 x) phi:   u(1) = c,  c'' + zeta k_0^2 c' + k_0^2 c =
//                                 phi, zeta = 0.2,
//    heat flux phi:               mean theta = sum_n a_n/k_n with
//                                 a_n' + k_n^2 a_n = 2 (-1)^n phi; of a smooth
//                                 pulse the modes from the 60th on follow it at
//                                 once, and add up to phi times what the others
//                                 leave of 1/2,
//    traction phi, b = 0:         u(1) = c,  zeta c' + c = phi.
//    Each is the integral of phi times the response r(t - s), by elementary
//    functions for the rectangle and by Gauss's rule on 200 intervals of the
//    pulse else. Errors at all rows.
// 2. Experiment 1 with if(t>50,if(t<50.1,1000,0),0) for its heat source, to T =
//    60: the contact impulse is 3.21485, that of steps of at most 0.01 which
//    end at 50 and 50.1 (Time/Break points), to 1e-4 of it; without the pulse
//    it is 2.83537.
// 3. A body in equilibrium, b = zeta = 0, in front of an obstacle with
//    epsilon = 0.5 and g = 0.2 under the traction 0.1 to t = 1, 0.5 to t = 2,
//    -0.3 then: u(1) = 0.1, 0.2 + 0.5 (0.3/1.5) = 0.3, -0.3, at all rows: that
//    of the time of a jump has the new load. Force 0, 0.2, 0. Contact begins at
//    1 and ends at 2. With heating, a = 0.3, insulated: a jump is adiabatic, so
//    that theta = -a u_x at the middle, u_x = t + a theta there, before heat
//    has come from the fixed end: after t = 1e-3, from 0 to t = 0.1 at once,
//    u_x = 0.1/(1 + a^2).
// 4. Nodes in equilibrium without viscosity: massless contact nodes on an
//    obstacle, with a traction that jumps in contact, and the scheme energy
//    conserving with Time/Break points: runs are complete and the audit
//    energy(0) + work = energy + dissipation + numerical_dissipation closes to
//    1e-11 of the largest of its terms.
// 5. Expressions without t cost nothing: the steps of a scene with the heat
//    source 3*x are those of maximum step size 1e9, bit for bit, and there is
//    nothing that steps follow.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "../tests.h"

using namespace ThermoContact;
using numbers::PI;

namespace
{
  constexpr double T      = 5.;
  constexpr double centre = 0.37 * T;
  constexpr double zeta   = 0.2;

  struct Pulse
  {
    double width;
    bool   is_smooth;

    std::string
    expression() const
    {
      std::ostringstream text;
      text.precision(17);
      if (is_smooth)
        text << "exp(-((t-" << centre << ")/" << width / 2. << ")^2)";
      else
        text << "if(t>" << centre - width / 2. << ",if(t<"
             << centre + width / 2. << ",1,0),0)";
      return text.str();
    }

    /** phi, if it is smooth. */
    double
    value(const double t) const
    {
      const double x = (t - centre) / (width / 2.);
      return is_smooth ? std::exp(-x * x) : 0.;
    }

    /** Integral of exp(-rate (t - s)) phi(s) over s from 0 to t. */
    std::complex<double>
    response(const double t, const std::complex<double> rate) const
    {
      const double half = width / 2.;
      if (!is_smooth)
        {
          const double begin = std::max(0., centre - half);
          const double end   = std::min(t, centre + half);
          if (t <= begin)
            return 0.;
          return (std::exp(-rate * (t - end)) - std::exp(-rate * (t - begin))) /
                 rate;
        }
      static const QGauss<1> rule(4);
      const double           begin = // exp(-40) is lost in rounding
        std::max({0., centre - 7. * half, t - 40. / rate.real()});
      const double         end = std::min(t, centre + 7. * half);
      std::complex<double> sum = 0.;
      if (end <= begin)
        return sum;
      const unsigned int n    = 200;
      const double       size = (end - begin) / n;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const double s = begin + size * (i + rule.point(q)[0]);
            const double x = (s - centre) / half;
            sum += size * rule.weight(q) * std::exp(-rate * (t - s) - x * x);
          }
      return sum;
    }
  };



  struct Scenario
  {
    std::string                                          name;
    std::vector<std::string>                             overrides;
    std::string                                          entry;
    std::string                                          shape;
    std::function<double(const StepRecord &)>            column;
    std::function<double(const Pulse &, const double t)> solution;
  };



  double
  k(const unsigned int n)
  {
    return (n + 0.5) * PI;
  }



  std::vector<Scenario>
  scenarios()
  {
    const std::vector<std::string> heat{"Model/Fields=temperature",
                                        "Boundary/Fixed end temperature=0",
                                        "Boundary/Heat exchange=0",
                                        "Initial values/Temperature=0"};
    std::vector<std::string>       motion{"Model/Fields=displacement",
                                    "Contact/Condition=none",
                                    "Initial values/Velocity=0"};
    std::vector<std::string>       creep{"Model/Fields=displacement",
                                   "Contact/Condition=none",
                                   "Model/Inertia=0"};
    const auto mode = [](const Pulse &pulse, const double t) {
      return pulse.response(t, k(0) * k(0)).real();
    };
    const auto flux = [](const Pulse &pulse, const double t) {
      double             sum     = 0.;
      double             tail    = pulse.is_smooth ? 0.5 : 0.;
      const unsigned int n_modes = pulse.is_smooth ? 60 : 1000;
      for (unsigned int n = 0; n < n_modes; ++n)
        {
          const double part = 2. * (n % 2 == 0 ? 1. : -1.) / k(n);
          sum += part * pulse.response(t, k(n) * k(n)).real();
          tail -= pulse.is_smooth ? part / (k(n) * k(n)) : 0.;
        }
      return sum + tail * pulse.value(t);
    };
    const auto oscillator = [](const Pulse &pulse, const double t) {
      const double               decay = zeta * k(0) * k(0) / 2.;
      const double               omega = std::sqrt(k(0) * k(0) - decay * decay);
      const std::complex<double> rate(decay, -omega);
      return pulse.response(t, rate).imag() / omega;
    };
    const auto creeping = [](const Pulse &pulse, const double t) {
      return pulse.response(t, 1. / zeta).real() / zeta;
    };
    const auto end = [](const StepRecord &r) { return r.displacement_end; };
    return {
      {"heat source",
       heat,
       "Heat source",
       "sin(pi*x/2)*",
       [](const StepRecord &r) { return r.temperature_end; },
       mode},
      {"heat flux",
       heat,
       "End heat flux",
       "",
       [](const StepRecord &r) { return r.temperature_mean; },
       flux},
      {"body force", motion, "Body force", "sin(pi*x/2)*", end, oscillator},
      {"traction", creep, "End traction", "", end, creeping}};
  }



  void
  check_pulses()
  {
    constexpr double tolerance = 1e-5;
    for (const Scenario &scenario : scenarios())
      for (const bool is_smooth : {false, true})
        {
          unsigned int n_good = 0;
          for (const double width : {1e-4, 1e-3, 1e-2, 0.1, 0.3, 1.})
            {
              const Pulse              pulse{width * T, is_smooth};
              std::vector<std::string> overrides(scenario.overrides);
              overrides.push_back("Time/End time=5");
              overrides.push_back("Time/Tolerance=1e-5");
              overrides.push_back("Sources/" + scenario.entry + "=" +
                                  scenario.shape + pulse.expression());
              double        error = 0., largest = 0.;
              Simulation<1> simulation(read_parameters("", overrides),
                                       MPI_COMM_SELF);
              simulation.run({[&](const Simulation<1> &s) {
                const StepRecord &r = s.record();
                const double      exact =
                  r.time == 0. ? 0. : scenario.solution(pulse, r.time);
                raise(error, std::abs(scenario.column(r) - exact));
                raise(largest, std::abs(exact));
              }});
              n_good += error <= 30. * tolerance * largest;
              if (error > 30. * tolerance * largest)
                deallog << "width " << width << ": error "
                        << error / largest / tolerance << " tolerances"
                        << std::endl;
            }
          deallog << scenario.name << (is_smooth ? ", smooth" : ", rectangular")
                  << ": within 30 tolerances " << n_good << " of 6"
                  << std::endl;
        }
  }



  double
  impulse(const std::vector<std::string> &overrides)
  {
    std::vector<std::string> all{
      "Sources/Heat source=if(t>50,if(t<50.1,1000,0),0)", "Time/End time=60"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    Simulation<1> simulation(read_parameters("", all), MPI_COMM_SELF);
    simulation.run();
    return simulation.record().contact_impulse;
  }



  void
  check_impulse()
  {
    const double automatic = impulse({});
    const double small_steps =
      impulse({"Time/Break points=50;50.1", "Time/Maximum step size=0.01"});
    deallog << "heat pulse of 0.1 at 50: impulse 3.21485 "
            << within(std::abs(automatic - 3.21485), 3e-4) << ' '
            << within(std::abs(small_steps - 3.21485), 3e-4) << std::endl;
  }



  void
  check_equilibrium()
  {
    const Parameters parameters =
      read_parameters("",
                      {"Model/Fields=displacement",
                       "Model/Inertia=0",
                       "Model/Viscosity=0",
                       "Contact/Compliance=0.5",
                       "Contact/Gap=0.2",
                       "Sources/End traction=if(t<1,0.1,if(t<2,0.5,-0.3))",
                       "Time/End time=3"});
    double        error = 0.;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    simulation.run({[&](const Simulation<1> &s) {
      const StepRecord &r     = s.record();
      const double      early = 1. - 1e-9; // the jumps are right before 1, 2
      const int         part = r.time < early ? 0 : r.time < 2. * early ? 1 : 2;
      const double      u[] = {0.1, 0.3, -0.3}, p[] = {0., 0.2, 0.};
      raise(error, std::abs(r.displacement_end - u[part]));
      raise(error, std::abs(r.contact_force - p[part]));
    }});
    const auto &events = simulation.events();
    deallog << "equilibrium: u(1) and force " << within(error, 1e-12)
            << ", contact begins and ends "
            << (events.size() == 2 && std::abs(events[0].time - 1.) < 1e-12 &&
                std::abs(events[1].time - 2.) < 1e-12)
            << std::endl;

    const double     a = 0.3;
    const Parameters heated =
      read_parameters("",
                      {"Model/Inertia=0",
                       "Model/Viscosity=0",
                       "Model/Coupling=0.3",
                       "Boundary/Heat exchange=0",
                       "Boundary/Fixed end temperature=0",
                       "Initial values/Temperature=0",
                       "Contact/Condition=none",
                       "Sources/End traction="
                       "if(t<0.001,0,0.1)",
                       "Mesh/Cells=32",
                       "Time/End time=0.0015"});
    double        strain = 0., jumped = 0.;
    Simulation<1> heating(heated, MPI_COMM_SELF);
    heating.run({[&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      strain              = 0.1 / (1. + a * a);
      if (std::abs(r.time - 0.001) < 1e-12)
        jumped = r.temperature_end;
    }});
    deallog << "adiabatic jump: theta(1) = -a u_x to 1e-8 of it "
            << within(std::abs(jumped + a * strain) / (a * strain), 1e-8)
            << std::endl;
  }



  void
  check_audit(const std::string              &title,
              const std::vector<std::string> &overrides)
  {
    double        worst = 0., largest = 0., first = 0.;
    Simulation<1> simulation(read_parameters("", overrides), MPI_COMM_SELF);
    simulation.run({[&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      if (r.step == 0)
        first = r.energy;
      for (const double term :
           {r.energy, r.work, r.dissipation, r.numerical_dissipation})
        raise(largest, std::abs(term));
      raise(worst,
            std::abs(first + r.work - r.energy - r.dissipation -
                     r.numerical_dissipation));
    }});
    deallog << title << ": audit " << within(worst / largest, 1e-11)
            << ", contact " << (simulation.events().size() > 0) << std::endl;
  }



  void
  check_no_time()
  {
    std::vector<double> times;
    for (const std::string &step : {"infinity", "1e9"})
      {
        Simulation<1> simulation(read_parameters("",
                                                 {"Sources/Heat source=3*x",
                                                  "Time/End time=1",
                                                  "Time/Maximum step size=" +
                                                    step}),
                                 MPI_COMM_SELF);
        deallog << simulation.loads().is_empty() << ' ';
        simulation.run();
        times.push_back(simulation.record().displacement_end);
      }
    deallog << "nothing to follow, the same " << (times[0] == times[1])
            << std::endl;
  }
} // namespace



void
main_load_pulses()
{
  initlog();
  check_pulses();
  check_impulse();
  check_equilibrium();
  const std::vector<std::string> free{"Model/Fields=displacement",
                                      "Model/Viscosity=0",
                                      "Initial values/Velocity=x",
                                      "Sources/End traction=if(t<0.3,0,0.2)",
                                      "Time/End time=2"};
  check_audit("massless nodes", free);
  std::vector<std::string> conserving(free);
  conserving.insert(conserving.end(),
                    {"Time/Scheme=energy conserving",
                     "Time/Step size=0.01",
                     "Time/Break points=0.3"});
  check_audit("energy conserving", conserving);
  check_no_time();
}
