// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the iterative solver of stages counts, whatever the machine.
//
// 1. Krylov iterations of a cube, nu = 0.3, to 1e-8: at most 14 for degrees 1
//    and 2, stages of 1e-3 to 1e-1, no inertia, a = 1, and at most 2 more on
//    cells a quarter or half as long. A V-cycle that leaves a tenth of the
//    error takes 8. They are the same on every machine, so that the counts
//    themselves stand here: 5 to 10, 14 for lengths from 1 to 200. As many at
//    most for a round rod, for cells 16 times as wide as long and for lengths
//    from 1 to 200, and for nu = 0.45 and 0.4999 without inertia. Contact nodes
//    without mass in stages of 1e-12, as they end before an event: as many at
//    most; coarse nodes stand for nodes with mass, too. None where heat flows
//    through a body under traction as it does at rest, but for 1e-9: terms
//    cancel.
// 2. A patch of contact that grows over a face in steps of 0.01: at most 4 sets
//    for a stage on average, at most 8, and no system with more than 1.6 times
//    the iterations without obstacle + 2, for each compliance.
// 3. What is made: a strip on rollers meets its obstacle with all its nodes,
//    so that there are two sets, with contact and without: in steps of one size
//    1 for the stage length and 1 for the set, however often contact begins.
// 4. A block in equilibrium that its driven end carries along: no stress, no
// error,
//    steps that grow by 4 from 1/512 of the time: 1 + 4 + 16 + 64 + 256 of them
//    and the rest, 6 in all.

#include <thermocontact/base/number_text.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  template <int dim>
  RecordedRun
  run_iterative(const Overrides &overrides)
  {
    return run<dim>("",
                    overrides + Overrides{"Solver/Linear solver=iterative"});
  }



  /** Krylov iterations of a step of a cube without contact, and whether they
     are more than 14. */
  template <int dim>
  std::string
  iterations(const unsigned int degree,
             const unsigned int cells,
             const double       tau,
             const Overrides   &overrides)
  {
    const std::string  n = std::to_string(cells);
    const Overrides    cube{"Dimension=" + std::to_string(dim),
                         "Mesh/Width=1",
                         "Mesh/Degree=" + std::to_string(degree),
                         "Mesh/Cells=" + n,
                         "Mesh/Cells across=" + n,
                         "Model/Poisson ratio=0.3",
                         "Boundary/sides/Support=free",
                         "Contact/Condition=none",
                         "Time/Scheme=backward euler",
                         "Time/Start=consistent",
                         "Time/Step size=" + significant(tau, few_digits),
                         "Time/End time=" + significant(2. * tau, few_digits),
                         "Solver/Linear tolerance=1e-8"};
    const unsigned int count =
      run_iterative<dim>(cube + overrides).counters.max_linear_iterations;
    return std::to_string(count) + (count <= 14 ? "" : " exceeds 14");
  }



  template <int dim>
  void
  count_iterations(const unsigned int               degree,
                   const std::vector<unsigned int> &n_cells)
  {
    const auto report = [&](const std::string &name,
                            const double       tau,
                            const Overrides   &overrides) {
      deallog << dim << "-D, degree " << degree << ", " << name << ':';
      for (const unsigned int n : n_cells)
        deallog << ' ' << iterations<dim>(degree, n, tau, overrides);
      deallog << std::endl;
    };
    for (const double tau : {1e-3, 1e-1})
      report("tau = " + significant(tau, few_digits), tau, {});
    report("no inertia",
           0.1,
           {"Model/Inertia=0", "Initial values/Temperature=theta_A"});
    report("a = 1", 0.1, {"Model/Coupling=1"});
  }



  void
  count_short_stages()
  {
    const Overrides massless{"Contact/Condition=rigid",
                             "Contact/Massless nodes=on",
                             "Contact/Gap=1",
                             "Initial values/Velocity=x*(1+y)"};
    for (const unsigned int degree : {1, 2})
      deallog << "2-D, degree " << degree << ", massless nodes, tau = 1e-12: "
              << iterations<2>(degree, 16, 1e-12, massless) << std::endl;
    // a cold body between rollers is pulled at these nodes alone: what the
    // others have is rounding
    const Overrides cold{"Boundary/sides/Support=rollers",
                         "Initial values/Velocity=0",
                         "Initial values/Temperature=-8",
                         "Boundary/left/Temperature=-8"};
    deallog << "force at massless nodes alone: "
            << iterations<2>(2, 4, 0.03, massless + cold) << std::endl
            << "as at rest: "
            << iterations<2>(1,
                             4,
                             0.1,
                             {"Model/Coupling=0",
                              "Boundary/sides/Support=rollers",
                              "Boundary/right/Traction=1",
                              "Initial values/Velocity=0",
                              "Initial values/Displacement=x+1e-9*sin(x)",
                              "Initial values/Temperature=10-5*x+1e-9*sin(x)"})
            << std::endl;
  }



  void
  count_what_is_made(const std::string &condition)
  {
    const RecordedRun run      = run_iterative<2>({"Dimension=2",
                                                   "Mesh/Width=0.25",
                                                   "Mesh/Cells=8",
                                                   "Mesh/Cells across=2",
                                                   "Mesh/Degree=1",
                                                   "Contact/Condition=" + condition,
                                                   "Contact/Gap=0.02",
                                                   "Initial values/Velocity=x",
                                                   "Boundary/left/Temperature=0",
                                                   "Initial values/Temperature=0*x",
                                                   "Time/Scheme=sdirk2",
                                                   "Time/Step size=0.02",
                                                   "Time/End time=6"});
    unsigned int      n_begins = 0;
    for (unsigned int i = 1; i < run.rows.size(); ++i)
      n_begins += run.rows[i].in_contact && !run.rows[i - 1].in_contact;
    deallog << condition << ": contact more than once " << (n_begins > 1)
            << ", made " << run.counters.factorizations << std::endl;
  }



  void
  count_steps_without_stress()
  {
    const auto count = run_iterative<2>({"Dimension=2",
                                         "Model/Fields=displacement",
                                         "Model/Inertia=0",
                                         "Model/Viscosity=0",
                                         "Boundary/left/Displacement=t/100",
                                         "Boundary/sides/Support=free",
                                         "Contact/Condition=none",
                                         "Mesh/Width=1",
                                         "Mesh/Cells=8",
                                         "Mesh/Cells across=8",
                                         "Time/End time=1"})
                         .rows.size() -
                       1;
    deallog << "carried along: steps " << count << std::endl;
  }



  /** Sets of contact nodes and Krylov iterations of a patch that grows. */
  template <int dim>
  void
  count_sets(const std::string &obstacle)
  {
    const Overrides   body{"Dimension=" + std::to_string(dim),
                         "Mesh/Width=1",
                         "Mesh/Degree=2",
                         dim == 2 ? "Mesh/Cells=16" : "Mesh/Cells=4",
                         dim == 2 ? "Mesh/Cells across=16" :
                                      "Mesh/Cells across=4",
                         "Model/Poisson ratio=0.3",
                         "Boundary/sides/Support=free",
                         "Time/Scheme=backward euler",
                         "Time/Start=consistent",
                         "Time/Step size=0.01",
                         "Time/End time=0.12",
                         "Initial values/Temperature=0*x",
                         "Initial values/Velocity=x*(0.5+y)",
                         "Boundary/left/Temperature=0"};
    const RecordedRun run = run_iterative<dim>(
      body + Overrides{"Contact/Gap=0.05", "Contact/" + obstacle});
    const auto free =
      run_iterative<dim>(body + Overrides{"Contact/Condition=none"});
    unsigned int n = 0, sum = 0, largest = 0;
    for (const StepRecord &r : run.rows)
      if (r.in_contact)
        {
          ++n;
          sum += r.iterations;
          largest = std::max(largest, r.iterations);
        }
    const unsigned int iterations = run.counters.max_linear_iterations,
                       without    = free.counters.max_linear_iterations;
    deallog << dim << "-D, " << obstacle << ": steps " << n << ", sets " << sum
            << ", at most " << largest << "; iterations " << iterations
            << ", without " << without
            << (sum <= 4 * n && largest <= 8 &&
                    iterations <= 1.6 * without + 2. ?
                  "" :
                  " exceeds 4, 8 or 1.6 times + 2")
            << std::endl;
  }
} // namespace



void
main_iterative_counts()
{
  initlog();
  deallog << "Krylov iterations of cubes: ";
  count_iterations<2>(1, {16, 64});
  count_iterations<2>(2, {8, 32});
  count_iterations<3>(1, {4, 8});
  count_iterations<3>(2, {2, 4});

  const Overrides round{"Mesh/Geometry=axisymmetric"};
  deallog << "round rod: " << iterations<2>(2, 8, 1e-2, round);
  for (const std::string mesh : {"Width=16", "Grading=200"})
    deallog << "; " << mesh << ": "
            << iterations<3>(2, 4, 0.1, {"Mesh/" + mesh});
  // its coarsest level is itself
  deallog << "; one cell: " << iterations<2>(2, 1, 0.1, {}) << std::endl;
  // what keeps its volume is soft
  for (const std::string nu : {"0.45", "0.4999"})
    {
      const Overrides soft{"Model/Poisson ratio=" + nu,
                           "Model/Inertia=0",
                           "Initial values/Temperature=theta_A"};
      deallog << "nu = " << nu << ": " << iterations<2>(2, 16, 0.1, soft)
              << ", " << iterations<2>(4, 8, 0.1, soft) << ", "
              << iterations<3>(2, 4, 0.1, soft) << std::endl;
    }
  count_short_stages();

  deallog << "sets of contact nodes: ";
  for (const std::string obstacle : {"Compliance=1",
                                     "Compliance=1e-6",
                                     "Compliance=1e-9",
                                     "Condition=rigid"})
    {
      count_sets<2>(obstacle);
      count_sets<3>(obstacle);
    }

  deallog << "what is made: ";
  count_what_is_made("normal compliance");
  count_what_is_made("rigid");
  count_steps_without_stress();
}
