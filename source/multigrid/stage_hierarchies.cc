// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/stage_hierarchies.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    constexpr unsigned int max_hierarchies = 4;
  } // namespace



  template <int dim>
  StageHierarchies<dim>::StageHierarchies(const Body<dim> &body)
    : body(body)
    , levels_(body)
  {}



  template <int dim>
  void
  StageHierarchies<dim>::factorise()
  {
    shortest_factorised_ = current().tau;
    hierarchies.remove_if([this](const Hierarchy &hierarchy) {
      return hierarchy.tau >= shortest_factorised_;
    });
    provide(shortest_factorised_);
  }



  template <int dim>
  types::global_dof_index
  StageHierarchies<dim>::n_factorized_unknowns() const
  {
    const Discretization<dim> &space  = body.discretization;
    types::global_dof_index    result = 0;
    for (const Field::Block field : all_fields)
      if (space.has_field(field))
        result =
          std::max<types::global_dof_index>(result,
                                            !matrices ?
                                              levels_.field(0, field).right.size() :
                                            field == Field::temperature ?
                                              space.n_temperature_dofs() :
                                              space.n_displacement_dofs());
    return result;
  }



  template <int dim>
  void
  StageHierarchies<dim>::provide(const double tau)
  {
    const auto known =
      std::find_if(hierarchies.begin(),
                   hierarchies.end(),
                   [tau](const Hierarchy &h) { return h.tau == tau; });
    if (known != hierarchies.end())
      {
        hierarchies.splice(hierarchies.begin(), hierarchies, known);
        return;
      }
    while (hierarchies.size() >= max_hierarchies)
      hierarchies.pop_back();
    if (tau >= shortest_factorised_ && !matrices)
      matrices = std::make_unique<const BodyMatrices<dim>>(body);
    hierarchies.push_front({tau, nullptr, nullptr, {}, {}, {}});
    Hierarchy         &hierarchy = hierarchies.front();
    const unsigned int finest    = levels_.n_levels() - 1;
    for (const Field::Block field : all_fields)
      if (body.discretization.has_field(field))
        {
          std::unique_ptr<StagePreconditioner> &multigrid =
            field == Field::temperature ? hierarchy.heat : hierarchy.momentum;
          if (has_factors())
            multigrid =
              std::make_unique<StageFactors<dim>>(*matrices, field, tau);
          else
            multigrid =
              std::make_unique<StageMultigrid<dim, float>>(levels_, field, tau);
          hierarchy.diagonals[field] =
            StageBlock<dim, float>(levels_, finest, field, tau).diagonal();
        }
    ++n_made_;
  }



  template <int dim>
  void
  StageHierarchies<dim>::set_contact(const std::vector<bool> &active_set,
                                     const ContactRows       &rows)
  {
    Hierarchy &hierarchy = hierarchies.front();
    if (!hierarchy.momentum || hierarchy.active_set == active_set)
      return;
    hierarchy.active_set.clear(); // if the following fails
    if (std::find(active_set.begin(), active_set.end(), true) ==
        active_set.end())
      hierarchy.momentum->set_contact(nullptr);
    else
      {
        const bool is_last = hierarchy.last_contact == active_set;
        hierarchy.momentum->set_contact(&rows, is_last);
        hierarchy.last_contact = active_set;
        if (!is_last)
          ++n_made_;
      }
    hierarchy.active_set = active_set;
  }



  template class StageHierarchies<2>;
  template class StageHierarchies<3>;
} // namespace ThermoContact
