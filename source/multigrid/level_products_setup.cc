// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/lanes.h>
#include <thermocontact/multigrid/level_products.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>

#include <cmath>
#include <map>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Appends a number for all lanes. */
    template <unsigned int n_lanes, typename Number>
    void
    append(AlignedVector<Number> &numbers, const double value)
    {
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        numbers.push_back(value);
    }



    /** Sides of a cell that is a box. */
    template <int dim>
    Tensor<1, dim>
    size_of(const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      return cell->vertex(GeometryInfo<dim>::vertices_per_cell - 1) -
             cell->vertex(0);
    }
  } // namespace



  template <int dim, typename Number>
  LevelProducts<dim, Number>::LevelProducts(
    const Scene                   &scene,
    const Discretization<dim>     &discretization,
    const MatrixFreeOperator<dim> &products)
    : spaces(discretization.matrix_free())
    , geometry(discretization.geometry())
    , material(scene.material)
    , n(discretization.degree() + 1)
    , n_nodes(Utilities::fixed_power<dim>(n))
    , has_lumped_mass(scene.has_lumped_mass)
    , scratch((dim + dim * dim) * n_nodes * n_lanes)
  {
    tabulate();
    compute_strides();
    const auto cells =
      make_batches(scene.contact.has_massless_nodes && !has_lumped_mass);
    if (!geometry.has_uniform_weight())
      compute_radial(cells);
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        {
          FieldCells  &of_field = fields[field];
          const Vector layout   = spaces.make_vector(field);
          of_field.prototype.reinit(layout.get_partitioner());
          compute_positions(field, cells);
          collect_at_end(field, products.cells_at_end());
          if (has_lumped_mass)
            {
              of_field.lumped_mass = of_field.prototype;
              copy_values(of_field.lumped_mass,
                          field == Field::temperature ?
                            products.heat_diagonal({1., 0.}) :
                            products.momentum_diagonal({1., 0.}));
            }
        }
  }



  template <int dim, typename Number>
  LevelVector<Number>
  LevelProducts<dim, Number>::make_vector(const Field::Block field) const
  {
    return fields[field].prototype;
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::tabulate()
  {
    const QGauss<1> rule(n);
    const auto      nodal = Polynomials::generate_complete_Lagrange_basis(
      QGaussLobatto<1>(n).get_points());
    const auto at_points =
      Polynomials::generate_complete_Lagrange_basis(rule.get_points());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          append<n_lanes>(values, nodal[j].value(rule.point(i)[0]));
          append<n_lanes>(values_transposed, nodal[i].value(rule.point(j)[0]));
          append<n_lanes>(derivatives,
                          at_points[j].derivative().value(rule.point(i)[0]));
          append<n_lanes>(derivatives_transposed,
                          at_points[i].derivative().value(rule.point(j)[0]));
        }
    const Quadrature<dim> of_cell(rule);
    for (const double weight : of_cell.get_weights())
      append<n_lanes>(weights, weight);
  }



  template <int dim, typename Number>
  std::vector<std::vector<typename LevelProducts<dim, Number>::Cell>>
  LevelProducts<dim, Number>::make_batches(const bool has_massless_nodes)
  {
    const MatrixFree<dim>         &mesh = spaces.cells();
    std::vector<std::vector<Cell>> cells;
    for (const bool at_end : {false, true})
      {
        const unsigned int n_before = cells.size();
        for (unsigned int b = 0; b < mesh.n_cell_batches(); ++b)
          for (unsigned int lane = 0;
               lane < mesh.n_active_entries_per_cell_batch(b);
               ++lane)
            {
              const Cell cell = mesh.get_cell_iterator(b, lane);
              if ((has_massless_nodes && touches_contact_end<dim>(cell)) !=
                  at_end)
                continue;
              if (cells.size() == n_before || cells.back().size() == n_lanes)
                cells.emplace_back();
              cells.back().push_back(cell);
            }
        for (unsigned int b = n_before; b < cells.size(); ++b)
          {
            Batch batch;
            batch.n_cells        = cells[b].size();
            batch.has_axial_mass = !at_end;
            for (unsigned int lane = 0; lane < n_lanes; ++lane)
              {
                const Tensor<1, dim> size =
                  size_of<dim>(cells[b][lane < batch.n_cells ? lane : 0]);
                batch.volume[lane] = 1.;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    batch.inverse_size[d][lane] = 1. / size[d];
                    batch.volume[lane] *= size[d];
                  }
              }
            batches.push_back(batch);
          }
      }
    return cells;
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::compute_radial(
    const std::vector<std::vector<Cell>> &cells)
  {
    const QGauss<1> rule(n);
    for (const auto &batch : cells)
      for (unsigned int q = 0; q < n; ++q)
        for (const bool is_strain : {false, true})
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            {
              const Cell &cell  = batch[lane < batch.size() ? lane : 0];
              Point<dim>  point = cell->vertex(0);
              point[1] += rule.point(q)[0] * size_of<dim>(cell)[1];
              radial.push_back(is_strain ?
                                 geometry.strain_per_displacement(point) :
                                 geometry.weight_at(point));
            }
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::compute_strides()
  {
    // a FESystem numbers the components of a vertex, line, face one by one
    const std::vector<unsigned int> lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim>(n - 1);
    const FE_Q<dim> fe(n - 1);
    strides.resize(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        const unsigned int object_dim = i < fe.get_first_line_index() ? 0U :
                                        i < fe.get_first_quad_index() ? 1U :
                                        i < fe.get_first_hex_index()  ? 2U :
                                                                        3U;
        strides[lexicographic[i]]     = power_of(n - 2, object_dim);
      }
  }



  template <int dim, typename Number>
  std::vector<unsigned int>
  LevelProducts<dim, Number>::local_positions(const Field::Block field,
                                              const Cell        &cell) const
  {
    const DoFHandler<dim>               &handler = spaces.dof_handler(field);
    const FiniteElement<dim>            &fe      = handler.get_fe();
    const LevelVector<Number>           &vector  = fields[field].prototype;
    const Cell                           of_field(&handler.get_triangulation(),
                        cell->level(),
                        cell->index(),
                        &handler);
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    of_field->get_dof_indices(dofs);
    const std::vector<unsigned int> lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim>(fe.degree);
    const auto position = [&](const unsigned int component,
                              const unsigned int node) {
      return vector.get_partitioner()->global_to_local(
        dofs[fe.component_to_system_index(component, node)]);
    };
    std::vector<unsigned int> positions(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        const unsigned int first    = position(0, i);
        positions[lexicographic[i]] = first;
        for (unsigned int c = 1; c < fe.n_components(); ++c)
          AssertThrow(position(c, i) == first + c * strides[lexicographic[i]],
                      ExcInternalError());
      }
    return positions;
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::compute_positions(
    const Field::Block                    field,
    const std::vector<std::vector<Cell>> &cells)
  {
    std::vector<unsigned int> &positions = fields[field].positions;
    for (const auto &batch : cells)
      {
        const std::size_t first = positions.size();
        positions.resize(first + n_nodes * n_lanes);
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          {
            const std::vector<unsigned int> of_cell =
              local_positions(field, batch[lane < batch.size() ? lane : 0]);
            for (unsigned int i = 0; i < n_nodes; ++i)
              positions[first + i * n_lanes + lane] = of_cell[i];
          }
      }
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::collect_at_end(
    const Field::Block       field,
    const ContactCells<dim> &contact_cells)
  {
    if (field == Field::displacement && has_lumped_mass)
      return; // in the diagonal
    std::map<std::pair<unsigned int, unsigned int>, double> sums;
    contact_cells.visit_matrices(
      field,
      spaces.cells(),
      [&](const Cell &cell, const FullMatrix<double> &matrix) {
        const std::vector<unsigned int> positions =
          local_positions(field, cell);
        const double rounding = 1e-14 * matrix.linfty_norm();
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int j = 0; j < n_nodes; ++j)
            if (std::abs(matrix(i, j)) > rounding)
              sums[{positions[i], positions[j]}] += matrix(i, j);
      });
    for (const auto &[place, value] : sums)
      fields[field].at_end.push_back(
        {place.first, place.second, Number(value)});
  }



  template class LevelProducts<2, float>;
  template class LevelProducts<2, double>;
  template class LevelProducts<3, float>;
  template class LevelProducts<3, double>;
} // namespace ThermoContact
