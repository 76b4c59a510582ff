// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Scenes with one field, and with two of which one does not act on the other;
// the solutions are derived in the parameter files.
//
// 1. heat-mode.prm, heat-series.prm: theta(1) and the mean of theta to 1e-8,
//    from the start and from t = 0.1 on.
// 2. damped-modes.prm: u(1) and u_t(1) to 1e-8; modes 1, 2, 3 are
//    underdamped, critical, overdamped; each alone and their sum.
// 3. one-way-heating.prm, and experiment 1 with a = 0: the largest matrix has
//    half the unknowns of the full model's, and all nodal values of 1000 steps
//    through contact agree to 1e-11 of the largest value of the field with
//    those that the whole stage matrix of doc/discretisation.md (D2.2) gives,
//    solved here by one direct solver, and contact by (C2.2) with its
//    receptance. Nothing acts on the temperature, which is that of heat alone,
//    and for a = 0 nothing acts on the displacement.

#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/system_matrix.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "../tests.h"

using namespace ThermoContact;
using numbers::PI;

namespace
{
  using FieldVector  = ThermoContact::Vector;
  using SystemVector = ThermoContact::SystemVector;

  /** Zero number n = 1, 2, ... of mu cos(mu) + k sin(mu), by bisection. */
  double
  heat_eigenvalue(const unsigned int n, const double k)
  {
    // the function changes its sign from (n - 1/2) pi to n pi
    double low = (n - 0.5) * PI, high = n * PI;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + high);
        const double value =
          (middle * std::cos(middle) + k * std::sin(middle)) *
          (n % 2 == 1 ? 1. : -1.);
        (value > 0. ? low : high) = middle;
      }
    return low;
  }



  /** Coefficient of a mode of heat and its rate mu. */
  struct Mode
  {
    double mu, coefficient;
  };



  void
  check_heat(const std::string       &name,
             const std::vector<Mode> &modes,
             const double             first_time)
  {
    const Parameters parameters =
      read_parameters("verification/" + name + ".prm");
    const double theta_A = parameters.boundary.left.temperature;
    const double k       = parameters.boundary.right.heat_exchange;
    const double c       = k / (k + 1.);

    double        error = 0.;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    const auto    observe = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      if (r.time < first_time)
        return;
      double end  = theta_A * (1. - c);
      double mean = theta_A * (1. - 0.5 * c);
      for (const Mode &mode : modes)
        {
          const double q =
            mode.coefficient * std::exp(-mode.mu * mode.mu * r.time);
          end += q * std::sin(mode.mu);
          mean += q * (1. - std::cos(mode.mu)) / mode.mu;
        }
      raise(error, std::abs(r.temperature_end - end));
      raise(error, std::abs(r.temperature_mean - mean));
    };
    simulation.run({observe});
    deallog << name << ": unknowns " << simulation.n_factorized_unknowns()
            << ", theta(1) and mean " << within(error, 1e-8) << std::endl;
  }



  void
  check_heat_alone()
  {
    const double      k = 1., theta_A = 10.; // as in both files
    const double      mu = heat_eigenvalue(1, k);
    std::vector<Mode> series;
    for (unsigned int n = 1; n <= 20; ++n)
      {
        const double mu_n = heat_eigenvalue(n, k), sine = std::sin(mu_n);
        series.push_back(
          {mu_n, 2. * k * theta_A * sine / (mu_n * mu_n + k * sine * sine)});
      }
    check_heat("heat-mode", {{mu, 5.}}, 0.);
    check_heat("heat-series", series, 0.1);
  }



  /** q and q' of a mode of displacement with q(0) = 0.1, q'(0) = 0. */
  std::array<double, 2>
  damped_mode(const double b, const double zeta, const double w, const double t)
  {
    const double d      = 0.5 * zeta * w * w / b;
    const double s      = d * d - w * w / b; // r^2 with the sign of the damping
    const double r      = std::sqrt(std::abs(s));
    double       cosine = 1., sine_by_r = t;
    if (std::abs(s) > 1e-10 * d * d)
      {
        cosine    = s < 0. ? std::cos(r * t) : std::cosh(r * t);
        sine_by_r = (s < 0. ? std::sin(r * t) : std::sinh(r * t)) / r;
      }
    const double decay = 0.1 * std::exp(-d * t);
    return {
      {decay * (cosine + d * sine_by_r), -decay * (w * w / b) * sine_by_r}};
  }



  void
  check_modes(const std::vector<unsigned int> &modes)
  {
    std::string sum = "0";
    for (const unsigned int n : modes)
      sum += "+0.1*sin(" + std::to_string(2 * n - 1) + "*pi*x/2)";
    const Parameters parameters =
      read_parameters("verification/damped-modes.prm",
                      modes.size() == 3 ?
                        std::vector<std::string>{} :
                        std::vector<std::string>{
                          "Initial values/Displacement=" + sum});
    double        error_u = 0., error_v = 0.;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    const auto    observe = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      double            u = 0., v = 0.;
      for (const unsigned int n : modes)
        {
          const auto   q    = damped_mode(parameters.model.inertia,
                                     parameters.model.viscosity,
                                     (n - 0.5) * PI,
                                     r.time);
          const double sign = n % 2 == 1 ? 1. : -1.; // sin(w)
          u += sign * q[0];
          v += sign * q[1];
        }
      raise(error_u, std::abs(r.displacement_end - u));
      raise(error_v, std::abs(r.velocity_end - v));
    };
    simulation.run({observe});
    deallog << "modes of displacement";
    for (const unsigned int n : modes)
      deallog << ' ' << n;
    deallog << ": unknowns " << simulation.n_factorized_unknowns() << ", u(1) "
            << within(error_u, 1e-8) << ", u_t(1) " << within(error_v, 1e-8)
            << std::endl;
  }



  /** Steps of backward Euler with the whole stage matrix. */
  class WholeMatrix
  {
  public:
    explicit WholeMatrix(const Simulation<1> &simulation)
      : discretization(simulation.discretization())
      , equations(simulation.body().equations)
      , tau(simulation.parameters().time.step_size.value())
      , law(simulation.body().law())
      , solver(whole_matrix(equations, stage_coefficients(tau).scaled(tau)))
      , heat(discretization.make_vector(Field::temperature))
      , momentum(discretization.make_vector(Field::displacement))
      , heat_load(heat)
      , momentum_load(momentum)
      , system(discretization.make_system_vector())
      , rates(system)
      , response(system)
    {
      discretization.contact_end().set_load_of_node(Field::displacement,
                                                    0,
                                                    tau,
                                                    momentum);
      discretization.join(heat, momentum, system);
      solver.solve(response, system);
      receptance = tau * end_value(response);
    }

    /** Advances @p state; no loads. */
    void
    step(State &state)
    {
      equations.stage_rhs(state, tau, heat_load, momentum_load, heat, momentum);
      heat *= tau; // the unknowns of the whole matrix are tau theta' and v
      discretization.join(heat, momentum, system);
      solver.solve(rates, system);

      std::vector<double> known(1);
      discretization.contact_end().get_values(Field::displacement,
                                              state.displacement,
                                              known);
      const double free_penetration =
        known[0] - state.gap[0] + tau * end_value(rates);
      const double p =
        std::max(free_penetration, 0.) / (law.tangent(0.) + receptance);
      rates.add(-p, response);

      discretization.split(rates, heat, state.velocity);
      state.temperature += heat;
      state.displacement.add(tau, state.velocity);
      state.contact.pressure = {p};
    }

  private:
    const Discretization<1>             &discretization;
    const ThermoviscoelasticOperator<1> &equations;
    const double                         tau;
    const ContactLaw                    &law;
    DirectSolver                         solver;
    FieldVector                          heat, momentum;
    const FieldVector                    heat_load, momentum_load;
    SystemVector                         system, rates, response;
    double                               receptance;

    double
    end_value(const SystemVector &of_system)
    {
      std::vector<double> value(1);
      discretization.split(of_system, heat, momentum);
      discretization.contact_end().get_values(Field::displacement,
                                              momentum,
                                              value);
      return value[0];
    }
  };



  /** Largest difference relative to the largest value. */
  double
  relative_difference(const FieldVector &a, const FieldVector &b)
  {
    FieldVector difference(a);
    difference -= b;
    return difference.linfty_norm() / b.linfty_norm();
  }



  /**
   * @param equations overrides for the scene whose stage matrix the reference
   *   takes
   */
  void
  check_whole_matrix(const std::string              &title,
                     const std::string              &file,
                     const std::vector<std::string> &overrides,
                     const std::vector<std::string> &equations)
  {
    Simulation<1> simulation(read_parameters(file, overrides), MPI_COMM_SELF);
    const Simulation<1> whole_scene(read_parameters(file, equations),
                                    MPI_COMM_SELF);
    WholeMatrix         whole(whole_scene);
    State               state;
    double              error     = 0.;
    unsigned int        n_contact = 0;
    const auto          observe   = [&](const Simulation<1> &s) {
      const State &other = s.state();
      if (s.record().step <= 1) // the first one is prescribed by the paper
        {
          state = other;
          return;
        }
      whole.step(state);
      raise(error, relative_difference(other.temperature, state.temperature));
      raise(error, relative_difference(other.displacement, state.displacement));
      raise(error, relative_difference(other.velocity, state.velocity));
      raise(error,
            std::abs(other.contact.pressure[0] - state.contact.pressure[0]));
      n_contact += s.record().in_contact;
    };
    simulation.run({observe});
    deallog << title << ": steps " << simulation.record().step
            << ", unknowns factorized " << simulation.n_factorized_unknowns()
            << " of " << simulation.discretization().dof_handler().n_dofs()
            << ", contact occurs and ends "
            << (n_contact > 0 && !simulation.record().in_contact)
            << ", whole matrix " << within(error, 1e-11) << std::endl;
  }



  /** theta(1), its mean, u(1), u_t(1) at every row. */
  std::vector<std::array<double, 4>>
  run(const std::vector<std::string> &overrides)
  {
    std::vector<std::string> all = {"Time/End time=1"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    std::vector<std::array<double, 4>> rows;
    Simulation<1> simulation(read_parameters("paper/experiment-1.prm", all),
                             MPI_COMM_SELF);
    const auto    observe = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      rows.push_back({{r.temperature_end,
                       r.temperature_mean,
                       r.displacement_end,
                       r.velocity_end}});
    };
    simulation.run({observe});
    return rows;
  }



  /** Fields that nothing acts on, against the scene that has them alone. */
  void
  check_independence()
  {
    const auto heat_alone =
      run({"Model/Fields=temperature", "Time/Start=automatic"});
    const auto displacement_alone = run({"Model/Fields=displacement"});
    const auto heating_off        = run({"Model/Thermoelastic heating=false"});
    const auto uncoupled          = run({"Model/Coupling=0"});
    double     error_heat         = 0.;
    double     error_displacement = 0.;
    for (unsigned int i = 0; i < uncoupled.size(); ++i)
      for (const unsigned int q : {0, 1})
        {
          raise(error_heat,
                std::abs(heating_off.at(i)[q] - heat_alone.at(i)[q]));
          raise(error_heat, std::abs(uncoupled.at(i)[q] - heat_alone.at(i)[q]));
          raise(error_displacement,
                std::abs(uncoupled.at(i)[q + 2] -
                         displacement_alone.at(i)[q + 2]));
        }
    deallog << "heating off and a = 0: temperature of heat alone "
            << within(error_heat, 1e-11)
            << "; a = 0: displacement without heat "
            << within(error_displacement, 1e-11) << std::endl;
  }
} // namespace



void
main_single_fields()
{
  initlog();

  check_heat_alone();
  check_modes({1});
  check_modes({2});
  check_modes({3});
  check_modes({1, 2, 3});
  const std::string experiment_1 = "paper/experiment-1.prm";
  check_whole_matrix("full model",
                     experiment_1,
                     {"Time/End time=1"},
                     {"Time/End time=1"});
  check_whole_matrix("heating off", "verification/one-way-heating.prm", {}, {});
  // no coupling, no whole matrix: 1e-30 changes no digit of the result
  check_whole_matrix("a = 0",
                     experiment_1,
                     {"Time/End time=1", "Model/Coupling=0"},
                     {"Model/Coupling=1e-30"});
  check_independence();
}
