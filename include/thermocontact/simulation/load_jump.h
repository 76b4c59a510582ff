// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_load_jump_h
#define thermocontact_simulation_load_jump_h

#include <thermocontact/method/load_history.h>
#include <thermocontact/simulation/reset.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_solver.h>
#include <thermocontact/time/time_integrator.h>

#include <vector>

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
   * loads, with the contact law, and takes heat for it, (M.67); a body with
   * viscosity and without inertia stays and gets the velocity, and at a rigid
   * obstacle the pressures, of (M.34); all else stays. The loads do the work of
   * the way that they push it, and what is too much for the new energy is
   * numerical dissipation. Collective.
   *
   * @param body of a scene that moves_at_jumps()
   * @param reset of the body, for (M.34)
   * @param solver of the stages
   * @param is_closed nodes that are in contact before the jump: only they may
   *   have a pressure in (M.34), where all nodes stay where they are; not used
   *   for (M.67), which finds its contact
   * @param at the end of the step, with the times of the old and new loads
   * @param result in: a step that is accepted; out: with the state after the
   *   jump, at the same time, and its energy; work and numerical dissipation
   *   are added to, and all else, closed_nodes too, is still that of the step
   * @return false if the loads of the momentum equation do not jump there, as
   *   at a time that is only listed; then nothing is changed
   * @throw ComputationError if the new equilibrium is not found
   */
  template <int dim>
  bool
  apply_load_jump(Body<dim>               &body,
                  Reset<dim>              &reset,
                  StageSolver             &solver,
                  const std::vector<bool> &is_closed,
                  const LoadBreak         &at,
                  StepResult              &result);
} // namespace ThermoContact

#endif
