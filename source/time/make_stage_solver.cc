// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/fixed_point_solver.h>
#include <thermocontact/time/iterative_solver.h>
#include <thermocontact/time/make_stage_solver.h>
#include <thermocontact/time/monolithic_solver.h>

namespace ThermoContact
{
  template <int dim>
  std::unique_ptr<StageSolver>
  make_stage_solver(const Body<dim> &body)
  {
    if (body.scene.is_fixed_point)
      return std::make_unique<FixedPointSolver<dim>>(body);
    if constexpr (dim > 1)
      if (body.scene.linear_solver.is_iterative)
        return std::make_unique<IterativeSolver<dim>>(body);
    return std::make_unique<MonolithicSolver<dim>>(body);
  }



  template std::unique_ptr<StageSolver>
  make_stage_solver(const Body<1> &);
  template std::unique_ptr<StageSolver>
  make_stage_solver(const Body<2> &);
  template std::unique_ptr<StageSolver>
  make_stage_solver(const Body<3> &);
} // namespace ThermoContact
