// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_make_stage_solver_h
#define thermocontact_time_make_stage_solver_h

#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_solver.h>

#include <memory>

namespace ThermoContact
{
  /** The solver that the scene of @p body asks for. The body is borrowed. */
  template <int dim>
  std::unique_ptr<StageSolver>
  make_stage_solver(const Body<dim> &body);

  /** The one for integrators that find the pressures themselves. */
  template <int dim>
  std::unique_ptr<OpenStageSolver>
  make_open_stage_solver(const Body<dim> &body);
} // namespace ThermoContact

#endif
