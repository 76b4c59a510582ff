// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/lanes.h>
#include <thermocontact/multigrid/level_products.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
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
  template <int n_along, int n_across>
  void
  LevelProducts<dim, Number>::heat_on_cells(const unsigned int b,
                                            const double       mass,
                                            const double       conduction,
                                            Batched           *theta) const
  {
    const int n_line = n_along > 0 ? n_along : sizes[0];
    const int n_point =
      n_line * power_of(n_across > 0 ? n_across : sizes[1], dim - 1);
    const std::array<Batched *, dim> gradient =
      gradients_in<dim>(theta + n_point, n_point)[0];
    apply_along_all<dim, n_along, n_across>(matrices(&Line::values),
                                            theta,
                                            sizes);
    differentiate<dim, n_along, n_across>(matrices(&Line::derivatives),
                                          theta,
                                          gradient,
                                          sizes);
    const Batch   &batch     = batches[b];
    const Batched *points    = Batched::in(weights.begin());
    const Number   mass_part = has_lumped_mass ? 0. : mass;
    const Number   flow_part = conduction;
    const Batched  volume    = *Batched::in(batch.volume.data());
    const Batched *radii     = Batched::in(radial.begin()) + 2 * b * sizes[1];
    Batched        factor[dim];
    for (unsigned int d = 0; d < dim; ++d)
      {
        factor[d] = *Batched::in(batch.inverse_size[d].data());
        factor[d] *= factor[d] * flow_part;
      }
    for (int q = 0; q < n_point; ++q)
      {
        Batched weight = points[q] * volume;
        if (!radial.empty())
          weight *= radii[2 * (q / n_line)];
        theta[q] *= weight * mass_part;
        for (unsigned int d = 0; d < dim; ++d)
          gradient[d][q] *= weight * factor[d];
      }
    add_transposed<dim, n_along, n_across>(
      matrices(&Line::derivatives_transposed), gradient, theta, sizes);
    apply_along_all<dim, n_along, n_across>(matrices(&Line::values_transposed),
                                            theta,
                                            sizes);
  }



  template <int dim, typename Number>
  template <int n_along, int n_across, bool is_radial>
  void
  LevelProducts<dim, Number>::momentum_on_cells(const unsigned int b,
                                                const double       mass,
                                                const double       stiffness,
                                                Batched *values_at) const
  {
    const int n_line = n_along > 0 ? n_along : sizes[0];
    const int n_point =
      n_line * power_of(n_across > 0 ? n_across : sizes[1], dim - 1);
    std::array<Batched *, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = values_at + c * n_point;
    const auto gradient = gradients_in<dim>(u[0] + dim * n_point, n_point);
    for (unsigned int c = 0; c < dim; ++c)
      {
        apply_along_all<dim, n_along, n_across>(matrices(&Line::values),
                                                u[c],
                                                sizes);
        differentiate<dim, n_along, n_across>(matrices(&Line::derivatives),
                                              u[c],
                                              gradient[c],
                                              sizes);
      }
    const Batch   &batch     = batches[b];
    const Batched *points    = Batched::in(weights.begin());
    const Number   mass_part = has_lumped_mass ? 0. : mass;
    const Number   mu        = 0.5 * stiffness * material.two_mu;
    const Number   lambda    = stiffness * material.lambda;
    const Batched  volume    = *Batched::in(batch.volume.data());
    const Batched *radii     = Batched::in(radial.begin()) + 2 * b * sizes[1];
    Batched        inverse_size[dim];
    for (unsigned int d = 0; d < dim; ++d)
      inverse_size[d] = *Batched::in(batch.inverse_size[d].data());
    for (int q = 0; q < n_point; ++q)
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
        momentum_at_point<dim, is_radial>(point, inverse_size, u, gradient, q);
      }
    for (unsigned int c = 0; c < dim; ++c)
      {
        add_transposed<dim, n_along, n_across>(
          matrices(&Line::derivatives_transposed), gradient[c], u[c], sizes);
        apply_along_all<dim, n_along, n_across>(
          matrices(&Line::values_transposed), u[c], sizes);
      }
  }



  template <int dim, typename Number>
  template <int n_along, int n_across>
  void
  LevelProducts<dim, Number>::add_cells(const Field::Block         field,
                                        const double               mass,
                                        const double               stiffness,
                                        LevelVector<Number>       &y,
                                        const LevelVector<Number> &x) const
  {
    Batched *values = reinterpret_cast<Batched *>(scratch.begin());
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        const unsigned int *positions =
          fields[field].positions.data() + b * n_nodes * n_lanes;
        if (field == Field::temperature)
          gather<1>(x.begin(), positions, strides.data(), n_nodes, values);
        else
          gather<dim>(x.begin(), positions, strides.data(), n_nodes, values);
        on_cells<n_along, n_across>(field, b, mass, stiffness, values);
        const unsigned int n_cells = batches[b].n_cells;
        if (field == Field::temperature)
          scatter<1>(
            values, positions, strides.data(), n_nodes, n_cells, y.begin());
        else
          scatter<dim>(
            values, positions, strides.data(), n_nodes, n_cells, y.begin());
      }
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
    const auto is = [this](const int along, const int across) {
      return sizes == LineSizes{{along, across}};
    };
    if (is(2, 2))
      add_cells<2, 2>(field, mass, stiffness, y, x);
    else if (is(3, 3))
      add_cells<3, 3>(field, mass, stiffness, y, x);
    else if (is(2, 3))
      add_cells<2, 3>(field, mass, stiffness, y, x);
    else if (is(3, 2))
      add_cells<3, 2>(field, mass, stiffness, y, x);
    else if (is(5, 5))
      add_cells<5, 5>(field, mass, stiffness, y, x);
    else
      add_cells<0, 0>(field, mass, stiffness, y, x);
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



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::visit_entries(
    const Field::Block                                             field,
    const double                                                   mass,
    const double                                                   stiffness,
    const std::function<void(unsigned int, unsigned int, Number)> &visit) const
  {
    const unsigned int n = n_nodes * (field == Field::temperature ? 1 : dim);
    Batched           *values = reinterpret_cast<Batched *>(scratch.begin());
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        const auto position = [&](const unsigned int i,
                                  const unsigned int lane) {
          const unsigned int node = i % n_nodes;
          return fields[field]
                   .positions[(b * n_nodes + node) * n_lanes + lane] +
                 i / n_nodes * strides[node];
        };
        for (unsigned int j = 0; j < n; ++j)
          {
            std::fill(values, values + n, Batched{});
            for (unsigned int lane = 0; lane < n_lanes; ++lane)
              values[j].data[lane] = 1;
            on_cells<0, 0>(field, b, mass, stiffness, values);
            for (unsigned int lane = 0; lane < batches[b].n_cells; ++lane)
              for (unsigned int i = 0; i < n; ++i)
                visit(position(i, lane),
                      position(j, lane),
                      values[i].data[lane]);
          }
      }
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



    template <int dim>
    LineSizes
    line_sizes(const LevelGrid<dim> &grid)
    {
      return {{int(grid.axis(0).degree) + 1, int(grid.axis(1).degree) + 1}};
    }



    /** The end of an axis that is nearest to a position. */
    unsigned int
    nearest_end(const GridAxis &axis, const double x)
    {
      const auto above =
        std::lower_bound(axis.ends.begin(), axis.ends.end(), x);
      const unsigned int i = above - axis.ends.begin();
      return i > 0 && (i == axis.ends.size() ||
                       x - axis.ends[i - 1] < axis.ends[i] - x) ?
               i - 1 :
               i;
    }
  } // namespace



  template <int dim, typename Number>
  LevelProducts<dim, Number>::LevelProducts(
    const Scene                   &scene,
    const Discretization<dim>     &discretization,
    const LevelGrid<dim>          &grid,
    const MatrixFreeOperator<dim> &products)
    : geometry(discretization.geometry())
    , material(scene.material)
    , grid(grid)
    , spaces(&discretization.matrix_free())
    , sizes(line_sizes(grid))
    , n_nodes(sizes[0] * power_of(sizes[1], dim - 1))
    , has_lumped_mass(scene.has_lumped_mass)
  {
    const bool has_massless_nodes =
      scene.contact.has_massless_nodes && !has_lumped_mass;
    const MatrixFree<dim> &mesh = spaces->cells();
    for (const bool at_end : {false, true})
      {
        std::vector<Box> cells;
        for (unsigned int b = 0; b < mesh.n_cell_batches(); ++b)
          for (unsigned int lane = 0;
               lane < mesh.n_active_entries_per_cell_batch(b);
               ++lane)
            {
              const Cell cell = mesh.get_cell_iterator(b, lane);
              if ((has_massless_nodes && touches_contact_end<dim>(cell)) !=
                  at_end)
                continue;
              Box box{{}, cell};
              for (unsigned int d = 0; d < dim; ++d)
                box.index[d] = nearest_end(grid.axis(d), cell->vertex(0)[d]);
              cells.push_back(box);
            }
        add_batches(cells, !at_end);
      }
    compute_strides();
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        fields[field].prototype.reinit(
          spaces->make_vector(field).get_partitioner());
    set_up();
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        {
          collect_at_end(field, products.cells_at_end());
          if (!has_lumped_mass)
            continue;
          fields[field].lumped_mass = fields[field].prototype;
          copy_values(fields[field].lumped_mass,
                      field == Field::temperature ?
                        products.heat_diagonal({1., 0.}) :
                        products.momentum_diagonal({1., 0.}));
        }
  }



  template <int dim, typename Number>
  LevelProducts<dim, Number>::LevelProducts(
    const Scene               &scene,
    const Discretization<dim> &discretization,
    const LevelGrid<dim>      &grid)
    : geometry(discretization.geometry())
    , material(scene.material)
    , grid(grid)
    , spaces(nullptr)
    , sizes(line_sizes(grid))
    , n_nodes(sizes[0] * power_of(sizes[1], dim - 1))
    , has_lumped_mass(false)
    , strides(n_nodes, 1)
  {
    std::vector<Box>   cells;
    const unsigned int n_across = grid.axis(1).n_cells();
    for (unsigned int i = 0; i < grid.axis(0).n_cells(); ++i)
      for (unsigned int j = 0; j < n_across; ++j)
        for (unsigned int k = 0; k < (dim == 3 ? n_across : 1); ++k)
          {
            Box box{{{i, j}}, {}};
            if (dim == 3)
              box.index[dim - 1] = k;
            cells.push_back(box);
          }
    add_batches(cells, true);
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        fields[field].prototype.reinit(grid.n_nodes() *
                                       (field == Field::temperature ? 1 : dim));
    set_up();
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::set_up()
  {
    scratch.resize((dim + dim * dim) * n_nodes * n_lanes);
    tabulate();
    if (!geometry.has_uniform_weight())
      compute_radial();
    for (const Field::Block field : all_fields)
      if (fields[field].prototype.size() > 0)
        {
          std::vector<unsigned int> &positions = fields[field].positions;
          positions.resize(boxes.size() * n_nodes);
          for (unsigned int box = 0; box < boxes.size(); ++box)
            {
              const std::vector<unsigned int> of_cell =
                positions_in(field, boxes[box]);
              for (unsigned int i = 0; i < n_nodes; ++i)
                positions[(box / n_lanes * n_nodes + i) * n_lanes +
                          box % n_lanes] = of_cell[i];
            }
        }
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::tabulate()
  {
    for (unsigned int direction = 0; direction < 2; ++direction)
      {
        const unsigned int n    = sizes[direction];
        Line              &line = lines[direction];
        const QGauss<1>    rule(n);
        const auto nodal = Polynomials::generate_complete_Lagrange_basis(
          QGaussLobatto<1>(n).get_points());
        const auto at_points =
          Polynomials::generate_complete_Lagrange_basis(rule.get_points());
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            {
              append<n_lanes>(line.values, nodal[j].value(rule.point(i)[0]));
              append<n_lanes>(line.values_transposed,
                              nodal[i].value(rule.point(j)[0]));
              append<n_lanes>(line.derivatives,
                              at_points[j].derivative().value(
                                rule.point(i)[0]));
              append<n_lanes>(line.derivatives_transposed,
                              at_points[i].derivative().value(
                                rule.point(j)[0]));
            }
      }
    const QGauss<1> along(sizes[0]), across(sizes[1]);
    for (unsigned int q = 0; q < n_nodes; ++q)
      {
        double weight = along.weight(q % sizes[0]);
        for (unsigned int rest = q / sizes[0], d = 1; d < dim;
             ++d, rest /= sizes[1])
          weight *= across.weight(rest % sizes[1]);
        append<n_lanes>(weights, weight);
      }
  }



  template <int dim, typename Number>
  Point<dim>
  LevelProducts<dim, Number>::corner_of(const Box &box) const
  {
    Point<dim> corner;
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] = grid.axis(d).ends[box.index[d]];
    return corner;
  }



  template <int dim, typename Number>
  Tensor<1, dim>
  LevelProducts<dim, Number>::size_of(const Box &box) const
  {
    Tensor<1, dim> size;
    for (unsigned int d = 0; d < dim; ++d)
      size[d] =
        grid.axis(d).ends[box.index[d] + 1] - grid.axis(d).ends[box.index[d]];
    return size;
  }



  template <int dim, typename Number>
  std::array<unsigned int, dim>
  LevelProducts<dim, Number>::node_index(const Box         &box,
                                         const unsigned int node) const
  {
    std::array<unsigned int, dim> index;
    unsigned int                  rest = node;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int n = sizes[d > 0];
        index[d]             = box.index[d] * (n - 1) + rest % n;
        rest /= n;
      }
    return index;
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::add_batches(const std::vector<Box> &cells,
                                          const bool has_axial_mass)
  {
    for (std::size_t first = 0; first < cells.size(); first += n_lanes)
      {
        Batch batch;
        batch.n_cells = std::min<std::size_t>(n_lanes, cells.size() - first);
        batch.has_axial_mass = has_axial_mass;
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          {
            boxes.push_back(cells[first + (lane < batch.n_cells ? lane : 0)]);
            const Tensor<1, dim> size = size_of(boxes.back());
            batch.volume[lane]        = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              {
                batch.inverse_size[d][lane] = 1. / size[d];
                batch.volume[lane] *= size[d];
              }
          }
        batches.push_back(batch);
      }
  }



  template <int dim, typename Number>
  void
  LevelProducts<dim, Number>::compute_radial()
  {
    const QGauss<1> rule(sizes[1]);
    for (std::size_t first = 0; first < boxes.size(); first += n_lanes)
      for (int q = 0; q < sizes[1]; ++q)
        for (const bool is_strain : {false, true})
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            {
              const Box &box   = boxes[first + lane];
              Point<dim> point = corner_of(box);
              point[1] += rule.point(q)[0] * size_of(box)[1];
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
    const unsigned int              n = sizes[0];
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
  LevelProducts<dim, Number>::positions_in(const Field::Block field,
                                           const Box         &box) const
  {
    if (spaces != nullptr)
      return local_positions(field, box.cell);
    std::vector<unsigned int> positions(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      positions[i] = grid.number_of_node(node_index(box, i)) *
                     (field == Field::temperature ? 1 : dim);
    return positions;
  }



  template <int dim, typename Number>
  std::vector<unsigned int>
  LevelProducts<dim, Number>::local_positions(const Field::Block field,
                                              const Cell        &cell) const
  {
    const DoFHandler<dim>               &handler = spaces->dof_handler(field);
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
  std::vector<LevelNode<dim>>
  LevelProducts<dim, Number>::nodes(const Field::Block field) const
  {
    const FieldCells           &cells = fields[field];
    std::vector<bool>           is_known(cells.prototype.locally_owned_size());
    std::vector<LevelNode<dim>> result;
    for (unsigned int box = 0; box < boxes.size(); ++box)
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          const unsigned int position =
            cells.positions[(box / n_lanes * n_nodes + i) * n_lanes +
                            box % n_lanes];
          if (position >= is_known.size() || is_known[position])
            continue;
          is_known[position] = true;
          result.push_back({position, strides[i], node_index(boxes[box], i)});
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
      spaces->cells(),
      [&](const Cell &cell, const FullMatrix<double> &matrix) {
        const std::vector<unsigned int> positions =
          local_positions(field, cell);
        const double rounding =
          Tolerances::rounding_of_sum * matrix.linfty_norm();
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
