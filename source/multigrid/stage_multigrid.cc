// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/stage_multigrid.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** Restricts contact rows to the next coarser level. */
    template <int dim, typename Number>
    ContactRows
    restricted(const ContactRows             &fine,
               const LevelField<dim, Number> &fine_field,
               const LevelField<dim, Number> &coarse_field,
               const ContactEnd<dim>         &fine_end)
    {
      // over the largest one, so that float has room for it
      const auto restrict_vector = [&](const Vector &vector) {
        LevelVector<Number> result(coarse_field.right), copy(fine_field.right);
        const double        largest = vector.linfty_norm();
        const double        scale   = largest > 0. ? largest : 1.;
        result                      = 0.;
        for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
          copy.local_element(i) = vector.local_element(i) / scale;
        copy.update_ghost_values();
        fine_field.transfer.restrict_and_add(result, copy);
        Vector coarse(result.get_partitioner());
        copy_values(coarse, result);
        coarse *= scale;
        return coarse;
      };
      ContactRows coarse;
      if (fine.springs.size() > 0)
        {
          // the row sums of the product with the springs between two transfers
          coarse.springs = restrict_vector(fine.springs);
          for (double &spring : coarse.springs)
            spring = std::max(spring, 0.);
        }
      if (fine.held.size() > 0)
        {
          // a coarse node is held if more than half of what it stands for is
          Vector all(fine.held), part(fine.held);
          all = 0.;
          for (const auto &[node, entry] :
               fine_end.entries(Field::displacement))
            all.local_element(entry) = fine_end.nodes()[node].weight;
          part.scale(all);
          const Vector whole = restrict_vector(all);
          coarse.held        = restrict_vector(part);
          for (unsigned int i = 0; i < whole.locally_owned_size(); ++i)
            {
              double &held = coarse.held.local_element(i);
              held         = whole.local_element(i) > 0. &&
                         held > 0.5 * whole.local_element(i) ?
                               1. :
                               0.;
            }
        }
      return coarse;
    }
  } // namespace



  template <int dim, typename Number>
  StageMultigrid<dim, Number>::StageMultigrid(
    const MultigridLevels<dim, Number> &levels,
    const Field::Block                  field,
    const double                        tau)
    : levels(levels)
    , field(field)
    , tau(tau)
    , fine(levels.n_levels() - 1)
  {
    const unsigned int finest = levels.n_levels() - 1;
    scale = StageBlock<dim, Number>(levels, finest, field, tau)
              .diagonal()
              .linfty_norm();
    for (unsigned int l = 1; l < levels.n_levels(); ++l)
      {
        Level &level = fine[l - 1];
        level.block  = std::make_unique<StageBlock<dim, Number>>(
          levels, l, field, tau, scale);
        level.smoother = std::make_unique<ChebyshevSmoother<dim, Number>>(
          *level.block, field == Field::temperature ? 2 : 3);
        level.smoother->estimate_eigenvalue();
      }
    coarse_without_contact = std::make_unique<CoarseSolver<dim>>(
      levels.spaces(0).dof_handler(field),
      field,
      field == Field::temperature ?
        levels.coarse_operator().heat_stage_matrix(tau) :
        levels.coarse_operator().momentum_stage_matrix(tau),
      levels.is_factorised(levels.spaces(0).dof_handler(field).n_dofs()));
  }



  template <int dim, typename Number>
  void
  StageMultigrid<dim, Number>::set_rows(const ContactRows &rows)
  {
    coarse_rows = rows;
    for (unsigned int l = levels.n_levels() - 1; l >= 1; --l)
      {
        fine[l - 1].block->set_contact(coarse_rows);
        fine[l - 1].smoother->update_diagonal();
        coarse_rows = restricted(coarse_rows,
                                 levels.field(l, field),
                                 levels.field(l - 1, field),
                                 levels.discretization(l).contact_end());
      }
  }



  template <int dim, typename Number>
  void
  StageMultigrid<dim, Number>::set_contact(const ContactRows *rows,
                                           const bool         are_as_before)
  {
    if (rows == nullptr)
      {
        if (has_contact)
          set_rows(ContactRows());
        has_contact = false;
        return;
      }
    has_contact = true;
    set_rows(*rows);
    if (are_as_before && coarse_with_contact)
      return;
    coarse_with_contact.reset(); // its memory, before there are other factors
    coarse_with_contact = std::make_unique<CoarseSolver<dim>>(
      levels.spaces(0).dof_handler(field),
      field,
      with_contact(coarse_without_contact->matrix(), coarse_rows),
      levels.is_factorised(levels.spaces(0).dof_handler(field).n_dofs()));
  }



  template <int dim, typename Number>
  void
  StageMultigrid<dim, Number>::zero_coarse(Vector &vector) const
  {
    for (const unsigned int entry :
         levels.discretization(0).constrained_entries(field))
      vector.local_element(entry) = 0.;
    for (unsigned int i = 0; i < coarse_rows.held.locally_owned_size(); ++i)
      if (coarse_rows.held.local_element(i) > 0.)
        vector.local_element(i) = 0.;
  }



  template <int dim, typename Number>
  void
  StageMultigrid<dim, Number>::solve_coarse() const
  {
    const LevelField<dim, Number> &vectors  = levels.field(0, field);
    Vector                        &right    = vectors.coarse_right;
    Vector                        &solution = vectors.coarse_solution;
    copy_values(right, vectors.right);
    zero_coarse(right);
    (has_contact ? coarse_with_contact : coarse_without_contact)
      ->solve(solution, right);
    zero_coarse(solution);
    solution *= scale;
    copy_values(vectors.solution, solution);
  }



  template <int dim, typename Number>
  void
  StageMultigrid<dim, Number>::cycle(const unsigned int l) const
  {
    if (l == 0)
      {
        solve_coarse();
        return;
      }
    const LevelField<dim, Number> &vectors  = levels.field(l, field);
    const LevelField<dim, Number> &coarse   = levels.field(l - 1, field);
    const Level                   &level    = fine[l - 1];
    LevelVector<Number>           &residual = vectors.residual;
    LevelVector<Number>           &solution = vectors.solution;
    level.smoother->smooth_zero(solution,
                                vectors.right,
                                {residual, vectors.update});
    level.block->vmult(residual, solution);
    residual.sadd(-1., vectors.right);
    residual.update_ghost_values();
    coarse.right = 0.;
    vectors.transfer.restrict_and_add(coarse.right, residual);
    residual.zero_out_ghost_values();
    if (l > 1)
      fine[l - 2].block->zero_prescribed(coarse.right);
    cycle(l - 1);
    coarse.solution.update_ghost_values();
    vectors.transfer.prolongate_and_add(solution, coarse.solution);
    coarse.solution.zero_out_ghost_values();
    level.block->zero_prescribed(solution);
    level.smoother->smooth(solution, vectors.right, {residual, vectors.update});
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
    fine.back().block->zero_prescribed(vectors.right);
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
