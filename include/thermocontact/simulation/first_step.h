// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_first_step_h
#define thermocontact_simulation_first_step_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

namespace ThermoContact
{
  /**
   * Size of a first step of a body that conducts heat alone which error control
   * accepts, doc/discretisation.md (D3.6): the estimate of what decays at the
   * rate $\lambda$ is below $C_m(\lambda\,\Delta t)^m$ of it for each $m$, so
   * that the rates $\theta^{(m)}$ of the equations of the mesh bound it,
   * however rough the initial temperature is. Where loads vary they are those
   * of the start.
   *
   * @param state at the start of the step
   * @param thermal_energy $\frac12\|\hat\theta\|^2$, the scale of the errors;
   *   zero: the rate makes it
   * @return infinity if a body is not such, or if nothing is known of it
   */
  template <int dim>
  double
  first_step_of_heat(Body<dim>   &body,
                     const State &state,
                     const double thermal_energy);
} // namespace ThermoContact

#endif
