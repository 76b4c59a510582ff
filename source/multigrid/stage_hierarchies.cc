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
    : levels_(body)
  {}



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
    hierarchies.push_front({tau, nullptr, nullptr, {}, {}, {}});
    Hierarchy         &hierarchy = hierarchies.front();
    const unsigned int finest    = levels_.n_levels() - 1;
    for (const Field::Block field : all_fields)
      if (levels_.has_field(field))
        {
          auto &multigrid =
            field == Field::temperature ? hierarchy.heat : hierarchy.momentum;
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
