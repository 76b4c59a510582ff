// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/stage_multigrid.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** Restricts contact rows to the next coarser level. */
    template <int dim>
    ContactRows
    restricted(const ContactRows                     &fine,
               const MGTwoLevelTransfer<dim, Vector> &transfer,
               const Vector                          &prototype,
               const ContactEnd<dim>                 &fine_end)
    {
      const auto restrict_vector = [&](const Vector &vector) {
        Vector result(prototype), copy(vector);
        result = 0.;
        copy.update_ghost_values();
        transfer.restrict_and_add(result, copy);
        result.zero_out_ghost_values();
        return result;
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



  template <int dim>
  StageBlock<dim>::StageBlock(const MultigridLevels<dim> &levels,
                              const unsigned int          level,
                              const Field::Block          field,
                              const double                tau)
    : levels(levels)
    , level(level)
    , field(field)
    , tau(tau)
    , prescribed(levels.discretization(level).constrained_entries(field))
    , scratch(levels.spaces(level).make_vector(field))
  {}



  template <int dim>
  void
  StageBlock<dim>::vmult(Vector &y, const Vector &x) const
  {
    scratch.copy_locally_owned_data_from(x);
    zero_prescribed(scratch);
    const Material &material = levels.scene().material;
    if (field == Field::temperature)
      levels.products(level).heat({1., tau}, y, scratch);
    else
      levels.products(level).momentum(
        {material.inertia, tau * (tau + material.viscosity)}, y, scratch);
    for (const auto &[entry, spring] : springs)
      y.local_element(entry) += spring * scratch.local_element(entry);
    for (const unsigned int entry : prescribed)
      y.local_element(entry) = x.local_element(entry);
  }



  template <int dim>
  Vector
  StageBlock<dim>::diagonal() const
  {
    const LevelField<dim> &parts    = levels.field(level, field);
    const Material        &material = levels.scene().material;
    Vector                 result(scratch);
    const bool             is_heat = field == Field::temperature;
    result.equ(is_heat ? 1. : material.inertia, parts.mass);
    result.add(is_heat ? tau : tau * (tau + material.viscosity),
               parts.stiffness);
    for (const auto &[entry, spring] : springs)
      result.local_element(entry) += spring;
    for (const unsigned int entry : prescribed)
      result.local_element(entry) = 1.;
    return result;
  }



  template <int dim>
  void
  StageBlock<dim>::set_contact(const ContactRows &rows)
  {
    prescribed = levels.discretization(level).constrained_entries(field);
    springs.clear();
    if (rows.springs.size() > 0)
      for (unsigned int i = 0; i < rows.springs.locally_owned_size(); ++i)
        if (rows.springs.local_element(i) > 0.)
          springs.emplace_back(i, rows.springs.local_element(i));
    if (rows.held.size() > 0)
      for (unsigned int i = 0; i < rows.held.locally_owned_size(); ++i)
        if (rows.held.local_element(i) > 0.)
          prescribed.push_back(i);
  }



  template <int dim>
  void
  StageBlock<dim>::zero_prescribed(Vector &vector) const
  {
    for (const unsigned int entry : prescribed)
      vector.local_element(entry) = 0.;
  }



  template <int dim>
  StageMultigrid<dim>::StageMultigrid(const MultigridLevels<dim> &levels,
                                      const Field::Block          field,
                                      const double                tau)
    : levels(levels)
    , field(field)
    , tau(tau)
    , fine(levels.n_levels() - 1)
  {
    for (unsigned int l = 1; l < levels.n_levels(); ++l)
      {
        Level &level = fine[l - 1];
        level.block  = std::make_unique<StageBlock<dim>>(levels, l, field, tau);
        level.inverse_diagonal = std::make_shared<DiagonalMatrix<Vector>>();
        Vector &diagonal       = level.inverse_diagonal->get_vector();
        diagonal               = level.block->diagonal();
        for (double &value : diagonal)
          value = 1. / value;

        typename Smoother::AdditionalData data;
        data.degree              = field == Field::temperature ? 2 : 3;
        data.smoothing_range     = 15.;
        data.eig_cg_n_iterations = 12;
        data.preconditioner      = level.inverse_diagonal;
        level.smoother           = std::make_unique<Smoother>();
        level.smoother->initialize(*level.block, data);
        level.smoother->estimate_eigenvalues(levels.field(l, field).right);
      }
    coarse_without_contact = std::make_unique<CoarseSolver<dim>>(
      levels,
      field,
      field == Field::temperature ?
        levels.coarse_operator().heat_stage_matrix(tau) :
        levels.coarse_operator().momentum_stage_matrix(tau));
  }



  template <int dim>
  void
  StageMultigrid<dim>::set_rows(const ContactRows &rows)
  {
    coarse_rows = rows;
    for (unsigned int l = levels.n_levels() - 1; l >= 1; --l)
      {
        Level &level = fine[l - 1];
        level.block->set_contact(coarse_rows);
        Vector &diagonal = level.inverse_diagonal->get_vector();
        diagonal         = level.block->diagonal();
        for (double &value : diagonal)
          value = 1. / value;
        coarse_rows = restricted(coarse_rows,
                                 levels.field(l, field).transfer,
                                 levels.field(l - 1, field).right,
                                 levels.discretization(l).contact_end());
      }
  }



  template <int dim>
  void
  StageMultigrid<dim>::set_contact(const ContactRows *rows,
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
      levels,
      field,
      with_contact(coarse_without_contact->matrix(), coarse_rows));
  }



  template <int dim>
  void
  StageMultigrid<dim>::zero_coarse(Vector &vector) const
  {
    for (const unsigned int entry :
         levels.discretization(0).constrained_entries(field))
      vector.local_element(entry) = 0.;
    for (unsigned int i = 0; i < coarse_rows.held.locally_owned_size(); ++i)
      if (coarse_rows.held.local_element(i) > 0.)
        vector.local_element(i) = 0.;
  }



  template <int dim>
  void
  StageMultigrid<dim>::cycle(const unsigned int l) const
  {
    const LevelField<dim> &vectors = levels.field(l, field);
    if (l == 0)
      {
        zero_coarse(vectors.right);
        (has_contact ? coarse_with_contact : coarse_without_contact)
          ->solve(vectors.solution, vectors.right);
        zero_coarse(vectors.solution);
        return;
      }
    const Level                           &level  = fine[l - 1];
    const LevelField<dim>                 &coarse = levels.field(l - 1, field);
    Vector                                &residual = vectors.residual;
    const MGTwoLevelTransfer<dim, Vector> &transfer = vectors.transfer;
    level.smoother->vmult(vectors.solution, vectors.right);
    level.block->vmult(residual, vectors.solution);
    residual.sadd(-1., vectors.right);
    level.block->zero_prescribed(residual);
    residual.update_ghost_values();
    coarse.right = 0.;
    transfer.restrict_and_add(coarse.right, residual);
    residual.zero_out_ghost_values();
    if (l > 1)
      fine[l - 2].block->zero_prescribed(coarse.right);
    cycle(l - 1);
    coarse.solution.update_ghost_values();
    residual = 0.;
    transfer.prolongate_and_add(residual, coarse.solution);
    coarse.solution.zero_out_ghost_values();
    level.block->zero_prescribed(residual);
    vectors.solution += residual;
    level.smoother->step(vectors.solution, vectors.right);
  }



  template <int dim>
  void
  StageMultigrid<dim>::vmult(Vector &z, const Vector &r) const
  {
    const unsigned int     finest  = levels.n_levels() - 1;
    const LevelField<dim> &vectors = levels.field(finest, field);
    vectors.right.copy_locally_owned_data_from(r);
    cycle(finest);
    z.copy_locally_owned_data_from(vectors.solution);
  }



  template class StageBlock<2>;
  template class StageBlock<3>;
  template class StageMultigrid<2>;
  template class StageMultigrid<3>;
} // namespace ThermoContact
