// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a coupled solve of the iterative solver costs, in elastic products of
// the same mesh, and what a new stage length costs. CPU time of all ranks, so
// that other work on the machine disturbs little; without files.
//
//   cmake --build build/release --target stage_cost
//   build/release/tests/bench/stage_cost scene.prm
//
// Prints unknowns; the time of a product; of a solve, with its sets, residuals,
// error estimates, energies: all of the time loop over the solves; of both
// preconditioners of a stage length, and of the coarsest level with contact.

#include <thermocontact/multigrid/stage_multigrid.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/cell_products.h>

#include <deal.II/base/mpi.h>

#include <ctime>
#include <functional>
#include <iostream>

#include "../cycle.h"

using namespace ThermoContact;

namespace
{
  using ThermoContact::Vector;

  /** CPU seconds of all ranks for a call; what is short is repeated. */
  double
  cpu_seconds(const std::function<void()> &call, const double at_least = 0.)
  {
    const std::clock_t begin   = std::clock();
    unsigned int       n_calls = 0;
    double             seconds = 0.;
    do
      {
        call();
        ++n_calls;
        seconds =
          Utilities::MPI::sum(double(std::clock() - begin) / CLOCKS_PER_SEC,
                              MPI_COMM_WORLD);
      }
    while (seconds < at_least);
    return seconds / n_calls;
  }



  template <int dim>
  void
  measure(const Parameters &parameters)
  {
    Simulation<dim>                 simulation(parameters, MPI_COMM_WORLD);
    const Body<dim>                &body = simulation.body();
    const CellProducts<dim, double> matrices(body.scene, body.discretization);
    Vector x(body.discretization.make_vector(Field::displacement)), y(x);
    for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
      x.local_element(i) = std::sin(1. + i);
    const double product =
      cpu_seconds([&] { matrices.vmult(Field::displacement, 1., 0.1, y, x); },
                  1.);

    const double         loop = cpu_seconds([&] { simulation.run(); });
    const SolverCounters n    = simulation.counters();

    const double                      tau = 0.7 * parameters.time.end_time;
    const MultigridLevels<dim, float> levels(body);
    std::unique_ptr<StageMultigrid<dim, float>> heat, momentum;
    const double                                set_up = cpu_seconds([&] {
      heat = std::make_unique<StageMultigrid<dim, float>>(levels,
                                                          Field::temperature,
                                                          tau);
      momentum =
        std::make_unique<StageMultigrid<dim, float>>(levels,
                                                     Field::displacement,
                                                     tau);
    });
    const ContactRows rows = contact_rows(body, true, tau);
    const double contact   = cpu_seconds([&] { momentum->set_contact(&rows); });

    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << body.discretization.dof_handler().n_dofs() << " unknowns, "
                << simulation.record().step << " steps, " << n.solves
                << " solves, " << n.linear_iterations << " iterations\n"
                << "product              " << 1e3 * product << " ms\n"
                << "solve, all included  " << loop / n.solves / product
                << " products\n"
                << "a new stage length   " << set_up / product << " products\n"
                << "a new contact set    " << contact / product
                << " products\n";
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc != 2)
    {
      std::cerr << "usage: stage_cost FILE.prm\n";
      return 2;
    }
  dealii::ParameterHandler prm;
  Parameters               parameters;
  parameters.add_parameters(prm);
  std::istringstream text(read_text(argv[1]));
  assign_entries(read_assignments(text, argv[1]), prm, parameters);
  check_scene(parameters);
  if (parameters.dimension == 2)
    measure<2>(parameters);
  else
    measure<3>(parameters);
}
