// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_lateral_runs_h
#define thermocontact_tests_lateral_runs_h

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <functional>
#include <string>
#include <vector>

#include "overrides.h"
#include "row_checks.h"
#include "tests.h"

namespace ThermoContact
{
  /** All records of a run. */
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
  inline double
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


  inline double
  difference(const std::vector<StepRecord> &a, const std::vector<StepRecord> &b)
  {
    return difference(table_of(a), table_of(b));
  }


  /** A rod that is thrown at an obstacle in cold surroundings. */
  inline const Overrides thrown{"Model/Coupling=0.3",
                                "Boundary/left/Temperature=1",
                                "Boundary/right/Surroundings=0.5",
                                "Boundary/sides/Heat exchange=3",
                                "Boundary/sides/Surroundings=-2",
                                "Contact/Gap=0.05",
                                "Contact/Compliance=0.1",
                                "Initial values/Temperature=theta_A*(1-x^2)",
                                "Initial values/Velocity=x",
                                "Mesh/Cells=4",
                                "Mesh/Degree=2",
                                "Time/Scheme=sdirk2",
                                "Time/Step size=0.02",
                                "Time/End time=1"};
} // namespace ThermoContact

#endif
