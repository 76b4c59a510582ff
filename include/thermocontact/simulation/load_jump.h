// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_load_jump_h
#define thermocontact_simulation_load_jump_h

#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_solver.h>
#include <thermocontact/time/time_integrator.h>

namespace ThermoContact
{
  /**
   * True if a jump of the loads moves something at once: a body without inertia
   * and viscosity, contact nodes in equilibrium; or gives a body without
   * inertia another velocity.
   */
  bool
  moves_at_jumps(const Scene &scene);



  /**
   * The state after a jump of the loads at the end of a step, doc/model.md
   * section 18: what is in equilibrium at all times goes to that of the new
   * loads, with the contact law, and takes heat for it; all else stays. The
   * loads do the work of the way that they push it, and what is too much for
   * the new energy is numerical dissipation. Collective.
   *
   * @param solver of the stages
   * @param result in: a step that is accepted; out: with the state after the
   *   jump, at the same time
   * @throw ComputationError if the new equilibrium is not found
   */
  template <int dim>
  void
  apply_load_jump(Body<dim> &body, StageSolver &solver, StepResult &result);
} // namespace ThermoContact

#endif
