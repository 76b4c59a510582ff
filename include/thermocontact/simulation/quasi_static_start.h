// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_quasi_static_start_h
#define thermocontact_simulation_quasi_static_start_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Completes the state of a body without inertia, the initial one or one that
   * no stage has completed, doc/model.md section 12: with viscosity the
   * velocity follows from the displacement, (M.34); without, the displacement
   * is in equilibrium with the temperature, (M.35), and the velocity, which has
   * no value yet, is left at zero.
   *
   * @param state in: temperature and, with viscosity, displacement and pressure
   *   of the compliance law
   * @param is_closed with viscosity, at a rigid obstacle: the nodes in contact;
   *   empty: those that do not lie before it
   * @throw ComputationError if the stiffness matrix cannot be factorised or the
   *   contact nodes do not settle
   */
  template <int dim>
  void
  complete_quasi_static_state(Body<dim>               &body,
                              State                   &state,
                              const std::vector<bool> &is_closed = {});
} // namespace ThermoContact

#endif
