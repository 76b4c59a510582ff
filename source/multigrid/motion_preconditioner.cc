// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/motion_preconditioner.h>
#include <thermocontact/multigrid/stage_hierarchies.h>

namespace ThermoContact
{
  namespace
  {
    template <int dim>
    class MotionCycle : public StageHierarchies<dim>
    {
    public:
      using StageHierarchies<dim>::StageHierarchies;

      void
      set_springs(const std::vector<double> &springs) override
      {
        if (springs.empty())
          {
            // as in a run that is resumed
            this->clear();
            this->provide(1.);
          }
        else
          StageHierarchies<dim>::set_springs(springs);
      }
    };
  } // namespace



  template <int dim>
  std::unique_ptr<Preconditioner>
  make_motion_preconditioner(const Body<dim> &body)
  {
    if constexpr (dim > 1)
      if (body.equations.cell_products() != nullptr)
        return std::make_unique<MotionCycle<dim>>(body);
    (void)body;
    return nullptr;
  }



#define INSTANTIATE(dim)                                               \
  template std::unique_ptr<Preconditioner> make_motion_preconditioner( \
    const Body<dim> &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
