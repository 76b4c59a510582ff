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
      if (!body.scene.linear_solver.has_matrices())
        return std::make_unique<IterativeSolver<dim>>(body);
    return std::make_unique<MonolithicSolver<dim>>(body);
  }



  template <int dim>
  std::unique_ptr<OpenStageSolver>
  make_open_stage_solver(const Body<dim> &body)
  {
    return std::make_unique<MonolithicSolver<dim>>(body);
  }



#define INSTANTIATE(dim)                                                 \
  template std::unique_ptr<StageSolver> make_stage_solver<dim>(          \
    const Body<dim> &);                                                  \
  template std::unique_ptr<OpenStageSolver> make_open_stage_solver<dim>( \
    const Body<dim> &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
