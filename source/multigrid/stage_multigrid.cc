// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/stage_multigrid.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Steps of smoothers, and the range of eigenvalues that they treat. */
    struct Smoothing
    {
      unsigned int degree;
      double       range;
    };



    /**
     * Three steps treat a range of 15. Motions that keep the volume are soft
     * beside others, by $\mu/\lambda$: where no subspaces are for them, the
     * range grows with $\lambda/\mu$, the steps with its root.
     */
    Smoothing
    smoothing(const Field::Block field,
              const bool         has_subspaces,
              const Material    &material)
    {
      if (field == Field::temperature)
        return {2, 15.};
      if (has_subspaces)
        return {4, 25.};
      constexpr double   most_steps = 24.;
      const double       ratio      = 2. * material.lambda / material.two_mu;
      const unsigned int degree =
        std::clamp(std::ceil(1.5 + 0.75 * std::sqrt(std::max(ratio, 0.))),
                   3.,
                   most_steps);
      return {degree, 15. * degree * degree / 9.};
    }



    /** Restricts contact rows to the next coarser level. */
    template <int dim, typename Number>
    ContactRows
    restricted(const ContactRows             &fine,
               const LevelField<dim, Number> &fine_field,
               const LevelField<dim, Number> &coarse_field)
    {
      LevelVector<Number> values(fine_field.right), coarse(coarse_field.right);
      ContactRows         result;
      const auto          set = [&](Vector &vector, const double factor) {
        vector.reinit(coarse.get_partitioner());
        copy_values(vector, coarse);
        vector *= factor;
      };
      values = Number();
      if (const double largest =
            fine.springs.size() > 0 ? fine.springs.linfty_norm() : 0.;
          largest > 0.)
        {
          // over the largest one, so that float has room for it
          for (unsigned int i = 0; i < values.locally_owned_size(); ++i)
            values.local_element(i) = fine.springs.local_element(i) / largest;
          fine_field.transfer.restrict_to(coarse, values, true);
          set(result.springs, largest);
        }
      if (fine.held.size() > 0)
        {
          copy_values(values, fine.held);
          fine_field.transfer.inject_to(coarse, values);
          set(result.held, 1.);
        }
      return result;
    }
  } // namespace



  template <int dim, typename Number>
  StageMultigrid<dim, Number>::StageMultigrid(
    const MultigridLevels<dim, Number> &levels,
    const Field::Block                  field,
    const double                        tau)
    : levels(levels)
    , field(field)
    , stage_levels(levels.n_levels())
  {
    const unsigned int finest = levels.n_levels() - 1;
    scale = StageBlock<dim, Number>(levels, finest, field, tau)
              .diagonal()
              .linfty_norm();
    const Smoothing steps =
      smoothing(field, levels.has_subspaces(), levels.scene().material);
    for (unsigned int l = 0; l < levels.n_levels(); ++l)
      {
        Level &level = stage_levels[l];
        level.block  = std::make_unique<StageBlock<dim, Number>>(
          levels, l, field, tau, scale);
        if (l == 0)
          continue;
        level.smoother =
          std::make_unique<ChebyshevSmoother<dim, Number>>(*level.block,
                                                           steps.degree,
                                                           steps.range);
        level.smoother->estimate_eigenvalue();
      }
    factors_without_contact = stage_levels[0].block->factors();
  }



  template <int dim, typename Number>
  void
  StageMultigrid<dim, Number>::set_rows(const unsigned int l,
                                        const ContactRows &rows)
  {
    stage_levels[l].block->set_contact(rows);
    if (l == 0)
      return;
    stage_levels[l].smoother->update_diagonal();
    // no vector of a level is assigned to one of another, whose ranks differ
    set_rows(l - 1,
             restricted(rows,
                        levels.field(l, field),
                        levels.field(l - 1, field)));
  }



  template <int dim, typename Number>
  void
  StageMultigrid<dim, Number>::set_contact(const ContactRows *rows,
                                           const bool         are_as_before)
  {
    if (rows == nullptr)
      {
        if (has_contact)
          set_rows(levels.n_levels() - 1, ContactRows());
        has_contact = false;
        return;
      }
    has_contact = true;
    set_rows(levels.n_levels() - 1, *rows);
    if (!are_as_before || !factors_with_contact)
      factors_with_contact = stage_levels[0].block->factors();
  }



  template <int dim, typename Number>
  void
  StageMultigrid<dim, Number>::cycle(const unsigned int l) const
  {
    const LevelField<dim, Number> &vectors = levels.field(l, field);
    if (l == 0)
      {
        coarse_values.assign(vectors.right.begin(), vectors.right.end());
        (has_contact ? factors_with_contact : factors_without_contact)
          ->solve(coarse_values);
        std::copy(coarse_values.begin(),
                  coarse_values.end(),
                  vectors.solution.begin());
        return;
      }
    const LevelField<dim, Number> &coarse   = levels.field(l - 1, field);
    const Level                   &level    = stage_levels[l];
    LevelVector<Number>           &residual = vectors.residual;
    LevelVector<Number>           &solution = vectors.solution;
    const typename ChebyshevSmoother<dim, Number>::Work work{residual,
                                                             vectors.update};
    level.smoother->smooth(solution, vectors.right, work, true);
    level.block->vmult(residual, solution);
    residual.sadd(-1., vectors.right);
    vectors.transfer.restrict_to(coarse.right, residual);
    stage_levels[l - 1].block->zero_prescribed(coarse.right);
    cycle(l - 1);
    vectors.transfer.prolongate_and_add(solution, coarse.solution);
    level.block->zero_prescribed(solution);
    level.smoother->smooth(solution, vectors.right, work, false);
  }



  template <int dim, typename Number>
  void
  StageMultigrid<dim, Number>::vmult(Vector &z, const Vector &r) const
  {
    const unsigned int             finest  = levels.n_levels() - 1;
    const LevelField<dim, Number> &vectors = levels.field(finest, field);
    const double                   largest = r.linfty_norm();
    if (largest == 0.)
      {
        z = 0.;
        return;
      }
    for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
      vectors.right.local_element(i) = r.local_element(i) / largest;
    stage_levels.back().block->zero_prescribed(vectors.right);
    cycle(finest);
    const double factor = largest / scale;
    for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
      z.local_element(i) = factor * vectors.solution.local_element(i);
  }



  template class StageMultigrid<2, float>;
  template class StageMultigrid<2, double>;
  template class StageMultigrid<3, float>;
  template class StageMultigrid<3, double>;
} // namespace ThermoContact
