// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/multigrid_levels.h>
#include <thermocontact/space/cell_products.h>

#include <optional>

namespace ThermoContact
{
  namespace
  {
    /** The coarsest level has no more where cells can become longer. */
    constexpr unsigned int max_coarse_nodes = 100;



    /** Of all levels but the body; the coarsest first. */
    template <int dim>
    std::vector<LevelGrid<dim>>
    coarser_grids(const LevelGrid<dim> &body)
    {
      std::vector<LevelGrid<dim>> grids;
      do
        {
          const std::optional<LevelGrid<dim>> coarse =
            (grids.empty() ? body : grids.front()).coarsened();
          if (!coarse)
            break;
          grids.insert(grids.begin(), *coarse);
        }
      while (grids.front().n_nodes() > max_coarse_nodes);
      if (grids.empty())
        grids.push_back(body);
      return grids;
    }



    template <int dim>
    std::vector<NodalValue<dim>>
    nodal_values(const LevelGrid<dim> &grid, const Field::Block field)
    {
      std::vector<NodalValue<dim>> values;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        for (unsigned int c = 0; c < n_components<dim>(field); ++c)
          values.push_back({c, grid.node(grid.index(i))});
      return values;
    }
  } // namespace



  template <int dim, typename Number>
  MultigridLevels<dim, Number>::MultigridLevels(const Body<dim> &body)
    : body(body)
  {
    const Discretization<dim>        &space = body.discretization;
    const LevelGrid<dim>              of_body(body.scene.parameters.mesh);
    const std::vector<LevelGrid<dim>> grids = coarser_grids(of_body);
    coarse_matrix_ =
      std::make_unique<const LevelMatrix<dim, double>>(body.scene,
                                                       space.geometry(),
                                                       grids[0]);
    for (const LevelGrid<dim> &grid : grids)
      {
        levels.emplace_back();
        levels.back().products =
          std::make_unique<const LevelMatrix<dim, Number>>(body.scene,
                                                           space.geometry(),
                                                           grid);
      }
    auto products =
      std::make_unique<const CellProducts<dim, Number>>(body.scene, space);
    levels.emplace_back();
    for (const Field::Block field : all_fields)
      if (space.has_field(field))
        {
          auto values = space.nodal_values(field);
          make_field(
            *products, of_body, values, field, levels.back().fields[field]);
          levels.back().fields[field].prescribed =
            space.constrained_entries(field);
          for (unsigned int l = levels.size() - 1; l-- > 0;)
            {
              const auto finer = std::move(values);
              values           = nodal_values(grids[l], field);
              make_field(*levels[l].products,
                         grids[l],
                         values,
                         field,
                         levels[l].fields[field]);
              connect(grids[l], finer, l + 1, field);
            }
        }
    levels.back().products = std::move(products);
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::make_field(
    const LevelOperator<Number>        &products,
    const LevelGrid<dim>               &grid,
    const std::vector<NodalValue<dim>> &values,
    const Field::Block                  field,
    LevelField<dim, Number>            &of_field) const
  {
    of_field.mass      = products.diagonal(field, 1., 0.);
    of_field.stiffness = products.diagonal(field, 0., 1.);
    of_field.right     = products.make_vector(field);
    for (LevelVector<Number> *vector :
         {&of_field.solution, &of_field.residual, &of_field.update})
      *vector = of_field.right;
    if (field == Field::temperature)
      of_field.exchange = of_field.right;
    else if (has_subspaces())
      of_field.subspaces = std::make_unique<const LevelSubspaces<dim, Number>>(
        grid, body.scene.material, of_field.right, values);
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::connect(
    const LevelGrid<dim>               &grid,
    const std::vector<NodalValue<dim>> &fine_values,
    const unsigned int                  level,
    const Field::Block                  field)
  {
    LevelField<dim, Number> &fine      = levels[level].fields[field];
    LevelField<dim, Number> &coarse    = levels[level - 1].fields[field];
    const bool               is_finest = level + 1 == levels.size();
    fine.transfer.reinit(grid,
                         fine_values,
                         n_components<dim>(field),
                         is_finest ? body.discretization.communicator() :
                                     MPI_COMM_SELF);

    LevelVector<Number> marks(fine.right), coarse_marks(coarse.right);
    for (const unsigned int entry : fine.prescribed)
      marks.local_element(entry) = 1.;
    fine.transfer.inject_to(coarse_marks, marks);
    for (unsigned int i = 0; i < coarse_marks.locally_owned_size(); ++i)
      if (coarse_marks.local_element(i) > 0)
        coarse.prescribed.push_back(i);

    if (field == Field::displacement)
      return;
    LevelVector<Number> exchange(fine.exchange);
    if (is_finest)
      {
        // row sums of K + kB, of which those of K are zero
        Vector ones(body.discretization.make_vector(field)), sums(ones);
        ones = 1.;
        body.equations.conduction.vmult(sums, ones);
        for (unsigned int i = 0; i < sums.locally_owned_size(); ++i)
          if (sums.local_element(i) >
              Tolerances::rounding_of_data * fine.stiffness.local_element(i))
            exchange.local_element(i) = sums.local_element(i);
      }
    fine.transfer.restrict_to(coarse.exchange, exchange, true);
  }



  template class MultigridLevels<2, float>;
  template class MultigridLevels<2, double>;
  template class MultigridLevels<3, float>;
  template class MultigridLevels<3, double>;
} // namespace ThermoContact
