// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_fuzz_first_steps_h
#define thermocontact_fuzz_first_steps_h

#include <thermocontact/simulation/simulation.h>

#include <string>

namespace ThermoContact
{
  /**
   * The first steps of a run, 20 of a rod and 5 of a body, with all its files
   * and reports, and those of the repeats for its error bars.
   *
   * @param directory for the files, made and emptied here
   * @throw ComputationError as the run
   */
  template <int dim>
  void
  take_first_steps(Simulation<dim> &simulation, const std::string &directory);
} // namespace ThermoContact

#endif
