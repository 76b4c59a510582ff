// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/contact_cells.h>
#include <thermocontact/space/massless_contact.h>
#include <thermocontact/space/matrix_free_spaces.h>

#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

namespace ThermoContact
{
  namespace
  {
    /** Adds $\int\varphi_i\varphi_j$ of a component, in lexicographic order. */
    template <int dim>
    void
    add_mass(const Discretization<dim>       &discretization,
             const std::vector<unsigned int> &lexicographic,
             const unsigned int               component,
             const FEValuesBase<dim>         &values,
             const double                     factor,
             FullMatrix<double>              &matrix)
    {
      const FiniteElement<dim> &fe = discretization.finite_element();
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          {
            const unsigned int first =
                                 fe.component_to_system_index(component, i),
                               second =
                                 fe.component_to_system_index(component, j);
            for (const unsigned int q : values.quadrature_point_indices())
              matrix(lexicographic[i], lexicographic[j]) +=
                factor * values.shape_value(first, q) *
                values.shape_value(second, q) *
                discretization.geometry().weight(values, q);
          }
    }
  } // namespace



  template <int dim>
  ContactCells<dim>::ContactCells(const Scene               &scene,
                                  const Discretization<dim> &discretization)
    : n_nodes(Utilities::fixed_power<dim>(discretization.degree() + 1))
  {
    const MatrixFree<dim> &cells = discretization.matrix_free().cells();
    std::vector<typename DoFHandler<dim>::active_cell_iterator> cells_at_end;
    cells_of_batch.resize(cells.n_cell_batches());
    for (unsigned int batch = 0; batch < cells_of_batch.size(); ++batch)
      for (unsigned int lane = 0;
           lane < cells.n_active_entries_per_cell_batch(batch);
           ++lane)
        {
          const auto field_cell = cells.get_cell_iterator(batch, lane);
          const typename DoFHandler<dim>::active_cell_iterator cell(
            &discretization.dof_handler().get_triangulation(),
            field_cell->level(),
            field_cell->index(),
            &discretization.dof_handler());
          if (!touches_contact_end<dim>(cell))
            continue;
          const unsigned int n = cells_at_end.size();
          cells_of_batch[batch].push_back({lane, n});
          cells_at_end.push_back(cell);
        }
    compute_matrices(scene, discretization, cells_at_end);
  }



  template <int dim>
  void
  ContactCells<dim>::compute_matrices(
    const Scene                                                       &scene,
    const Discretization<dim>                                         &space,
    const std::vector<typename DoFHandler<dim>::active_cell_iterator> &cells)
  {
    const unsigned int              degree = space.degree();
    const FiniteElement<dim>       &fe     = space.finite_element();
    const std::vector<unsigned int> lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim>(degree);
    const UpdateFlags flags =
      update_values | update_quadrature_points | update_JxW_values;
    const bool        is_lumped = scene.has_lumped_mass;
    FEFaceValues<dim> face_values(space.mapping(),
                                  fe,
                                  QGauss<dim - 1>(degree + 1),
                                  flags);
    FEValues<dim>     massless_values(space.mapping(),
                                  fe,
                                  massless_quadrature<dim>(degree, is_lumped),
                                  flags);
    for (const auto &cell : cells)
      {
        if (scene.fields.has_temperature)
          {
            face_values.reinit(cell, contact_face<dim>(cell));
            add_mass(space,
                     lexicographic,
                     space.first_component(Field::temperature),
                     face_values,
                     scene.heat.linear_coefficient(),
                     heat_exchange.emplace_back(n_nodes, n_nodes));
          }
        if (scene.contact.has_massless_nodes)
          {
            const unsigned int axial =
              space.first_component(Field::displacement);
            FullMatrix<double> &matrix =
              axial_mass.emplace_back(n_nodes, n_nodes);
            massless_values.reinit(cell);
            add_mass(space, lexicographic, axial, massless_values, 1., matrix);
          }
      }
  }



  template <int dim>
  void
  ContactCells<dim>::add(const FullMatrix<double>      &matrix,
                         const double                   factor,
                         const unsigned int             lane,
                         const VectorizedArray<double> *x,
                         VectorizedArray<double>       *y) const
  {
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        double sum = 0.;
        for (unsigned int j = 0; j < n_nodes; ++j)
          sum += matrix(i, j) * x[j][lane];
        y[i][lane] += factor * sum;
      }
  }



  template <int dim>
  void
  ContactCells<dim>::add_heat_exchange(const unsigned int             batch,
                                       const double                   factor,
                                       const VectorizedArray<double> *x,
                                       VectorizedArray<double>       *y) const
  {
    for (const Cell &cell : cells_of_batch[batch])
      add(heat_exchange[cell.matrix], factor, cell.lane, x, y);
  }



  template <int dim>
  VectorizedArray<double>
  ContactCells<dim>::share_of_axial_mass(const unsigned int batch) const
  {
    VectorizedArray<double> share = 1.;
    if (!axial_mass.empty())
      for (const Cell &cell : cells_of_batch[batch])
        share[cell.lane] = 0.;
    return share;
  }



  template <int dim>
  void
  ContactCells<dim>::add_axial_mass(const unsigned int             batch,
                                    const double                   factor,
                                    const VectorizedArray<double> *x,
                                    VectorizedArray<double>       *y) const
  {
    if (axial_mass.empty())
      return;
    for (const Cell &cell : cells_of_batch[batch])
      add(axial_mass[cell.matrix], factor, cell.lane, x, y);
  }



  template class ContactCells<2>;
  template class ContactCells<3>;
} // namespace ThermoContact
