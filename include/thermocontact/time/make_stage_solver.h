// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_make_stage_solver_h
#define thermocontact_time_make_stage_solver_h

#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_solver.h>

#include <memory>

namespace ThermoContact
{
  /**
   * The solver that the scene asks for, of stages whose coefficients do not
   * depend on the temperature.
   *
   * @param body borrowed
   */
  template <int dim>
  std::unique_ptr<StageSolver>
  make_stage_solver(const Body<dim> &body);
} // namespace ThermoContact

#endif
