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
  StageHierarchies<dim>::StageHierarchies(const MultigridLevels<dim> &levels)
    : levels(levels)
  {}



  template <int dim>
  bool
  StageHierarchies<dim>::provide(const double tau)
  {
    const auto known =
      std::find_if(hierarchies.begin(),
                   hierarchies.end(),
                   [tau](const Hierarchy &h) { return h.tau == tau; });
    if (known != hierarchies.end())
      {
        hierarchies.splice(hierarchies.begin(), hierarchies, known);
        return false;
      }
    while (hierarchies.size() >= max_hierarchies)
      hierarchies.pop_back();
    hierarchies.push_front({tau, nullptr, nullptr, {}, {}});
    Hierarchy         &hierarchy = hierarchies.front();
    const unsigned int finest    = levels.n_levels() - 1;
    for (const Field::Block field : all_fields)
      if (levels.discretization(finest).has_field(field))
        {
          auto &multigrid =
            field == Field::temperature ? hierarchy.heat : hierarchy.momentum;
          multigrid = std::make_unique<StageMultigrid<dim>>(levels, field, tau);
          hierarchy.diagonals[field] =
            StageBlock<dim>(levels, finest, field, tau).diagonal();
        }
    return true;
  }



  template <int dim>
  void
  StageHierarchies<dim>::set_contact(const std::vector<bool> &active_set,
                                     const ContactRows       &rows)
  {
    Hierarchy &hierarchy = hierarchies.front();
    if (!hierarchy.momentum)
      return;
    const auto has_node = [](const std::vector<bool> &set) {
      return std::find(set.begin(), set.end(), true) != set.end();
    };
    // the coarsest matrix is factorised again for each new set
    if (has_node(hierarchy.active_set) || has_node(active_set))
      if (hierarchy.active_set != active_set)
        hierarchy.momentum->set_contact(has_node(active_set) ? &rows : nullptr);
    hierarchy.active_set = active_set;
  }



  template <int dim>
  std::vector<double>
  StageHierarchies<dim>::lengths() const
  {
    std::vector<double> result;
    for (const Hierarchy &hierarchy : hierarchies)
      result.push_back(hierarchy.tau);
    return result;
  }



  template class StageHierarchies<2>;
  template class StageHierarchies<3>;
} // namespace ThermoContact
