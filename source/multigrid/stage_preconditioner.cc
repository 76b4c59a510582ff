// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/stage_hierarchies.h>
#include <thermocontact/multigrid/stage_preconditioner.h>

namespace ThermoContact
{
  template <int dim>
  std::unique_ptr<Preconditioner>
  make_stage_preconditioner(const Body<dim> &body)
  {
    if constexpr (dim > 1)
      if (body.equations.cell_products() != nullptr)
        return std::make_unique<StageHierarchies<dim>>(body);
    (void)body;
    return nullptr;
  }



#define INSTANTIATE(dim)                                              \
  template std::unique_ptr<Preconditioner> make_stage_preconditioner( \
    const Body<dim> &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
