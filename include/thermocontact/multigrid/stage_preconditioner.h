// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_preconditioner_h
#define thermocontact_multigrid_stage_preconditioner_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/linear_system.h>

#include <memory>

namespace ThermoContact
{
  /**
   * V-cycles for the blocks of stages of a body without matrices. Null for
   * bodies with matrices.
   *
   * @param body borrowed
   */
  template <int dim>
  std::unique_ptr<Preconditioner>
  make_stage_preconditioner(const Body<dim> &body);
} // namespace ThermoContact

#endif
