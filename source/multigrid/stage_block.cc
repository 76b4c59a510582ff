// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/stage_block.h>

#include <algorithm>

namespace ThermoContact
{
  template <int dim, typename Number>
  StageBlock<dim, Number>::StageBlock(
    const MultigridLevels<dim, Number> &levels,
    const unsigned int                  level,
    const Field::Block                  field,
    const double                        tau,
    const double                        scale)
    : levels(levels)
    , level(level)
    , field(field)
    , mass(
        (field == Field::temperature ? 1. : levels.scene().material.inertia) /
        scale)
    , stiffness(tau *
                (field == Field::temperature ?
                   1. :
                   tau + levels.scene().material.viscosity) /
                scale)
    , scale(scale)
    , prescribed(levels.field(level, field).prescribed)
  {
    set_exchange();
  }



  template <int dim, typename Number>
  void
  StageBlock<dim, Number>::vmult(LevelVector<Number>       &y,
                                 const LevelVector<Number> &x) const
  {
    levels.products(level).vmult(field, mass, stiffness, y, x);
    for (const auto &[entry, spring] : springs)
      y.local_element(entry) += spring * x.local_element(entry);
    zero_prescribed(y);
  }



  template <int dim, typename Number>
  Vector
  StageBlock<dim, Number>::diagonal() const
  {
    return diagonal(stiffness, 1.);
  }



  template <int dim, typename Number>
  Vector
  StageBlock<dim, Number>::diagonal(const double stiffness,
                                    const double at_prescribed) const
  {
    const LevelField<dim, Number> &parts = levels.field(level, field);
    Vector                         result;
    result.reinit(parts.right.get_partitioner());
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      result.local_element(i) = mass * parts.mass.local_element(i) +
                                stiffness * parts.stiffness.local_element(i);
    for (const auto &[entry, spring] : springs)
      result.local_element(entry) += spring;
    for (const unsigned int entry : prescribed)
      result.local_element(entry) = at_prescribed;
    return result;
  }



  template <int dim, typename Number>
  std::optional<SubspaceFactors<dim, Number>>
  StageBlock<dim, Number>::subspace_factors() const
  {
    const LevelField<dim, Number> &parts = levels.field(level, field);
    if (!parts.subspaces)
      return {};
    return SubspaceFactors<dim, Number>(
      *parts.subspaces, stiffness, diagonal(0., Tolerances::stiffest_spring));
  }



  template <int dim, typename Number>
  void
  StageBlock<dim, Number>::set_contact(const ContactRows &rows)
  {
    prescribed = levels.field(level, field).prescribed;
    springs.clear();
    set_exchange();
    for (unsigned int i = 0; i < rows.springs.locally_owned_size(); ++i)
      if (rows.springs.local_element(i) > 0.)
        springs.emplace_back(i,
                             std::min(rows.springs.local_element(i) / scale,
                                      Tolerances::stiffest_spring));
    for (unsigned int i = 0; i < rows.held.locally_owned_size(); ++i)
      if (rows.held.local_element(i) > 0.)
        prescribed.push_back(i);
  }



  template <int dim, typename Number>
  void
  StageBlock<dim, Number>::set_exchange()
  {
    const LevelVector<Number> &exchange = levels.field(level, field).exchange;
    for (unsigned int i = 0; i < exchange.locally_owned_size(); ++i)
      if (exchange.local_element(i) > 0.)
        springs.emplace_back(i, stiffness * exchange.local_element(i));
  }



  template class StageBlock<2, float>;
  template class StageBlock<2, double>;
  template class StageBlock<3, float>;
  template class StageBlock<3, double>;
} // namespace ThermoContact
