// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The same numbers on one rank and on two, to 1e-10 of the largest value of the
// column, in every column of every step: each rank runs the scene alone
// (MPI_COMM_SELF) and both run it together (MPI_COMM_WORLD). Dimensions 2 and
// 3; elastic and rigid obstacle; the paper's iteration; sources. A rod is not
// shared: its numbers are the same bit for bit. Contact occurs in all of them.
// All take the numbers of rank 0 and the failure of rank 1. A SIGTERM that rank
// 1 gets while it waits for rank 0 does nothing.

#include <thermocontact/base/serial_section.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  template <int dim>
  std::vector<StepRecord>
  run(const Parameters &parameters, const MPI_Comm communicator)
  {
    std::vector<StepRecord> records;
    Simulation<dim>         simulation(parameters, communicator);
    const auto              observe = [&](const Simulation<dim> &s) {
      records.push_back(s.record());
    };
    simulation.run({observe});
    return records;
  }



  template <int dim>
  void
  compare(const std::string       &name,
          std::vector<std::string> overrides,
          const double             bound = 1e-10)
  {
    overrides.insert(overrides.end(),
                     {"Dimension=" + std::to_string(dim),
                      "Mesh/Degree=2",
                      "Mesh/Cells=6",
                      "Time/Step size=0.02",
                      "Time/End time=0.6"});
    if (dim > 1)
      overrides.insert(overrides.end(),
                       {"Mesh/Cells across=2",
                        "Mesh/Width=0.4",
                        "Model/Poisson ratio=0.3",
                        "Boundary/sides/Support=free"});
    const Parameters parameters = read_parameters("", overrides);
    const auto       alone      = run<dim>(parameters, MPI_COMM_SELF);
    const auto       together   = run<dim>(parameters, MPI_COMM_WORLD);

    double       difference = alone.size() == together.size() ? 0. : 1.;
    unsigned int n_contact  = 0;
    auto         largest    = all_columns(alone.front());
    largest.fill(1.);
    for (unsigned int n = 0; n < alone.size(); ++n)
      {
        const auto a = all_columns(alone[n]), b = all_columns(together[n]);
        for (unsigned int i = 0; i < a.size(); ++i)
          {
            largest[i] = std::max(largest[i], std::abs(a[i]));
            raise(difference, std::abs(a[i] - b[i]) / largest[i]);
          }
        n_contact += alone[n].in_contact;
      }
    difference = Utilities::MPI::max(difference, MPI_COMM_WORLD);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      deallog << dim << "-D, " << name << ": contact occurs " << (n_contact > 0)
              << ", one rank equals two to " << bound << ' '
              << within(difference, bound) << std::endl;
  }



  void
  test_agreement(const unsigned int rank)
  {
    StepResult                  result;
    const std::vector<double *> numbers{&result.work,
                                        &result.dissipation,
                                        &result.lateral_dissipation,
                                        &result.numerical_dissipation,
                                        &result.algebraic,
                                        &result.contact_dissipation,
                                        &result.impulse};
    for (unsigned int i = 0; i < numbers.size(); ++i)
      *numbers[i] = 1. + i + 10. * rank;
    result.agree(MPI_COMM_WORLD);
    const bool   none_fails = result.failure.empty();
    unsigned int n_right    = 0;
    for (unsigned int i = 0; i < numbers.size(); ++i)
      n_right += *numbers[i] == 1. + i;
    n_right        = Utilities::MPI::sum(n_right, MPI_COMM_WORLD);
    result.failure = rank == 1 ? "of rank 1" : "";
    result.agree(MPI_COMM_WORLD);
    if (rank == 0)
      deallog << "one step: numbers of rank 0 " << n_right << ", no failure "
              << none_fails << ", " << result.failure << std::endl;
  }



  void
  test_signal(const unsigned int rank)
  {
    const auto numbers = Utilities::MPI::all_gather(MPI_COMM_WORLD, getpid());
    serial_section(
      [&]() {
        const std::chrono::milliseconds time(200);
        std::this_thread::sleep_for(time); // rank 1 comes to wait
        kill(numbers[1], SIGTERM);
        std::this_thread::sleep_for(time);
      },
      MPI_COMM_WORLD);
    const unsigned int n = Utilities::MPI::sum(1u, MPI_COMM_WORLD);
    if (rank == 0)
      deallog << "after a signal to rank 1: ranks " << n << std::endl;
  }
} // namespace



void
main_ranks()
{
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  if (rank == 0)
    {
      initlog();
      deallog << "ranks " << Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)
              << std::endl;
    }

  compare<1>("fixed point",
             {"Solver/Step solver=fixed point", "Time/Scheme=backward euler"},
             0.);
  compare<1>("rigid obstacle and sources",
             {"Contact/Condition=rigid",
              "Sources/Heat source=x*t",
              "Sources/Body force=sin(t)*x",
              "Boundary/right/Traction=0.3*t",
              "Boundary/right/Heat flux=1+t"},
             0.);
  compare<2>("rigid obstacle and sources",
             {"Contact/Condition=rigid",
              "Time/Scheme=sdirk2",
              "Sources/Heat source=x*t",
              "Sources/Body force=sin(t)*x; y",
              "Boundary/right/Traction=0.3*t*(1+y)",
              "Boundary/right/Heat flux=1+t"});
  compare<2>("fixed point",
             {"Solver/Step solver=fixed point",
              "Time/Scheme=backward euler",
              "Contact/Compliance=0.1"});
  compare<3>("elastic obstacle", {});
  test_agreement(rank);
  test_signal(rank);
}
