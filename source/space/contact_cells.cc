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
    : nodes_along(discretization.degree() + 1)
    , extension(scene.has_elastic_contact_nodes() ?
                  extension_from_other_nodes(discretization.degree()) :
                  std::vector<double>())
  {
    const FiniteElement<dim> &fe     = discretization.finite_element();
    const unsigned int        degree = discretization.degree();
    n_nodes                          = Utilities::fixed_power<dim>(nodes_along);
    const std::vector<unsigned int> lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim>(degree);
    const UpdateFlags flags =
      update_values | update_quadrature_points | update_JxW_values;
    FEFaceValues<dim> face_values(discretization.mapping(),
                                  fe,
                                  QGauss<dim - 1>(degree + 1),
                                  flags);
    FEValues<dim>     mass_values(discretization.mapping(),
                              fe,
                              mass_quadrature<dim>(degree,
                                                   scene.has_lumped_mass),
                              flags);
    FEValues<dim>     massless_values(
      discretization.mapping(),
      fe,
      massless_quadrature<dim>(degree, scene.has_lumped_mass),
      flags);

    const MatrixFree<dim> &cells = discretization.matrix_free().cells();
    cells_of_batch.resize(cells.n_cell_batches());
    unsigned int n_matrices = 0;
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
          cells_of_batch[batch].push_back({lane, n_matrices++});
          if (scene.fields.has_temperature)
            {
              face_values.reinit(cell, contact_face<dim>(cell));
              add_mass(discretization,
                       lexicographic,
                       discretization.first_component(Field::temperature),
                       face_values,
                       scene.heat.coefficient,
                       heat_exchange.emplace_back(n_nodes, n_nodes));
            }
          if (scene.contact.has_massless_nodes)
            {
              FullMatrix<double> &matrix =
                missing_mass.emplace_back(n_nodes, n_nodes);
              const unsigned int axial =
                discretization.first_component(Field::displacement);
              mass_values.reinit(cell);
              massless_values.reinit(cell);
              add_mass(
                discretization, lexicographic, axial, mass_values, -1., matrix);
              add_mass(discretization,
                       lexicographic,
                       axial,
                       massless_values,
                       1.,
                       matrix);
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
  void
  ContactCells<dim>::add_missing_mass(const unsigned int             batch,
                                      const double                   factor,
                                      const VectorizedArray<double> *x,
                                      VectorizedArray<double>       *y) const
  {
    if (missing_mass.empty())
      return;
    for (const Cell &cell : cells_of_batch[batch])
      add(missing_mass[cell.matrix], factor, cell.lane, x, y);
  }



  template <int dim>
  void
  ContactCells<dim>::extend(const unsigned int       batch,
                            VectorizedArray<double> *values) const
  {
    for (const Cell &cell : cells_of_batch[batch])
      for (unsigned int line = 0; line < n_nodes; line += nodes_along)
        {
          double value = 0.;
          for (unsigned int k = 0; k + 1 < nodes_along; ++k)
            value += extension[k] * values[line + k][cell.lane];
          values[line + nodes_along - 1][cell.lane] = value;
        }
  }



  template <int dim>
  void
  ContactCells<dim>::restrict_to_others(const unsigned int       batch,
                                        VectorizedArray<double> *values) const
  {
    for (const Cell &cell : cells_of_batch[batch])
      for (unsigned int line = 0; line < n_nodes; line += nodes_along)
        {
          double &at_end = values[line + nodes_along - 1][cell.lane];
          for (unsigned int k = 0; k + 1 < nodes_along; ++k)
            values[line + k][cell.lane] += extension[k] * at_end;
          at_end = 0.;
        }
  }



  template class ContactCells<2>;
  template class ContactCells<3>;
} // namespace ThermoContact
