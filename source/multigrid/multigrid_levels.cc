// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/multigrid_levels.h>

#include <optional>

namespace ThermoContact
{
  namespace
  {
    /** Nodes of the coarsest level, whose factors fill their band. */
    template <int dim>
    constexpr unsigned int max_coarse_nodes = dim == 2 ? 1000 : 400;



    /** From the coarsest to that of the body. */
    template <int dim>
    std::vector<LevelGrid<dim>>
    grids_of(const MeshParameters &mesh)
    {
      std::vector<LevelGrid<dim>> grids{LevelGrid<dim>(mesh)};
      do
        if (const std::optional<LevelGrid<dim>> coarse =
              grids.front().coarsened())
          grids.insert(grids.begin(), *coarse);
        else
          break;
      while (grids.front().n_nodes() > max_coarse_nodes<dim>);
      if (grids.size() == 1)
        grids.push_back(grids.front());
      return grids;
    }
  } // namespace



  template <int dim, typename Number>
  MultigridLevels<dim, Number>::MultigridLevels(const Body<dim> &body)
    : body(body)
  {
    const Discretization<dim> &space = body.discretization;
    for (const LevelGrid<dim> &grid : grids_of<dim>(body.scene.parameters.mesh))
      levels.push_back({grid, nullptr, {}});
    for (Level &level : levels)
      level.products =
        &level == &levels.back() ?
          std::make_unique<const LevelProducts<dim, Number>>(
            body.scene, space, level.grid, *body.equations.matrix_free()) :
          std::make_unique<const LevelProducts<dim, Number>>(body.scene,
                                                             space,
                                                             level.grid);
    coarse_products_ =
      std::make_unique<const LevelProducts<dim, double>>(body.scene,
                                                         space,
                                                         levels[0].grid);
    for (const Field::Block field : all_fields)
      if (space.has_field(field))
        {
          for (Level &level : levels)
            make_field(level, field);
          levels.back().fields[field].prescribed =
            space.constrained_entries(field);
          for (unsigned int l = levels.size() - 1; l > 0; --l)
            connect(levels[l - 1], levels[l], field);
        }
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::make_field(Level             &level,
                                           const Field::Block field) const
  {
    LevelField<dim, Number> &of_field = level.fields[field];
    of_field.right                    = level.products->make_vector(field);
    of_field.solution                 = of_field.right;
    of_field.residual                 = of_field.right;
    of_field.update                   = of_field.right;
    of_field.mass                     = of_field.right;
    of_field.stiffness                = of_field.right;
    if (&level == &levels.back())
      {
        const MatrixFreeOperator<dim> &products = *body.equations.matrix_free();
        const bool                     is_heat  = field == Field::temperature;
        copy_values(of_field.mass,
                    is_heat ? products.heat_diagonal({1., 0.}) :
                              products.momentum_diagonal({1., 0.}));
        copy_values(of_field.stiffness,
                    is_heat ? products.heat_diagonal({0., 1.}) :
                              products.momentum_diagonal({0., 1.}));
        return;
      }
    of_field.exchange = of_field.right;
    for (const bool is_mass : {true, false})
      {
        LevelVector<Number> &diagonal =
          is_mass ? of_field.mass : of_field.stiffness;
        level.products->visit_entries(field,
                                      is_mass,
                                      !is_mass,
                                      [&](const unsigned int row,
                                          const unsigned int column,
                                          const Number       value) {
                                        if (row == column)
                                          diagonal.local_element(row) += value;
                                      });
      }
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::connect(Level             &coarse,
                                        Level             &fine,
                                        const Field::Block field) const
  {
    LevelField<dim, Number>       &coarse_field = coarse.fields[field];
    const LevelField<dim, Number> &fine_field   = fine.fields[field];
    const bool                     is_finest    = &fine == &levels.back();
    fine.fields[field].transfer.reinit(coarse.grid,
                                       fine.grid,
                                       fine.products->nodes(field),
                                       n_components(field),
                                       is_finest ?
                                         body.discretization.communicator() :
                                         MPI_COMM_SELF);

    LevelVector<Number> marks(fine_field.right),
      coarse_marks(coarse_field.right);
    for (const unsigned int entry : fine_field.prescribed)
      marks.local_element(entry) = 1.;
    fine_field.transfer.inject(coarse_marks, marks);
    for (unsigned int i = 0; i < coarse_marks.locally_owned_size(); ++i)
      if (coarse_marks.local_element(i) > 0.)
        coarse_field.prescribed.push_back(i);

    if (field == Field::displacement)
      return;
    LevelVector<Number> exchange(fine_field.right);
    if (is_finest)
      for (const auto &[node, entry] :
           body.contact_end().entries(Field::temperature))
        exchange.local_element(entry) = body.scene.heat.linear_coefficient() *
                                        body.contact_end().nodes()[node].weight;
    else
      exchange = fine_field.exchange;
    fine_field.transfer.restrict_to(coarse_field.exchange, exchange);
  }



  template class MultigridLevels<2, float>;
  template class MultigridLevels<2, double>;
  template class MultigridLevels<3, float>;
  template class MultigridLevels<3, double>;
} // namespace ThermoContact
