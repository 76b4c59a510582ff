// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
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
    /** Values of the nodes of a batch, components behind each other. */
    template <int n_components, typename Number>
    inline void
    gather(const Number       *x,
           const unsigned int *positions,
           const unsigned int *strides,
           const unsigned int  n_nodes,
           Lanes<Number>      *values)
    {
      constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          {
            Lanes<Number> value{};
            for (unsigned int lane = 0; lane < n_lanes; ++lane)
              value.data[lane] =
                x[positions[i * n_lanes + lane] + c * strides[i]];
            values[c * n_nodes + i] = value;
          }
    }



    /** Adds those of the first @p n_cells lanes. */
    template <int n_components, typename Number>
    inline void
    scatter(const Lanes<Number> *values,
            const unsigned int  *positions,
            const unsigned int  *strides,
            const unsigned int   n_nodes,
            const unsigned int   n_cells,
            Number              *y)
    {
      constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;
      const auto add = [&](const unsigned int i, const unsigned int lane) {
        for (unsigned int c = 0; c < n_components; ++c)
          y[positions[i * n_lanes + lane] + c * strides[i]] +=
            values[c * n_nodes + i].data[lane];
      };
      if (n_cells == n_lanes)
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            add(i, lane);
      else
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int lane = 0; lane < n_cells; ++lane)
            add(i, lane);
    }



    /** Names for parts of a scratch array, one array of a cell each. */
    template <int dim, typename Number>
    std::array<std::array<Lanes<Number> *, dim>, dim>
    gradients_in(Lanes<Number> *scratch, const unsigned int n_nodes)
    {
      std::array<std::array<Lanes<Number> *, dim>, dim> gradients;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          gradients[c][d] = scratch + (c * dim + d) * n_nodes;
      return gradients;
    }



    /** What a point contributes to the momentum, with its factors. */
    template <typename Number>
    struct MomentumPoint
    {
      Lanes<Number> mass[3];
      Lanes<Number> mu;
      Lanes<Number> lambda;
      Lanes<Number> hoop; ///< strain per displacement along y
    };



    /**
     * Replaces displacement and gradient at a quadrature point by what the test
     * functions and their derivatives are multiplied by.
     */
    template <int dim, bool is_radial, typename Number>
    inline __attribute__((always_inline)) void
    momentum_at_point(
      const MomentumPoint<Number>                             &point,
      const Lanes<Number>                                     *inverse_size,
      const std::array<Lanes<Number> *, dim>                  &u,
      const std::array<std::array<Lanes<Number> *, dim>, dim> &gradient,
      const unsigned int                                       q)
    {
      Lanes<Number> e[dim][dim];
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          e[c][d] = gradient[c][d][q] * inverse_size[d];
      Lanes<Number> dilatation = e[0][0] + e[1][1];
      if constexpr (dim == 3)
        dilatation += e[2][2];
      const Lanes<Number> strain =
        is_radial ? point.hoop * u[1][q] : Lanes<Number>{};
      if constexpr (is_radial)
        dilatation += strain;
      const Lanes<Number> pressure = point.lambda * dilatation;
      for (unsigned int c = 0; c < dim; ++c)
        u[c][q] *= point.mass[c];
      if constexpr (is_radial)
        u[1][q] += point.hoop * (point.mu * (strain + strain) + pressure);
      for (unsigned int c = 0; c < dim; ++c)
        {
          gradient[c][c][q] =
            (point.mu * (e[c][c] + e[c][c]) + pressure) * inverse_size[c];
          for (unsigned int d = c + 1; d < dim; ++d)
            {
              const Lanes<Number> shear = point.mu * (e[c][d] + e[d][c]);
              gradient[c][d][q]         = shear * inverse_size[d];
              gradient[d][c][q]         = shear * inverse_size[c];
            }
        }
    }
  } // namespace



  template <int dim, typename Number>
  template <int n_static>
  void
  LevelProducts<dim, Number>::heat_on_cells(const double         mass,
                                            const double         conduction,
                                            LevelVector<Number> &y,
                                            const LevelVector<Number> &x) const
  {
    using Batched              = Lanes<Number>;
    const int          n_line  = n_static > 0 ? n_static : int(n);
    const unsigned int n_point = power_of(n_line, dim);
    const FieldCells  &cells   = fields[Field::temperature];
    Batched           *theta   = reinterpret_cast<Batched *>(scratch.begin());
    const std::array<Batched *, dim> gradient =
      gradients_in<dim>(theta + n_point, n_point)[0];
    const Batched *points    = Batched::in(weights.begin());
    const Number   mass_part = has_lumped_mass ? 0. : mass;
    const Number   flow_part = conduction;
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        const Batch        &batch = batches[b];
        const unsigned int *positions =
          cells.positions.data() + b * n_point * n_lanes;
        gather<1>(x.begin(), positions, strides.data(), n_point, theta);
        apply_along_all<dim, n_static>(Batched::in(values.begin()),
                                       theta,
                                       n_line);
        differentiate<dim, n_static>(Batched::in(derivatives.begin()),
                                     theta,
                                     gradient,
                                     n_line);
        const Batched  volume = *Batched::in(batch.volume.data());
        const Batched *radii  = Batched::in(radial.begin()) + 2 * b * n_line;
        Batched        factor[dim];
        for (unsigned int d = 0; d < dim; ++d)
          {
            factor[d] = *Batched::in(batch.inverse_size[d].data());
            factor[d] *= factor[d] * flow_part;
          }
        for (unsigned int q = 0; q < n_point; ++q)
          {
            Batched weight = points[q] * volume;
            if (!radial.empty())
              weight *= radii[2 * (q / n_line)];
            theta[q] *= weight * mass_part;
            for (unsigned int d = 0; d < dim; ++d)
              gradient[d][q] *= weight * factor[d];
          }
        add_transposed<dim, n_static>(
          Batched::in(derivatives_transposed.begin()), gradient, theta, n_line);
        apply_along_all<dim, n_static>(Batched::in(values_transposed.begin()),
                                       theta,
                                       n_line);
        scatter<1>(
          theta, positions, strides.data(), n_point, batch.n_cells, y.begin());
      }
  }



  template <int dim, typename Number>
  template <int n_static, bool is_radial>
  void
  LevelProducts<dim, Number>::momentum_on_cells(
    const double               mass,
    const double               stiffness,
    LevelVector<Number>       &y,
    const LevelVector<Number> &x) const
  {
    using Batched                = Lanes<Number>;
    const int          n_line    = n_static > 0 ? n_static : int(n);
    const unsigned int n_point   = power_of(n_line, dim);
    const FieldCells  &cells     = fields[Field::displacement];
    Batched           *values_at = reinterpret_cast<Batched *>(scratch.begin());
    std::array<Batched *, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = values_at + c * n_point;
    const auto     gradient  = gradients_in<dim>(u[0] + dim * n_point, n_point);
    const Batched *points    = Batched::in(weights.begin());
    const Number   mass_part = has_lumped_mass ? 0. : mass;
    const Number   mu        = 0.5 * stiffness * material.two_mu;
    const Number   lambda    = stiffness * material.lambda;
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        const Batch        &batch = batches[b];
        const unsigned int *positions =
          cells.positions.data() + b * n_point * n_lanes;
        gather<dim>(x.begin(), positions, strides.data(), n_point, values_at);
        for (unsigned int c = 0; c < dim; ++c)
          {
            apply_along_all<dim, n_static>(Batched::in(values.begin()),
                                           u[c],
                                           n_line);
            differentiate<dim, n_static>(Batched::in(derivatives.begin()),
                                         u[c],
                                         gradient[c],
                                         n_line);
          }
        const Batched  volume = *Batched::in(batch.volume.data());
        const Batched *radii  = Batched::in(radial.begin()) + 2 * b * n_line;
        Batched        inverse_size[dim];
        for (unsigned int d = 0; d < dim; ++d)
          inverse_size[d] = *Batched::in(batch.inverse_size[d].data());
        for (unsigned int q = 0; q < n_point; ++q)
          {
            Batched weight = points[q] * volume;
            if constexpr (is_radial)
              weight *= radii[2 * (q / n_line)];
            MomentumPoint<Number> point;
            point.mass[0] = weight * (batch.has_axial_mass ? mass_part : 0);
            point.mass[1] = point.mass[2] = weight * mass_part;
            point.mu                      = weight * mu;
            point.lambda                  = weight * lambda;
            if constexpr (is_radial)
              point.hoop = radii[2 * (q / n_line) + 1];
            momentum_at_point<dim, is_radial>(
              point, inverse_size, u, gradient, q);
          }
        for (unsigned int c = 0; c < dim; ++c)
          {
            add_transposed<dim, n_static>(Batched::in(
                                            derivatives_transposed.begin()),
                                          gradient[c],
                                          u[c],
                                          n_line);
            apply_along_all<dim, n_static>(
              Batched::in(values_transposed.begin()), u[c], n_line);
          }
        scatter<dim>(values_at,
                     positions,
                     strides.data(),
                     n_point,
                     batch.n_cells,
                     y.begin());
      }
  }



  template <int dim, typename Number>
  template <int n_static>
  void
  LevelProducts<dim, Number>::add_cells(const Field::Block         field,
                                        const double               mass,
                                        const double               stiffness,
                                        LevelVector<Number>       &y,
                                        const LevelVector<Number> &x) const
  {
    if (field == Field::temperature)
      heat_on_cells<n_static>(mass, stiffness, y, x);
    else if (dim == 2 && !radial.empty())
      momentum_on_cells<n_static, dim == 2>(mass, stiffness, y, x);
    else
      momentum_on_cells<n_static, false>(mass, stiffness, y, x);
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::vmult(const Field::Block         field,
                                    const double               mass,
                                    const double               stiffness,
                                    LevelVector<Number>       &y,
                                    const LevelVector<Number> &x) const
  {
    const FieldCells &cells = fields[field];
    y                       = Number();
    x.update_ghost_values();
    if (n == 2)
      add_cells<2>(field, mass, stiffness, y, x);
    else if (n == 3)
      add_cells<3>(field, mass, stiffness, y, x);
    else if (n == 5)
      add_cells<5>(field, mass, stiffness, y, x);
    else
      add_cells<0>(field, mass, stiffness, y, x);
    const Number factor = field == Field::temperature ? stiffness : mass;
    for (const Entry &entry : cells.at_end)
      y.begin()[entry.row] += factor * entry.value * x.begin()[entry.column];
    x.zero_out_ghost_values();
    y.compress(VectorOperation::add);
    if (cells.lumped_mass.size() > 0)
      for (unsigned int i = 0; i < y.locally_owned_size(); ++i)
        y.local_element(i) += Number(mass) *
                              cells.lumped_mass.local_element(i) *
                              x.local_element(i);
  }



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
  std::vector<NodalValue<dim>>
  LevelProducts<dim, Number>::nodal_values(const Field::Block field) const
  {
    const DoFHandler<dim>               &handler = spaces.dof_handler(field);
    const FiniteElement<dim>            &fe      = handler.get_fe();
    std::vector<NodalValue<dim>>         result(handler.n_locally_owned_dofs());
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    for (const auto &cell : handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int j = 0; j < dofs.size(); ++j)
            if (handler.locally_owned_dofs().is_element(dofs[j]))
              {
                Point<dim> node = cell->vertex(0);
                for (unsigned int d = 0; d < dim; ++d)
                  node[d] +=
                    fe.unit_support_point(j)[d] * size_of<dim>(cell)[d];
                result[handler.locally_owned_dofs().index_within_set(dofs[j])] =
                  {fe.system_to_component_index(j).first, node};
              }
        }
    return result;
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
      [&](const Cell                      &cell,
          const std::vector<unsigned int> &nodes,
          const FullMatrix<double>        &matrix) {
        const std::vector<unsigned int> positions =
          local_positions(field, cell);
        const double rounding =
          Tolerances::rounding_of_sum * matrix.linfty_norm();
        for (unsigned int i = 0; i < nodes.size(); ++i)
          for (unsigned int j = 0; j < nodes.size(); ++j)
            if (std::abs(matrix(i, j)) > rounding)
              sums[{positions[nodes[i]], positions[nodes[j]]}] += matrix(i, j);
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
