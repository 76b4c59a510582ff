// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/contact_cells.h>
#include <thermocontact/space/lateral_exchange.h>
#include <thermocontact/space/massless_contact.h>
#include <thermocontact/space/matrix_free_spaces.h>

#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

#include <numeric>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Nodes of a cell, by their numbers in FE_Q. */
    template <int dim>
    std::vector<unsigned int>
    nodes_of_face(const Discretization<dim> &space,
                  const unsigned int         component,
                  const unsigned int         face)
    {
      const FiniteElement<dim> &fe = space.finite_element();
      std::vector<unsigned int> nodes;
      for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
        if (fe.system_to_component_index(i).first == component &&
            fe.has_support_on_face(i, face))
          nodes.push_back(fe.system_to_component_index(i).second);
      return nodes;
    }



    /** $\int\varphi_i\varphi_j$ of a component between nodes of a cell. */
    template <int dim>
    FullMatrix<double>
    mass_between(const Discretization<dim>       &space,
                 const std::vector<unsigned int> &nodes,
                 const unsigned int               component,
                 const FEValuesBase<dim>         &values,
                 const double                     factor)
    {
      const FiniteElement<dim> &fe = space.finite_element();
      FullMatrix<double>        matrix(nodes.size(), nodes.size());
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int j = 0; j < nodes.size(); ++j)
          for (const unsigned int q : values.quadrature_point_indices())
            matrix(i, j) +=
              factor *
              values.shape_value(fe.component_to_system_index(component,
                                                              nodes[i]),
                                 q) *
              values.shape_value(fe.component_to_system_index(component,
                                                              nodes[j]),
                                 q) *
              space.geometry().weight(values, q);
      return matrix;
    }
  } // namespace



  template <int dim>
  ContactCells<dim>::ContactCells(const Scene               &scene,
                                  const Discretization<dim> &discretization)
  {
    const MatrixFree<dim>     &cells  = discretization.matrix_free().cells();
    const unsigned int         degree = discretization.degree();
    const FiniteElement<dim>  &fe     = discretization.finite_element();
    const LateralExchange<dim> lateral(scene, discretization);
    const UpdateFlags          flags =
      update_values | update_quadrature_points | update_JxW_values;
    FEFaceValues<dim> face_values(discretization.mapping(),
                                  fe,
                                  QGauss<dim - 1>(degree + 1),
                                  flags);
    FEValues<dim>     massless_values(
      discretization.mapping(),
      fe,
      massless_quadrature<dim>(degree, scene.has_lumped_mass),
      flags);
    const std::vector<unsigned int> lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim>(degree);
    const auto matrix_of = [&](const unsigned int          lane,
                               std::vector<unsigned int> &&nodes,
                               const Field::Block          field,
                               const FEValuesBase<dim>    &values,
                               const double                factor) {
      FullMatrix<double> matrix =
        mass_between(discretization,
                     nodes,
                     discretization.first_component(field),
                     values,
                     factor);
      for (unsigned int &node : nodes)
        node = lexicographic[node];
      return CellMatrix{lane, std::move(nodes), std::move(matrix)};
    };

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
          const auto add_face = [&](const unsigned int face,
                                    const double       factor,
                                    Matrices          &matrices) {
            face_values.reinit(cell, face);
            matrices[batch].push_back(matrix_of(
              lane,
              nodes_of_face(discretization,
                            discretization.first_component(Field::temperature),
                            face),
              Field::temperature,
              face_values,
              factor));
          };
          if (scene.heat.has_lateral_exchange())
            for (const unsigned int f : cell->face_indices())
              if (lateral.acts_on(cell->face(f)))
                add_face(f, lateral.coefficient(), lateral_exchange);
          if (!touches_contact_end<dim>(cell))
            continue;
          is_at_end[batch] = true;
          if (scene.fields.has_temperature)
            add_face(contact_face<dim>(cell),
                     scene.heat.linear_coefficient(),
                     heat_exchange);
          if (scene.contact.has_massless_nodes)
            {
              std::vector<unsigned int> all(lexicographic.size());
              std::iota(all.begin(), all.end(), 0);
              massless_values.reinit(cell);
              axial_mass[batch].push_back(matrix_of(lane,
                                                    std::move(all),
                                                    Field::displacement,
                                                    massless_values,
                                                    1.));
            }
        }
  }



  template <int dim>
  void
  ContactCells<dim>::add(const std::vector<CellMatrix> &matrices,
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
    for (const CellMatrix &of_cell : axial_mass[batch])
      share[of_cell.lane] = 0.;
    return share;
  }



  template class ContactCells<2>;
  template class ContactCells<3>;
} // namespace ThermoContact
