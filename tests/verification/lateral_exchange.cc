// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Heat that is lost along the rod, doc/model.md section 20.
//
// 1. prm/verification/lateral-loss.prm, derived there: at the end of the run
//    all nodes, the forecast of theta(1), the mean (the integral of the
//    profile) and the heat flux of the end to 1e-10; the lateral heat flux is
//    m (mean - theta_inf), and what enters at x = 0, mu B, is what leaves.
// 2. Decay. With theta_A = theta_inf = 0 and k = 0 the slowest mode decays like
//    exp(-lambda t), lambda = pi^2/4 + m in a rod. In a body it has the factor
//    cos(kappa y) about the axis in each direction, or J_0(kappa r), and
//      strip:  lambda = pi^2/4 + kappa^2 ,   kappa tan(kappa W/2) = m W/2 ,
//      block:  lambda = pi^2/4 + 2 kappa^2 , kappa tan(kappa W/2) = m W/4 ,
//      round:  lambda = pi^2/4 + kappa^2 ,   kappa J_1(kappa R)/J_0(kappa R) =
//              m R/2 ,
//    by -d theta/dn = m A/P theta on the lateral faces; kappa by bisection. A
//    step dt of backward Euler divides a mode by 1 + lambda dt, all others by
//    more: twelve steps of dt = 1 leave the slowest. lambda to 1e-10. The
//    lateral part of the dissipation of a rod is m/lambda of the whole.
// 3. Bodies on rollers, strip, block and round, whose temperature varies by
//    m W^2/8 across, are the rod but for O(W^2): all columns of a run with
//    contact, extrapolated from the widths 0.002 and 0.001, to 1e-9 of their
//    largest values, or of 0.1 (1e-10 measured).
// 4. The audit (M.22), each line by its own formula, backward Euler, 1-D and
//    2-D: to 1e-11 of the sum of its terms; no work, and the energy never
//    increases, with surroundings of their own temperature. With a heat
//    exchange that varies with the contact there is work, and the audit closes.
//    The energy conserving scheme loses nothing but the dissipation: 1e-11.
// 5. m = 1e-12 is m = 0 to 1e-9, among it the steady profile and the forecast
//    with and without a cosh; a large m, whose cosh would overflow, has
//    theta(1) = theta_inf + k (theta_obs - theta_inf)/(mu + k).
// 6. The thermal switch with m = 0.05: its states of rest are the roots of
//      k(c) = k(gap, p) of G = a int theta dx for the profile of k(c)
//    found by bisection between the bounds in the code, open and closed
//    separately; forecast to 1e-10, the second unstable; runs from 0.02 below
//    and above its c reach the first and the third: theta(1) to 1e-6.
// 7. The paper's iteration gives the steps of the monolithic solver: 1e-8.

#include <thermocontact/forecast/steady_state.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../tests.h"

#include "../overrides.h"

using namespace ThermoContact;

namespace
{
  template <int dim>
  std::vector<StepRecord>
  run(const Parameters &parameters)
  {
    std::vector<StepRecord> rows;
    Simulation<dim>         simulation(parameters, MPI_COMM_SELF);
    simulation.run(
      {[&rows](const Simulation<dim> &s) { rows.push_back(s.record()); }});
    return rows;
  }



  /** The zero of a function with a change of sign in [a, b]. */
  double
  bisect(const std::function<double(double)> &f, double a, double b)
  {
    const bool is_positive = f(a) > 0.;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const double middle                       = 0.5 * (a + b);
        ((f(middle) > 0.) == is_positive ? a : b) = middle;
      }
    return 0.5 * (a + b);
  }



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

    std::map<types::global_dof_index, Point<1>> points;
    DoFTools::map_dofs_to_support_points(
      simulation.discretization().mapping(),
      simulation.discretization().dof_handler(),
      points);
    double nodes = 0.;
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
    deallog << "rest: " << points.size() << " nodes to 1e-10 "
            << (nodes < 1e-10) << ", forecast, mean and flux to 1e-10 "
            << (others < 1e-10) << ", lateral flux is m (mean - theta_inf) "
            << (std::abs(end.lateral_heat_flux -
                         m * (end.temperature_mean - theta_inf)) < 1e-11)
            << ", what enters leaves to 1e-9 "
            << (std::abs(fin.mu * fin.B - end.heat_flux_end -
                         end.lateral_heat_flux) < 1e-9)
            << std::endl;
  }



  template <int dim>
  void
  check_decay(const std::string &name,
              const double       m,
              const double       shift,
              const Overrides   &body)
  {
    const auto rows =
      run<dim>(read_parameters("",
                               Overrides{"Model/Fields=temperature",
                                         "Boundary/Fixed end temperature=0",
                                         "Boundary/Heat exchange=0",
                                         "Boundary/Lateral heat exchange=" +
                                           std::to_string(m),
                                         "Initial values/Temperature=sin(pi*x/"
                                         "2)",
                                         "Mesh/Cells=2",
                                         "Mesh/Degree=8",
                                         "Time/Scheme=backward euler",
                                         "Time/Step size=1",
                                         "Time/End time=12"} +
                                 body));
    const double before = rows[rows.size() - 2].temperature_mean;
    const double rate   = before / rows.back().temperature_mean - 1.;
    const double lambda = 0.25 * numbers::PI * numbers::PI + shift;
    deallog << "decay, " << name << ": rate to 1e-10 "
            << (std::abs(rate - lambda) < 1e-10 * lambda);
    if (dim == 1)
      deallog << ", lateral part of the dissipation "
              << rows.back().lateral_dissipation / rows.back().dissipation *
                   lambda / m;
    deallog << std::endl;
  }



  void
  check_decays()
  {
    const double m = 3., W = 0.4;
    const auto   faces = [&](const double part) {
      const double kappa = bisect(
        [&](const double x) {
          return x * std::tan(0.5 * x * W) - part * m * W;
        },
        1e-3,
        3.);
      return kappa * kappa;
    };
    const double radial = bisect(
      [&](const double x) {
        return x * std::cyl_bessel_j(1., x * W) -
               0.5 * m * W * std::cyl_bessel_j(0., x * W);
      },
      1e-3,
      3.);
    const Overrides strip{"Dimension=2",
                          "Mesh/Width=0.4",
                          "Mesh/Cells across=1"};
    check_decay<1>("rod", m, m, {});
    check_decay<1>("rod", 50., 50., {});
    check_decay<2>("strip", m, faces(0.5), strip);
    check_decay<2>("round",
                   m,
                   radial * radial,
                   strip + Overrides{"Mesh/Geometry=axisymmetric"});
    check_decay<3>("block",
                   m,
                   2. * faces(0.25),
                   strip +
                     Overrides{"Dimension=3", "Mesh/Cells=4", "Mesh/Degree=5"});
  }



  constexpr unsigned int n_columns = 20;

  /** Those of all_columns(), and the two of the lateral exchange. */
  double
  column(const StepRecord &r, const unsigned int i)
  {
    const auto all = all_columns(r);
    return i < all.size()  ? all[i] :
           i == all.size() ? r.lateral_heat_flux :
                             r.lateral_dissipation;
  }



  using Table = std::vector<std::vector<double>>;

  Table
  table(const std::vector<StepRecord> &rows)
  {
    Table result(n_columns);
    for (const StepRecord &r : rows)
      for (unsigned int i = 0; i < n_columns; ++i)
        result[i].push_back(column(r, i));
    return result;
  }



  /** Largest difference of a column relative to its largest value, or 0.1. */
  double
  difference(const Table &a, const Table &b)
  {
    double result = 0.;
    for (unsigned int i = 0; i < n_columns; ++i)
      {
        double change = a[i].size() == b[i].size() ? 0. : 1., scale = 0.1;
        for (unsigned int j = 0; j < std::min(a[i].size(), b[i].size()); ++j)
          {
            raise(change, std::abs(a[i][j] - b[i][j]));
            raise(scale, std::abs(a[i][j]));
          }
        raise(result, change / scale);
      }
    return result;
  }



  double
  difference(const std::vector<StepRecord> &a, const std::vector<StepRecord> &b)
  {
    return difference(table(a), table(b));
  }



  /** A rod that is thrown at an obstacle in cold surroundings. */
  const Overrides thrown{"Model/Coupling=0.3",
                         "Boundary/Fixed end temperature=1",
                         "Boundary/Obstacle temperature=0.5",
                         "Boundary/Lateral heat exchange=3",
                         "Boundary/Ambient temperature=-2",
                         "Contact/Gap=0.05",
                         "Contact/Compliance=0.1",
                         "Initial values/Temperature=theta_A*(1-x^2)",
                         "Initial values/Velocity=x",
                         "Mesh/Cells=4",
                         "Mesh/Degree=2",
                         "Time/Scheme=sdirk2",
                         "Time/Step size=0.02",
                         "Time/End time=1"};



  /** The columns of a body without a width. */
  template <int dim>
  Table
  thin(const Overrides &overrides)
  {
    const auto with = [&](const std::string &width) {
      return table(
        run<dim>(read_parameters("",
                                 thrown +
                                   Overrides{"Dimension=" + std::to_string(dim),
                                             "Mesh/Width=" + width,
                                             "Mesh/Cells across=1",
                                             "Model/Poisson ratio=0.3"} +
                                   overrides)));
    };
    Table       result = with("0.001");
    const Table wide   = with("0.002");
    for (unsigned int i = 0; i < n_columns; ++i)
      for (unsigned int j = 0; j < result[i].size(); ++j)
        result[i][j] += (result[i][j] - wide[i][j]) / 3.;
    return result;
  }



  void
  check_thin()
  {
    const auto rows       = run<1>(read_parameters("", thrown));
    const auto rod        = table(rows);
    const auto in_contact = [](const StepRecord &r) { return r.in_contact; };
    deallog << "thin: contact "
            << std::any_of(rows.begin(), rows.end(), in_contact)
            << ", strip, round rod, block equal the rod to 1e-9: "
            << (difference(rod, thin<2>({})) < 1e-9)
            << (difference(rod, thin<2>({"Mesh/Geometry=axisymmetric"})) < 1e-9)
            << (difference(rod, thin<3>({})) < 1e-9) << std::endl;
  }



  template <int dim>
  void
  check_audit(const std::string &name, const Overrides &overrides)
  {
    const auto rows   = run<dim>(read_parameters("", thrown + overrides));
    double     defect = 0., increase = 0., scale = 0., work = 0., lost = 0.;
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        const StepRecord &r = rows[i];
        raise(scale,
              rows[0].energy_terms.magnitude() + std::abs(r.work) +
                r.dissipation + std::abs(r.numerical_dissipation));
        raise(defect,
              std::abs(rows[0].energy + r.work - r.energy - r.dissipation -
                       r.numerical_dissipation));
        raise(work, std::abs(r.work));
        raise(lost, std::abs(r.numerical_dissipation));
        if (i > 0)
          raise(increase,
                r.energy - r.work - rows[i - 1].energy + rows[i - 1].work);
      }
    const double part =
      rows.back().lateral_dissipation / rows.back().dissipation;
    deallog << "audit, " << name << ": closes to 1e-11 "
            << (defect < 1e-11 * scale) << ", work " << (work > 1e-3 * scale)
            << ", lateral part of the dissipation is one " << (part > 0.01)
            << (part < 0.99)
            << ", energy less work never "
               "increases "
            << (increase <= 1e-13 * scale) << ", scheme takes "
            << (lost > 1e-11 * scale) << std::endl;
  }



  void
  check_audits()
  {
    const Overrides euler{"Time/Scheme=backward euler",
                          "Time/Start=consistent"};
    const Overrides strip{"Dimension=2", "Mesh/Cells across=2"};
    check_audit<1>("rod", euler);
    check_audit<2>("strip", euler + strip);
    check_audit<2>("round rod",
                   euler + strip + Overrides{"Mesh/Geometry=axisymmetric"});
    check_audit<2>("free strip",
                   euler + strip + Overrides{"Boundary/Lateral support=free"});
    check_audit<1>("energy conserving",
                   {"Time/Scheme=energy conserving",
                    "Contact/Massless nodes=on"});
    const Overrides varying{
      "Boundary/Heat exchange=0.05/(0.05+gap)+20*pressure"};
    check_audit<1>("varying exchange", euler + varying);
    check_audit<2>("varying exchange, strip", euler + strip + varying);
  }



  void
  check_limits()
  {
    const auto with = [](const std::string &m) {
      return read_parameters("",
                             thrown +
                               Overrides{"Boundary/Lateral heat exchange=" + m,
                                         "Boundary/Ambient temperature=" +
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
    deallog << "limits: little loss is none to 1e-9 "
            << (difference(run<1>(with("0")), run<1>(with("1e-12"))) < 1e-9)
            << ", forecast to 1e-11 " << (near < 1e-11)
            << ", of a large one to 1e-12 "
            << (std::abs(rest("1e12").temperature_end - far) < 1e-12)
            << std::endl;
  }



  void
  check_switch()
  {
    const std::string file = "examples/thermal-switch.prm";
    const Overrides   loss{"Boundary/Lateral heat exchange=0.05",
                         "Boundary/Ambient temperature=1"};
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
    deallog << ", theta(1) to 1e-10 " << (error < 1e-10);
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



  void
  check_iteration()
  {
    const Overrides steps{"Time/Scheme=backward euler",
                          "Time/Step size=0.005",
                          "Contact/Compliance=2",
                          "Contact/Massless nodes=off"};
    const auto      with = [&](const std::string &solver) {
      return run<1>(read_parameters(
        "", thrown + steps + Overrides{"Solver/Step solver=" + solver}));
    };
    deallog << "iteration of the paper to 1e-8 "
            << (difference(with("monolithic"), with("fixed point")) < 1e-8)
            << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  check_rest();
  check_decays();
  check_thin();
  check_audits();
  check_limits();
  check_switch();
  check_iteration();
}
