// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What accuracy costs: experiment 1, 0 <= t <= 10, error-controlled steps, mesh
// of 4 cells of degree 5 (42 unknowns with the fixed end), against a solution
// that is exact in time and spectral in space: the table
// tests/reference/experiment-1-exact.csv and five times of contact,
// from an independent code (tests/reference/exact_in_time.py agrees to 1e-12).
// Between its rows the cubic Hermite interpolant of u(1), u_t(1) errs by less
// than 5e-8; the force follows from it by the contact law. Errors are the
// largest at the ends of steps; costs are solves of stages.
//
// 1. Tolerance 4e-6: u(1) and the times of contact to 1e-6, at most 1800
// solves.
//    Measured: 9.7e-7, of which nearly all is space; 6.8e-7; 1555 solves.
// 2. Tolerance 1.5e-2: not worse than the paper's scheme with h = 1/250, dt =
//    0.001, which takes 10000 solves and errs by 2.0e-3 in u(1) and 6.1e-2 in
//    the force: 2e-3, 6e-2, at most 400 solves. Measured: 2.3e-4, 9.7e-3, 295
//    solves.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const double gap = 0.1, compliance = 0.01;

  const std::array<double, 5> event_times = {{0.1849692017564,
                                              0.8966775426167,
                                              3.0398984502590,
                                              3.9353865611236,
                                              5.7567026050974}};

  /** t, u(1), u_t(1). */
  using Rows = std::vector<std::array<double, 3>>;



  Rows
  read_table()
  {
    std::ifstream file(std::string(REFERENCE_DIR) + "/experiment-1-exact.csv");
    std::string   line;
    std::getline(file, line); // header
    Rows table = {{{0., 0., 0.}}};
    while (std::getline(file, line))
      {
        std::istringstream    stream(line);
        std::array<double, 4> row; // t, u_end, u_mid, v_end
        for (double &value : row)
          {
            std::string cell;
            std::getline(stream, cell, ',');
            value = std::stod(cell);
          }
        table.push_back({{row[0], row[1], row[3]}});
      }
    return table;
  }



  double
  exact_displacement(const Rows &table, const double time)
  {
    unsigned int i = 1;
    while (i + 1 < table.size() && table[i][0] < time)
      ++i;
    const auto  &a = table[i - 1], &b = table[i];
    const double h = b[0] - a[0];
    return CubicHermite(a[1], h * a[2], b[1], h * b[2])
      .value((time - a[0]) / h);
  }



  struct Measured
  {
    double       displacement = 0., force = 0., event_time = 0.;
    unsigned int n_solves = 0;
  };



  Measured
  run(const Rows &table, const double tolerance)
  {
    Parameters parameters     = read_parameters("");
    parameters.mesh.cells     = 4;
    parameters.mesh.degree    = 5;
    parameters.time.tolerance = tolerance;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    Measured      errors;
    const auto    observe = [&](const Simulation<1> &s) {
      const StepRecord &r     = s.record();
      const double      u     = exact_displacement(table, r.time);
      const double      force = std::max(u - gap, 0.) / compliance;
      raise(errors.displacement, std::abs(r.displacement_end - u));
      raise(errors.force, std::abs(r.contact_force - force));
    };
    simulation.run({observe});

    const auto &events = simulation.events();
    if (events.size() != event_times.size())
      raise(errors.event_time, std::numeric_limits<double>::infinity());
    else
      for (unsigned int i = 0; i < events.size(); ++i)
        raise(errors.event_time, std::abs(events[i].time - event_times[i]));
    errors.n_solves = simulation.counters().solves;
    return errors;
  }
} // namespace



void
main_accuracy_cost()
{
  initlog();
  const Rows table = read_table();

  const Measured fine = run(table, 4e-6);
  deallog << "tolerance 4e-6: u(1) " << within(fine.displacement, 1e-6)
          << ", times of contact " << within(fine.event_time, 1e-6)
          << ", at most 1800 solves " << within(fine.n_solves, 1800)
          << std::endl;

  const Measured coarse = run(table, 1.5e-2);
  deallog << "tolerance 1.5e-2: u(1) " << within(coarse.displacement, 2e-3)
          << ", force " << within(coarse.force, 6e-2) << ", at most 400 solves "
          << within(coarse.n_solves, 400) << std::endl;
}
