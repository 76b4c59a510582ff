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
    coarser_grids(const MeshParameters &mesh)
    {
      const LevelGrid<dim>        body(mesh);
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



    unsigned int
    n_components(const Field::Block field, const unsigned int dim)
    {
      return field == Field::temperature ? 1 : dim;
    }



    template <int dim>
    std::vector<NodalValue<dim>>
    nodal_values(const LevelGrid<dim> &grid, const Field::Block field)
    {
      std::vector<NodalValue<dim>> values;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        for (unsigned int c = 0; c < n_components(field, dim); ++c)
          values.push_back({c, grid.node(grid.index(i))});
      return values;
    }
  } // namespace



  template <int dim, typename Number>
  MultigridLevels<dim, Number>::MultigridLevels(const Body<dim> &body)
    : body(body)
  {
    const Discretization<dim>        &space = body.discretization;
    const std::vector<LevelGrid<dim>> grids =
      coarser_grids<dim>(body.scene.parameters.mesh);
    coarse_matrix_ =
      std::make_unique<const LevelMatrix<dim, double>>(body.scene,
                                                       space.geometry(),
                                                       grids[0]);
    for (const LevelGrid<dim> &grid : grids)
      {
        auto matrix =
          std::make_unique<const LevelMatrix<dim, Number>>(body.scene,
                                                           space.geometry(),
                                                           grid);
        levels.emplace_back();
        for (const Field::Block field : all_fields)
          if (space.has_field(field))
            make_field(*matrix, grid, field, levels.back().fields[field]);
        levels.back().products = std::move(matrix);
      }
    auto products =
      std::make_unique<const CellProducts<dim, Number>>(body.scene, space);
    levels.emplace_back();
    for (const Field::Block field : all_fields)
      if (space.has_field(field))
        {
          make_field_of_body(*products, field, levels.back().fields[field]);
          for (unsigned int l = grids.size(); l > 0; --l)
            connect(grids[l - 1],
                    l == grids.size() ? space.nodal_values(field) :
                                        nodal_values(grids[l], field),
                    l,
                    field);
        }
    levels.back().products = std::move(products);
  }



  namespace
  {
    template <int dim, typename Number>
    void
    make_vectors(const LevelOperator<Number> &products,
                 const Field::Block           field,
                 LevelField<dim, Number>     &of_field)
    {
      for (LevelVector<Number> *vector : {&of_field.mass,
                                          &of_field.stiffness,
                                          &of_field.right,
                                          &of_field.solution,
                                          &of_field.residual,
                                          &of_field.update})
        *vector = products.make_vector(field);
      if (field == Field::temperature)
        of_field.exchange = of_field.right;
    }
  } // namespace



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::make_field(
    const LevelMatrix<dim, Number> &matrix,
    const LevelGrid<dim>           &grid,
    const Field::Block              field,
    LevelField<dim, Number>        &of_field) const
  {
    make_vectors(matrix, field, of_field);
    for (const bool is_mass : {true, false})
      matrix.visit_entries(
        field,
        is_mass,
        !is_mass,
        [&](const unsigned int row,
            const unsigned int column,
            const Number       value) {
          if (row == column)
            (is_mass ? of_field.mass : of_field.stiffness).local_element(row) =
              value;
        });
    if (field == Field::displacement && has_subspaces())
      of_field.subspaces =
        make_subspaces(grid, nodal_values(grid, field), of_field);
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::make_field_of_body(
    const CellProducts<dim, Number> &products,
    const Field::Block               field,
    LevelField<dim, Number>         &of_field) const
  {
    make_vectors(products, field, of_field);
    of_field.mass       = products.diagonal(field, 1., 0.);
    of_field.stiffness  = products.diagonal(field, 0., 1.);
    of_field.prescribed = body.discretization.constrained_entries(field);
    if (field == Field::displacement && has_subspaces())
      of_field.subspaces =
        make_subspaces(LevelGrid<dim>(body.scene.parameters.mesh),
                       body.discretization.nodal_values(field),
                       of_field);
  }



  template <int dim, typename Number>
  std::unique_ptr<const LevelSubspaces<dim, Number>>
  MultigridLevels<dim, Number>::make_subspaces(
    const LevelGrid<dim>               &grid,
    const std::vector<NodalValue<dim>> &values,
    const LevelField<dim, Number>      &of_field) const
  {
    return std::make_unique<const LevelSubspaces<dim, Number>>(
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
                         n_components(field, dim),
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
    fine.transfer.restrict_diagonal_to(coarse.exchange, exchange);
  }



  template class MultigridLevels<2, float>;
  template class MultigridLevels<2, double>;
  template class MultigridLevels<3, float>;
  template class MultigridLevels<3, double>;
} // namespace ThermoContact
