// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/discretization.h>
#include <thermocontact/space/matrix_free_spaces.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

namespace ThermoContact
{
  template <int dim>
  MatrixFreeSpaces<dim>::MatrixFreeSpaces(
    const Discretization<dim> &discretization)
    : index_{{0, discretization.has_field(Field::temperature) ? 1U : 0U}}
  {
    unconstrained.close();
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        distribute_dofs(discretization, field);
    collect_cells(discretization);
  }



  template <int dim>
  void
  MatrixFreeSpaces<dim>::distribute_dofs(
    const Discretization<dim> &discretization,
    const Field::Block         field)
  {
    const DoFHandler<dim>    &whole = discretization.dof_handler();
    const FiniteElement<dim> &fe    = discretization.finite_element();
    const unsigned int n_components = field == Field::temperature ? 1 : dim;
    DoFHandler<dim>   &handler      = handlers[field];
    handler.reinit(whole.get_triangulation());
    handler.distribute_dofs(
      FESystem<dim>(FE_Q<dim>(discretization.degree()), n_components));

    const IndexSet                      &owned = handler.locally_owned_dofs();
    std::vector<types::global_dof_index> new_numbers(owned.n_elements());
    std::vector<types::global_dof_index> dofs(handler.get_fe().dofs_per_cell);
    std::vector<types::global_dof_index> whole_dofs(fe.dofs_per_cell);
    for (const auto &cell : whole.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(whole_dofs);
          const typename DoFHandler<dim>::active_cell_iterator field_cell(
            &handler.get_triangulation(),
            cell->level(),
            cell->index(),
            &handler);
          field_cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (owned.is_element(dofs[i]))
              {
                const auto [component, node] =
                  handler.get_fe().system_to_component_index(i);
                new_numbers[owned.index_within_set(dofs[i])] =
                  whole_dofs[fe.component_to_system_index(
                    discretization.first_component(field) + component, node)] -
                  discretization.first_dof(field);
              }
        }
    handler.renumber_dofs(new_numbers);

    const IndexSet &relevant = discretization.relevant_by_block()[field];
    constraints_[field].reinit(relevant);
    for (const types::global_dof_index dof : relevant)
      if (discretization.constraints().is_constrained(
            dof + discretization.first_dof(field)))
        constraints_[field].add_line(dof);
    constraints_[field].close();
  }



  template <int dim>
  void
  MatrixFreeSpaces<dim>::collect_cells(
    const Discretization<dim> &discretization)
  {
    typename MatrixFree<dim>::AdditionalData data;
    data.tasks_parallel_scheme =
      MatrixFree<dim>::AdditionalData::TasksParallelScheme::none;
    data.mapping_update_flags =
      update_values | update_gradients | update_JxW_values;
    // 3 numbers to a point, which is a lot
    if (!discretization.geometry().has_uniform_weight())
      data.mapping_update_flags |= update_quadrature_points;
    std::vector<const DoFHandler<dim> *>           used;
    std::vector<const AffineConstraints<double> *> constraints;
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        {
          used.push_back(&handlers[field]);
          constraints.push_back(&unconstrained);
        }
    const unsigned int               degree = discretization.degree();
    const std::vector<Quadrature<1>> rules{QGauss<1>(degree + 1),
                                           QGaussLobatto<1>(degree + 1)};
    cells_.reinit(discretization.mapping(), used, constraints, rules, data);
  }



  template <int dim>
  Vector
  MatrixFreeSpaces<dim>::make_vector(const Field::Block field) const
  {
    Vector vector;
    cells_.initialize_dof_vector(vector, index(field));
    return vector;
  }



  template class MatrixFreeSpaces<2>;
  template class MatrixFreeSpaces<3>;
} // namespace ThermoContact
