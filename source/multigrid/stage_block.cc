// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/stage_block.h>
#include <thermocontact/space/system_coefficients.h>

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
    , mass(mass_and_stiffness(stage_coefficients(tau),
                              levels.scene().material,
                              field)
             .mass /
           scale)
    , stiffness(mass_and_stiffness(stage_coefficients(tau),
                                   levels.scene().material,
                                   field)
                  .stiffness /
                scale)
    , scale(scale)
  {
    set_contact({});
  }



  template <int dim, typename Number>
  void
  StageBlock<dim, Number>::vmult(LevelVector<Number>       &y,
                                 const LevelVector<Number> &x) const
  {
    levels.products(level).vmult(field, mass, stiffness, y, x);
    complete(y, x);
  }



  template <int dim, typename Number>
  std::unique_ptr<const BandFactors>
  StageBlock<dim, Number>::factors() const
  {
    const LevelMatrix<dim, double> &matrix = levels.coarse_matrix();
    LevelVector<double> some(matrix.make_vector(field)), product(some);
    const unsigned int  n = some.size(), band = matrix.band(field);
    auto                result = std::make_unique<BandFactors>(n, band);
    // columns so far from each other that their rows below do not meet
    for (unsigned int first = 0; first < std::min(n, 2 * band + 1); ++first)
      {
        some = 0.;
        for (unsigned int j = first; j < n; j += 2 * band + 1)
          some.local_element(j) = 1.;
        zero_prescribed(some);
        matrix.vmult(field, mass, stiffness, product, some);
        complete(product, some);
        for (unsigned int j = first; j < n; j += 2 * band + 1)
          for (unsigned int i = j; i < std::min(n, j + band + 1); ++i)
            result->entry(i, j) = product.local_element(i);
      }
    for (const unsigned int entry : prescribed)
      result->entry(entry, entry) = 1.;
    result->factorize();
    return result;
  }



  template <int dim, typename Number>
  Vector
  StageBlock<dim, Number>::diagonal(const bool has_stiffness) const
  {
    const LevelField<dim, Number> &parts = levels.field(level, field);
    Vector                         result;
    result.reinit(parts.right.get_partitioner());
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      result.local_element(i) =
        mass * parts.mass.local_element(i) +
        (has_stiffness ? stiffness : 0.) * parts.stiffness.local_element(i);
    for (const auto &[entry, spring] : springs)
      result.local_element(entry) += spring;
    for (const unsigned int entry : prescribed)
      result.local_element(entry) =
        has_stiffness ? 1. : Tolerances::stiffest_spring;
    return result;
  }



  template <int dim, typename Number>
  std::optional<SubspaceFactors<dim, Number>>
  StageBlock<dim, Number>::subspace_factors() const
  {
    const LevelField<dim, Number> &parts = levels.field(level, field);
    if (!parts.subspaces)
      return {};
    return SubspaceFactors<dim, Number>(*parts.subspaces, stiffness);
  }



  template <int dim, typename Number>
  void
  StageBlock<dim, Number>::set_contact(const ContactRows &rows)
  {
    const LevelVector<Number> &exchange = levels.field(level, field).exchange;
    prescribed                          = levels.field(level, field).prescribed;
    springs.clear();
    for (unsigned int i = 0; i < exchange.locally_owned_size(); ++i)
      if (exchange.local_element(i) > 0.)
        springs.emplace_back(i, stiffness * exchange.local_element(i));
    for (unsigned int i = 0; i < rows.springs.locally_owned_size(); ++i)
      if (rows.springs.local_element(i) > 0.)
        springs.emplace_back(i,
                             std::min(rows.springs.local_element(i) / scale,
                                      Tolerances::stiffest_spring));
    for (unsigned int i = 0; i < rows.held.locally_owned_size(); ++i)
      if (rows.held.local_element(i) > 0.)
        prescribed.push_back(i);
  }



  template class StageBlock<2, float>;
  template class StageBlock<2, double>;
  template class StageBlock<3, float>;
  template class StageBlock<3, double>;
} // namespace ThermoContact
