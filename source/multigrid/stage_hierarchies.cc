// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/stage_hierarchies.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  template <int dim>
  StageHierarchies<dim>::StageHierarchies(const Body<dim> &body)
    : body(body)
    , levels_(body)
    , hierarchies(most_kept())
  {}



  template <int dim>
  void
  StageHierarchies<dim>::provide(const double tau)
  {
    if (hierarchies.use(tau))
      return;
    Hierarchy          hierarchy{tau, nullptr, nullptr, {}, {}, {}};
    const unsigned int finest = levels_.n_levels() - 1;
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
    hierarchies.add(std::move(hierarchy));
    ++n_made_;
  }



  template <int dim>
  types::global_dof_index
  StageHierarchies<dim>::n_factorized_unknowns() const
  {
    types::global_dof_index largest = 0;
    for (const Field::Block field : all_fields)
      largest = std::max(largest, levels_.field(0, field).right.size());
    return largest;
  }



  namespace
  {
    /** How much stiffer or softer a spring may be. */
    constexpr double same_stiffness = 2.;



    /** True if preconditioners do not tell them apart. */
    bool
    are_similar(const std::vector<double> &some,
                const std::vector<double> &others)
    {
      if (some.size() != others.size())
        return false;
      for (unsigned int i = 0; i < some.size(); ++i)
        if (some[i] != others[i] && (some[i] == 0. || others[i] == 0. ||
                                     some[i] > same_stiffness * others[i] ||
                                     others[i] > same_stiffness * some[i]))
          return false;
      return true;
    }



    template <int dim>
    ContactRows
    contact_rows(const Discretization<dim> &space,
                 const std::vector<double> &springs)
    {
      const Vector zero = space.make_vector(Field::displacement);
      ContactRows  rows{zero, zero};
      for (const auto &[node, entry] :
           space.contact_end().entries(Field::displacement))
        if (std::isinf(springs[node]))
          rows.held.local_element(entry) = 1.;
        else
          rows.springs.local_element(entry) = springs[node];
      return rows;
    }
  } // namespace



  template <int dim>
  void
  StageHierarchies<dim>::set_springs(const std::vector<double> &springs)
  {
    Hierarchy &hierarchy = hierarchies.front();
    if (!hierarchy.momentum || are_similar(springs, hierarchy.springs))
      return;
    hierarchy.springs.clear(); // if the following fails
    if (std::none_of(springs.begin(), springs.end(), [](const double spring) {
          return spring > 0.;
        }))
      {
        hierarchy.momentum->set_contact(nullptr);
        hierarchy.springs = springs;
        return;
      }
    const bool is_last = are_similar(springs, hierarchy.last_contact);
    const std::vector<double> chosen =
      is_last ? hierarchy.last_contact : springs;
    hierarchy.last_contact.clear();
    if (!is_last)
      ++n_made_;
    const ContactRows rows = contact_rows(body.discretization, chosen);
    hierarchy.momentum->set_contact(&rows, is_last);
    hierarchy.springs = hierarchy.last_contact = chosen;
  }



  template class StageHierarchies<2>;
  template class StageHierarchies<3>;
} // namespace ThermoContact
