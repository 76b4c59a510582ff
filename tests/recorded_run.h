// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_recorded_run_h
#define thermocontact_tests_recorded_run_h

#include <thermocontact/simulation/simulation.h>

#include <string>
#include <vector>

#include "overrides.h"
#include "tests.h"

namespace ThermoContact
{
  /** What a run has shown: the record of each step, events, counts. */
  struct RecordedRun
  {
    std::vector<StepRecord>   rows;
    std::vector<ContactEvent> events;
    SolverCounters            counters;
  };



  /** Runs a scene of prm, or the defaults if @p file is empty. */
  template <int dim>
  RecordedRun
  run(const std::string &file, const Overrides &overrides)
  {
    RecordedRun     result;
    Simulation<dim> simulation(read_parameters(file, overrides), MPI_COMM_SELF);
    simulation.run(
      {[&](const Simulation<dim> &s) { result.rows.push_back(s.record()); }});
    result.events   = simulation.events();
    result.counters = simulation.counters();
    return result;
  }
} // namespace ThermoContact

#endif
