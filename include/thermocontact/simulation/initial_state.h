// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_initial_state_h
#define thermocontact_simulation_initial_state_h

#include <thermocontact/simulation/reset.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The state at $t=0$: the projection $P_E$ of the initial values, before the
   * fixed end takes another temperature than theirs, which is for the first
   * step (Reset::heat_fixed_end()), contact nodes no further than the initial
   * values have them at a rigid obstacle, and the pressure of the contact law.
   * Without inertia it is completed, and contact nodes that are to be in
   * equilibrium are put there, doc/discretisation.md section 5 and
   * doc/contact-in-time.md section 6.
   *
   * @param reset of the body, lent
   * @param first_step_size of the paper's first step, if the scene has it
   * @param warnings appended to: a corner layer of the temperature, contact at
   *   the start, a preload
   * @throw InputError if displacement or velocity do not vanish where they are
   *   held, or if a rigid obstacle is penetrated at the start or by the
   *   paper's first step
   */
  template <int dim>
  State
  initial_state(Body<dim>                &body,
                Reset<dim>               &reset,
                const double              first_step_size,
                std::vector<std::string> &warnings);
} // namespace ThermoContact

#endif
