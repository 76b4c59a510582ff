// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_motion_preconditioner_h
#define thermocontact_multigrid_motion_preconditioner_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/linear_system.h>

#include <memory>

namespace ThermoContact
{
  /**
   * A V-cycle for motion_by_stiffness of a body without inertia and without
   * matrices: its block in a stage of length 1. Null for bodies with matrices.
   *
   * @param body borrowed
   */
  template <int dim>
  std::unique_ptr<Preconditioner>
  make_motion_preconditioner(const Body<dim> &body);
} // namespace ThermoContact

#endif
