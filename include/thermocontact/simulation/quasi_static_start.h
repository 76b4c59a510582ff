// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_quasi_static_start_h
#define thermocontact_simulation_quasi_static_start_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

namespace ThermoContact
{
  /**
   * Completes the initial state of a body without inertia, doc/model.md section
   * 12: with viscosity the velocity follows from the displacement, (M.34);
   * without, the displacement is in equilibrium with the temperature, (M.35),
   * and the velocity, which has no value yet, is left at zero.
   *
   * @param state in: temperature and, with viscosity, displacement and pressure
   *   of the compliance law
   * @throw ComputationError if the stiffness matrix cannot be factorised or the
   *   contact nodes do not settle
   */
  template <int dim>
  void
  complete_quasi_static_state(Body<dim> &body, State &state);
} // namespace ThermoContact

#endif
