// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/cell_matrices.h>
#include <thermocontact/space/contact_cells.h>
#include <thermocontact/space/massless_contact.h>
#include <thermocontact/space/matrix_free_spaces.h>

#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

namespace ThermoContact
{
  template <int dim>
  ContactCells<dim>::ContactCells(const Scene               &scene,
                                  const Discretization<dim> &discretization)
  {
    const MatrixFree<dim>    &cells  = discretization.matrix_free().cells();
    const unsigned int        degree = discretization.degree();
    const FiniteElement<dim> &fe     = discretization.finite_element();
    HeatExchangeFaces<dim>    faces(scene, discretization);
    FEValues<dim>             massless_values(
      discretization.mapping(),
      fe,
      massless_quadrature<dim>(degree, scene.has_lumped_mass),
      update_values | update_quadrature_points | update_JxW_values);
    const std::vector<unsigned int> lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim>(degree);
    std::vector<std::size_t> axial_dofs;
    for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
      if (fe.system_to_component_index(i).first ==
          discretization.first_component(Field::displacement))
        axial_dofs.push_back(i);

    const unsigned int n = cells.n_cell_batches();
    is_at_end.resize(n, false);
    for (Matrices *matrices : {&heat_exchange, &lateral_exchange, &axial_mass})
      matrices->resize(n);
    for (unsigned int batch = 0; batch < n; ++batch)
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
          const auto keep = [&](const CellMatrix &of_cell, Matrices &kept) {
            std::vector<unsigned int> nodes;
            for (const std::size_t dof : of_cell.dofs)
              nodes.push_back(
                lexicographic[fe.system_to_component_index(dof).second]);
            kept[batch].push_back({lane, nodes, of_cell.matrix});
          };
          faces.visit(cell,
                      [&](const CellMatrix &exchange, const bool is_lateral) {
                        keep(exchange,
                             is_lateral ? lateral_exchange : heat_exchange);
                      });
          is_at_end[batch] = is_at_end[batch] || touches_contact_end<dim>(cell);
          if (scene.contact.has_massless_nodes &&
              touches_contact_end<dim>(cell))
            {
              massless_values.reinit(cell);
              keep(
                mass_between(discretization, axial_dofs, massless_values, 1.),
                axial_mass);
            }
        }
  }



  template <int dim>
  void
  ContactCells<dim>::add(const std::vector<LaneMatrix> &matrices,
                         const double                   factor,
                         const VectorizedArray<double> *x,
                         VectorizedArray<double>       *y) const
  {
    for (const auto &[lane, nodes, matrix] : matrices)
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          double sum = 0.;
          for (unsigned int j = 0; j < nodes.size(); ++j)
            sum += matrix(i, j) * x[nodes[j]][lane];
          y[nodes[i]][lane] += factor * sum;
        }
  }



  template <int dim>
  VectorizedArray<double>
  ContactCells<dim>::share_of_axial_mass(const unsigned int batch) const
  {
    VectorizedArray<double> share = 1.;
    for (const LaneMatrix &of_cell : axial_mass[batch])
      share[of_cell.lane] = 0.;
    return share;
  }



  template class ContactCells<2>;
  template class ContactCells<3>;
} // namespace ThermoContact
