// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The iterative solver with the iteration and the start of the paper and with
// the scheme that conserves energy: runs of a strip and a block with free sides
// that hit a tilted obstacle, with heat, a = 0.5, beside the same runs with the
// direct solver. Both solve the same equations, so that they differ by the
// residuals of linear systems.
//
// 1. Backward Euler with the start of the paper, and its iteration to 1e-12:
//    systems are solved to 1e-13, in less than 20 iterations each, so that all
//    columns agree to 1e-9 of their largest value, and so do the numbers of
//    iterations. Without the iteration stages are solved to 1e-11.
// 2. The scheme that conserves energy, elastic and rigid, stages to 1e-12: as
//    before. A response for each contact node and step size: 0.02 and, at the
//    end, 0.01. Contact nodes have no viscous stress, (C6.1). With stages to
//    1e-5 residuals bring in more than 1e-8 of the energy at first, and
//    E + D - E_0 is that to a tenth: pressures are as good as responses.
//
// 3. A block at rest without inertia that a rigid curved obstacle touches at
//    t = 0 and moves into, g = s ((y - 1/4)^2 - t): nothing but the obstacle
//    moves it, so that with s the force is s times the one with s = 1, of
//    either solver, to 100 of its tolerances 1e-9.
//
// Measured differences: 1. with the iteration 1e-13, without it 2e-12; 2.
// 3e-11, and 0.03 of the energy of the residuals.

#include <thermocontact/simulation/simulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "../tests.h"

#include "../overrides.h"

using namespace ThermoContact;

namespace
{
  const Overrides body_at_obstacle{"Mesh/Degree=2",
                                   "Mesh/Cells=4",
                                   "Mesh/Width=0.5",
                                   "Mesh/Cells across=2",
                                   "Model/Poisson ratio=0.3",
                                   "Model/Coupling=0.5",
                                   "Model/Viscosity=0.01",
                                   "Boundary/sides/Support=free",
                                   "Boundary/left/Temperature=1",
                                   "Boundary/right/Heat exchange=3",
                                   "Initial values/Temperature=1+sin(3*pi*x)",
                                   "Initial values/Velocity=x",
                                   "Contact/Gap=0.02+0.1*y",
                                   "Time/Step size=0.02",
                                   "Time/End time=0.61"};

  struct Result
  {
    std::vector<std::array<double, 18>> rows;

    unsigned int n_iterations = 0;  ///< of stages
    unsigned int n_touching   = 0;  ///< steps in contact
    double       residuals    = 0.; ///< their energy, relative
    double       defect       = 0.; ///< of the balance, relative

    // for each contact node; of Krylov methods, for each of two systems
    double n_responses = 0., n_krylov = 0.;
  };



  template <int dim>
  Result
  run(const Overrides &overrides)
  {
    Simulation<dim> simulation(
      read_parameters("",
                      body_at_obstacle +
                        Overrides{"Dimension=" + std::to_string(dim)} +
                        overrides),
      MPI_COMM_SELF);
    Result result;
    double first = 0.;
    simulation.run({[&](const Simulation<dim> &s) {
      const StepRecord &r = s.record();
      if (r.step == 0)
        first = r.energy;
      result.rows.push_back(all_columns(r));
      result.n_iterations += r.iterations;
      result.n_touching += r.contact_force != 0.;
      raise(result.residuals, std::abs(r.algebraic) / first);
      raise(result.defect,
            std::abs(r.energy + r.dissipation - r.work - first - r.algebraic) /
              first);
    }});
    const SolverCounters counters = simulation.counters();
    result.n_responses =
      double(counters.responses) / simulation.body().contact_end().n_nodes();
    result.n_krylov = 0.5 * counters.linear_iterations / result.n_iterations;
    return result;
  }



  /** The largest of all columns, in parts of the largest value of each. */
  double
  difference(const Result &one, const Result &other)
  {
    if (one.rows.size() != other.rows.size())
      return std::numeric_limits<double>::infinity();
    double worst = 0.;
    for (unsigned int column = 0; column < one.rows[0].size(); ++column)
      {
        double largest = 1e-3, found = 0.;
        for (unsigned int i = 0; i < one.rows.size(); ++i)
          {
            raise(largest, std::abs(one.rows[i][column]));
            raise(found, std::abs(one.rows[i][column] - other.rows[i][column]));
          }
        raise(worst, found / largest);
      }
    return worst;
  }



  template <int dim>
  void
  compare_euler()
  {
    const Overrides euler{"Time/Scheme=backward euler",
                          "Time/Start=paper",
                          "Contact/Compliance=0.3"};
    const Overrides iteration{"Solver/Step solver=fixed point",
                              "Solver/Fixed point tolerance=1e-12"};
    const Overrides iterative{"Solver/Linear solver=iterative"};
    const Result    direct =
      run<dim>(euler + iteration + Overrides{"Solver/Linear solver=direct"});
    const Result by_iteration = run<dim>(euler + iteration + iterative);
    const Result at_once =
      run<dim>(euler + iterative + Overrides{"Solver/Linear tolerance=1e-11"});
    deallog << dim << "-D, backward Euler, "
            << (direct.n_touching > 5 ? "in contact" : "free")
            << ": iteration of the paper "
            << within(difference(direct, by_iteration), 1e-9)
            << ", iterations more "
            << int(by_iteration.n_iterations) - int(direct.n_iterations)
            << ", of a system "
            << (by_iteration.n_krylov < 20. ? "less" : "more") << " than 20"
            << "; without it " << within(difference(direct, at_once), 1e-9)
            << std::endl;
  }



  template <int dim>
  void
  compare_conserving(const std::string &obstacle)
  {
    const Overrides conserving{"Time/Scheme=energy conserving", obstacle};
    const auto      iterative = [&](const std::string &tolerance) {
      return run<dim>(conserving +
                      Overrides{"Solver/Linear solver=iterative",
                                "Solver/Linear tolerance=" + tolerance});
    };
    const Result direct =
      run<dim>(conserving + Overrides{"Solver/Linear solver=direct"});
    const Result sharp = iterative("1e-12"), loose = iterative("1e-5");
    deallog << dim << "-D, conserving, " << obstacle << ", "
            << (direct.n_touching > 5 ? "in contact" : "free") << ": "
            << within(difference(direct, sharp), 1e-9) << ", "
            << sharp.n_responses << " responses for each node; of residuals "
            << (loose.residuals > 1e-8 ? "more" : "less")
            << " than 1e-8, defect beside them "
            << (loose.defect < 0.1 * loose.residuals ? "less" : "more")
            << " than a tenth" << std::endl;
  }



  template <int dim>
  void
  compare_at_rest()
  {
    const auto force = [](const std::string &solver, const std::string &s) {
      Simulation<dim> simulation(
        read_parameters("",
                        {"Dimension=" + std::to_string(dim),
                         "Model/Fields=displacement",
                         "Model/Inertia=0",
                         "Model/Viscosity=0",
                         "Model/Poisson ratio=0.3",
                         "Initial values/Displacement=0",
                         "Boundary/sides/Support=free",
                         "Mesh/Degree=2",
                         "Mesh/Cells=4",
                         "Mesh/Width=0.5",
                         "Mesh/Cells across=2",
                         "Time/Scheme=sdirk2",
                         "Time/Step size=0.02",
                         "Time/End time=0.1",
                         "Contact/Condition=rigid",
                         "Contact/Gap=" + s + "*((y-0.25)^2-t)",
                         "Solver/Linear solver=" + solver}),
        MPI_COMM_SELF);
      simulation.run({});
      return simulation.record().contact_force;
    };
    const double known = force("direct", "1");
    deallog << dim << "-D, at rest: " << (known > 0. ? "in contact" : "free")
            << ", iterative "
            << within(std::abs(force("iterative", "1") / known - 1.), 1e-7)
            << ", 1e-10 times "
            << within(std::abs(force("iterative", "1e-10") / known * 1e10 - 1.),
                      1e-7)
            << std::endl;
  }
} // namespace



void
main_iterative_schemes()
{
  initlog();
  compare_at_rest<2>();
  compare_at_rest<3>();
  compare_euler<2>();
  compare_euler<3>();
  for (const std::string obstacle :
       {"Contact/Compliance=0.01", "Contact/Condition=rigid"})
    {
      compare_conserving<2>(obstacle);
      compare_conserving<3>(obstacle);
    }
}
