// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/cell_shape.h>
#include <thermocontact/space/massless_contact.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

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
           Lanes<Number>      *values,
           const unsigned int  first_component = 0)
    {
      constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          {
            Lanes<Number> value{};
            for (unsigned int lane = 0; lane < n_lanes; ++lane)
              value.data[lane] = x[positions[i * n_lanes + lane] +
                                   (first_component + c) * strides[i]];
            values[c * n_nodes + i] = value;
          }
    }



    /** Adds the values of the first @p n_cells lanes. */
    template <int n_components, typename Number>
    inline void
    scatter(const Lanes<Number> *values,
            const unsigned int  *positions,
            const unsigned int  *strides,
            const unsigned int   n_nodes,
            const unsigned int   n_cells,
            Number              *y,
            const unsigned int   first_component = 0)
    {
      constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;
      const auto add = [&](const unsigned int i, const unsigned int lane) {
        for (unsigned int c = 0; c < n_components; ++c)
          y[positions[i * n_lanes + lane] +
            (first_component + c) * strides[i]] +=
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



    /** The values of a point of the cells of a batch. */
    template <int dim, typename Number>
    struct CellPoint
    {
      Lanes<Number> inverse_size[dim];
      bool          has_axial_mass;
      Lanes<Number> weight{};
      Lanes<Number> hoop{}; ///< strain per displacement along y
    };

    template <int dim, typename Number>
    using CellValues = std::array<Lanes<Number> *, dim>;

    template <int dim, typename Number>
    using CellGradients = std::array<CellValues<dim, Number>, dim>;



    /**
     * Replaces displacement and gradient at a quadrature point by what the test
     * functions and their derivatives are multiplied by.
     */
    template <int dim, typename Number>
    inline __attribute__((always_inline)) void
    momentum_at_point(const CellPoint<dim, Number>     &point,
                      const Number                      mass,
                      const Number                      mu_,
                      const Number                      lambda,
                      const bool                        is_radial,
                      const CellValues<dim, Number>    &u,
                      const CellGradients<dim, Number> &gradient,
                      const unsigned int                q)
    {
      const Lanes<Number> mu = point.weight * mu_;
      Lanes<Number>       e[dim][dim];
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          e[c][d] = gradient[c][d][q] * point.inverse_size[d];
      Lanes<Number> dilatation = e[0][0] + e[1][1];
      if constexpr (dim == 3)
        dilatation += e[2][2];
      const Lanes<Number> strain = point.hoop * u[1][q];
      if (is_radial)
        dilatation += strain;
      const Lanes<Number> pressure = point.weight * lambda * dilatation;
      for (unsigned int c = 0; c < dim; ++c)
        u[c][q] *= point.weight * (c > 0 || point.has_axial_mass ? mass : 0);
      if (is_radial)
        u[1][q] += point.hoop * (mu * (strain + strain) + pressure);
      for (unsigned int c = 0; c < dim; ++c)
        {
          gradient[c][c][q] =
            (mu * (e[c][c] + e[c][c]) + pressure) * point.inverse_size[c];
          for (unsigned int d = c + 1; d < dim; ++d)
            {
              const Lanes<Number> shear = mu * (e[c][d] + e[d][c]);
              gradient[c][d][q]         = shear * point.inverse_size[d];
              gradient[d][c][q]         = shear * point.inverse_size[c];
            }
        }
    }
  } // namespace



  template <int dim, typename Number>
  template <int                                             n_static,
            int                                             n_from,
            typename CellProducts<dim, Number>::Derivatives of_from,
            int                                             n_to,
            typename CellProducts<dim, Number>::Derivatives of_to,
            typename AtPoint>
  void
  CellProducts<dim, Number>::sum_over_cells(const Operator             op,
                                            const Factors             &factors,
                                            LevelVector<Number>       &y,
                                            const LevelVector<Number> &x,
                                            const AtPoint &at_point) const
  {
    using Batched                = Lanes<Number>;
    const int          n_line    = n_static > 0 ? n_static : int(n);
    const unsigned int n_point   = power_of(n_line, dim);
    Batched           *values_at = reinterpret_cast<Batched *>(scratch.begin());
    const auto         in        = [](const AlignedVector<Number> &matrix) {
      return Batched::in(matrix.begin());
    };
    CellValues<dim, Number>    u;
    CellGradients<dim, Number> gradient;
    for (unsigned int c = 0; c < dim; ++c)
      {
        u[c] = values_at + c * n_point;
        for (unsigned int d = 0; d < dim; ++d)
          gradient[c][d] = values_at + ((c + 1) * dim + d) * n_point;
      }
    const Field::Block from = n_from == 1 ? factors.field : Field::displacement;
    const Field::Block to   = n_to == 1 ? factors.field : Field::displacement;
    const bool         is_radial = dim == 2 && is_weighted(op);
    for (unsigned int b = factors.is_at_end ? first_at_end : 0;
         b < batches.size();
         ++b)
      {
        const Batch      &batch = batches[b];
        const std::size_t first = std::size_t(b) * n_point * n_lanes;
        gather<n_from>(x.begin(),
                       &fields[from].positions[first],
                       strides.data(),
                       n_point,
                       values_at,
                       factors.component);
        for (int c = 0; c < n_from; ++c)
          {
            apply_along_all<dim, n_static>(in(values), u[c], n_line);
            if constexpr (of_from == Derivatives::all)
              differentiate<dim, n_static>(in(derivatives),
                                           u[c],
                                           gradient[c],
                                           n_line);
          }
        if constexpr (of_from == Derivatives::own)
          along_all<n_from>([&](const auto number) {
            constexpr int c = decltype(number)::value;
            apply_along<dim, c, n_static, false>(in(derivatives),
                                                 u[c],
                                                 gradient[c][c],
                                                 n_line);
          });
        CellPoint<dim, Number> point;
        point.has_axial_mass = batch.has_axial_mass;
        for (unsigned int d = 0; d < dim; ++d)
          point.inverse_size[d] = *Batched::in(batch.inverse_size[d].data());
        const Batched  volume = *Batched::in(batch.volume.data());
        const Batched *points = Batched::in(weights.begin());
        const Batched *radii  = Batched::in(radial.begin()) + 2 * b * n_line;
        for (unsigned int q = 0; q < n_point; ++q)
          {
            point.weight = points[q] * volume;
            if (is_radial)
              {
                point.weight *= radii[2 * (q / n_line)];
                point.hoop = radii[2 * (q / n_line) + 1];
              }
            at_point(point, u, gradient, q);
          }
        if constexpr (of_to == Derivatives::own)
          along_all<n_to>([&](const auto number) {
            constexpr int c = decltype(number)::value;
            apply_along<dim, c, n_static, true>(in(derivatives_transposed),
                                                gradient[c][c],
                                                u[c],
                                                n_line);
          });
        for (int c = 0; c < n_to; ++c)
          {
            if constexpr (of_to == Derivatives::all)
              add_transposed<dim, n_static>(in(derivatives_transposed),
                                            gradient[c],
                                            u[c],
                                            n_line);
            apply_along_all<dim, n_static>(in(values_transposed), u[c], n_line);
          }
        scatter<n_to>(values_at,
                      &fields[to].positions[first],
                      strides.data(),
                      n_point,
                      batch.n_cells,
                      y.begin(),
                      factors.component);
      }
  }



  template <int dim, typename Number>
  template <int n_static>
  void
  CellProducts<dim, Number>::add_cells_of(const Operator             op,
                                          const Factors             &factors,
                                          LevelVector<Number>       &y,
                                          const LevelVector<Number> &x) const
  {
    constexpr auto all = Derivatives::all, own = Derivatives::own,
                   none    = Derivatives::none;
    const Number mass      = has_lumped_mass ? 0. : factors.mass;
    const Number stiffness = factors.stiffness;
    const Number mu        = 0.5 * stiffness * material.two_mu,
                 lambda    = stiffness * material.lambda;
    const bool is_radial   = dim == 2 && is_weighted(op);
    switch (op)
      {
        case OnGrid::heat:
        case OnGrid::laplacian:
          sum_over_cells<n_static, 1, all, 1, all>(
            op,
            factors,
            y,
            x,
            [&](const auto        &point,
                const auto        &u,
                const auto        &gradient,
                const unsigned int q) __attribute__((always_inline)) {
              u[0][q] *= point.weight * mass;
              for (unsigned int d = 0; d < dim; ++d)
                gradient[0][d][q] *= point.weight * stiffness *
                                     point.inverse_size[d] *
                                     point.inverse_size[d];
            });
          break;
        case OnGrid::momentum:
          sum_over_cells<n_static, dim, all, dim, all>(
            op,
            factors,
            y,
            x,
            [&](const auto        &point,
                const auto        &u,
                const auto        &gradient,
                const unsigned int q) __attribute__((always_inline)) {
              momentum_at_point<dim>(
                point, mass, mu, lambda, is_radial, u, gradient, q);
            });
          break;
        case OnGrid::divergence:
          sum_over_cells<n_static, dim, own, 1, none>(
            op,
            factors,
            y,
            x,
            [&](const auto        &point,
                const auto        &u,
                const auto        &gradient,
                const unsigned int q) __attribute__((always_inline)) {
              Lanes<Number> sum{};
              for (unsigned int d = 0; d < dim; ++d)
                sum += point.inverse_size[d] * gradient[d][d][q];
              if (is_radial)
                sum += point.hoop * u[1][q];
              u[0][q] = point.weight * sum * stiffness;
            });
          break;
        case OnGrid::thermal_stress:
          sum_over_cells<n_static, 1, none, dim, own>(
            op,
            factors,
            y,
            x,
            [&](const auto        &point,
                const auto        &u,
                const auto        &gradient,
                const unsigned int q) __attribute__((always_inline)) {
              const Lanes<Number> stress = point.weight * u[0][q] * stiffness;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  gradient[d][d][q] = point.inverse_size[d] * stress;
                  u[d][q]           = Lanes<Number>{};
                }
              if (is_radial)
                u[1][q] = point.hoop * stress;
            });
          break;
      }
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add_cells(const Operator             op,
                                       const Factors             &factors,
                                       LevelVector<Number>       &y,
                                       const LevelVector<Number> &x) const
  {
    const auto add = n == 2 ? &CellProducts::add_cells_of<2> :
                     n == 3 ? &CellProducts::add_cells_of<3> :
                     n == 5 ? &CellProducts::add_cells_of<5> :
                              &CellProducts::add_cells_of<0>;
    (this->*add)(op, factors, y, x);
  }



  template <int dim, typename Number>
  template <typename Visit>
  void
  CellProducts<dim, Number>::visit_faces(const Field::Block field,
                                         const double       mass,
                                         const double       stiffness,
                                         const Visit       &visit) const
  {
    const Number factor = field == Field::temperature ? stiffness : mass;
    for (const auto *const entries :
         {&fields[field].at_end, &fields[field].at_sides})
      for (const Entry &entry : *entries)
        visit(entry.row, entry.column, factor * entry.value);
  }



  template <int dim, typename Number>
  template <typename Add>
  void
  CellProducts<dim, Number>::add_up(LevelVector<Number>       &y,
                                    const LevelVector<Number> &x,
                                    const Add                 &add) const
  {
    y.zero_out_ghost_values(); // they are sums until compress()
    x.update_ghost_values();
    add();
    x.zero_out_ghost_values();
    y.compress(VectorOperation::add);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add_product(const Operator             op,
                                         const Factors             &factors,
                                         LevelVector<Number>       &y,
                                         const LevelVector<Number> &x,
                                         const bool replaces) const
  {
    if (is_by_planes)
      on_grid->add(
        op, factors.mass, factors.stiffness, y.begin(), x.begin(), replaces);
    else
      add_cells(op, factors, y, x);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::vmult(const Field::Block         field,
                                   const double               mass,
                                   const double               stiffness,
                                   LevelVector<Number>       &y,
                                   const LevelVector<Number> &x) const
  {
    // the nodes of a mass are none of the grid
    const bool replaces = is_by_planes && on_grid->covers(field, y.size());
    if (!replaces)
      y = Number();
    add_all(field, mass, stiffness, y, x, replaces);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add(const Field::Block         field,
                                 const double               mass,
                                 const double               stiffness,
                                 LevelVector<Number>       &y,
                                 const LevelVector<Number> &x) const
  {
    add_all(field, mass, stiffness, y, x, false);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add_all(const Field::Block         field,
                                     const double               mass,
                                     const double               stiffness,
                                     LevelVector<Number>       &y,
                                     const LevelVector<Number> &x,
                                     const bool                 replaces) const
  {
    add_up(y, x, [&] {
      add_product(OnGrid::of(field), {mass, stiffness}, y, x, replaces);
      visit_faces(field,
                  mass,
                  stiffness,
                  [&](const unsigned int row,
                      const unsigned int column,
                      const Number       value) {
                    y.begin()[row] += value * x.begin()[column];
                  });
    });
    const LevelVector<Number> &lumped_mass = fields[field].lumped_mass;
    if (lumped_mass.size() > 0)
      for (unsigned int i = 0; i < y.locally_owned_size(); ++i)
        y.local_element(i) +=
          Number(mass) * lumped_mass.local_element(i) * x.local_element(i);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::laplacian(const Field::Block         field,
                                       LevelVector<Number>       &y,
                                       const LevelVector<Number> &x) const
  {
    y = Number();
    add_up(y, x, [&] {
      for (unsigned int c = 0; c < n_components<dim>(field); ++c)
        add_cells(OnGrid::laplacian, {0., 1., false, field, c}, y, x);
    });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add_divergence(const double               factor,
                                            LevelVector<Number>       &heat,
                                            const LevelVector<Number> &u) const
  {
    add_up(heat, u, [&] {
      add_product(OnGrid::divergence, {0., factor}, heat, u);
    });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add_thermal_stress(
    const double               factor,
    LevelVector<Number>       &momentum,
    const LevelVector<Number> &theta) const
  {
    add_up(momentum, theta, [&] {
      add_product(OnGrid::thermal_stress, {0., factor}, momentum, theta);
    });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add_lateral_exchange(
    const double               factor,
    LevelVector<Number>       &y,
    const LevelVector<Number> &x) const
  {
    add_up(y, x, [&] {
      for (const Entry &entry : fields[Field::temperature].at_sides)
        y.begin()[entry.row] +=
          Number(factor) * entry.value * x.begin()[entry.column];
    });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::contact_stiffness(
    LevelVector<Number>       &y,
    const LevelVector<Number> &x) const
  {
    y = Number();
    add_up(y, x, [&] { add_cells(OnGrid::momentum, {0., 1., true}, y, x); });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add_contact_viscosity(
    const double               factor,
    LevelVector<Number>       &y,
    const LevelVector<Number> &x) const
  {
    if (!has_elastic_contact_nodes)
      return;
    LevelVector<Number> &extended = extended_scratch;
    LevelVector<Number> &product  = pushed_scratch;
    extended                      = x;
    extended.update_ghost_values();
    for (const Entry &entry : extension)
      extended.begin()[entry.row] = 0.;
    for (const Entry &entry : extension)
      extended.begin()[entry.row] +=
        entry.value * extended.begin()[entry.column];
    extended.zero_out_ghost_values();
    contact_stiffness(product, extended);
    for (const Entry &entry : extension)
      product.begin()[entry.column] += entry.value * product.begin()[entry.row];
    for (const Entry &entry : extension)
      product.begin()[entry.row] = 0.;
    product.compress(VectorOperation::add);
    contact_stiffness(extended, x);
    y.add(factor, product, -factor, extended);
  }



  template <int dim, typename Number>
  LevelVector<Number>
  CellProducts<dim, Number>::diagonal(const Field::Block field,
                                      const double       mass,
                                      const double       stiffness) const
  {
    LevelVector<Number> result = make_vector(field);
    visit_faces(field,
                mass,
                stiffness,
                [&](const unsigned int row,
                    const unsigned int column,
                    const Number       value) {
                  if (row == column)
                    result.begin()[row] += value;
                });
    result.compress(VectorOperation::add);
    add_diagonal(OnGrid::of(field), mass, stiffness, field, result);
    if (fields[field].lumped_mass.size() > 0)
      result.add(mass, fields[field].lumped_mass);
    return result;
  }



  template <int dim, typename Number>
  LevelVector<Number>
  CellProducts<dim, Number>::laplacian_diagonal(const Field::Block field) const
  {
    LevelVector<Number> result = make_vector(field);
    add_diagonal(OnGrid::laplacian, 0., 1., field, result);
    return result;
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add_diagonal(const Operator       op,
                                          const double         mass,
                                          const double         stiffness,
                                          const Field::Block   field,
                                          LevelVector<Number> &y) const
  {
    const auto &values = discretization.nodal_values(field);
    for (unsigned int i = 0; i < values.size(); ++i)
      if (discretization.is_in_body(values[i].node))
        y.local_element(i) += on_grid->diagonal_entry(
          op,
          op == OnGrid::momentum ? values[i].component : 0,
          on_grid->grid.index(on_grid->grid.number(values[i].node)),
          mass,
          stiffness);
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
  } // namespace



  template <int dim, typename Number>
  CellProducts<dim, Number>::CellProducts(
    const Scene               &scene,
    const Discretization<dim> &discretization)
    : discretization(discretization)
    , geometry(discretization.geometry())
    , material(scene.material)
    , n(discretization.degree() + 1)
    , n_nodes(Utilities::fixed_power<dim>(n))
    , has_lumped_mass(scene.has_lumped_mass)
    , has_elastic_contact_nodes(scene.has_elastic_contact_nodes())
    , is_by_planes(n == 2 && Utilities::MPI::n_mpi_processes(
                               discretization.communicator()) == 1)
    , scratch((dim + dim * dim) * n_nodes * n_lanes)
  {
    tabulate();
    compute_strides();
    const auto cells = make_batches(scene.contact.has_massless_nodes);
    if (!geometry.has_uniform_weight())
      compute_radial(cells);
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        {
          fields[field].prototype.reinit(
            discretization.make_vector(field).get_partitioner());
          compute_positions(field, cells);
          if (has_lumped_mass)
            collect_lumped_mass(field, cells);
        }
    collect_faces(scene);
    if (has_elastic_contact_nodes)
      {
        collect_extension();
        extended_scratch = pushed_scratch =
          fields[Field::displacement].prototype;
      }
    const LevelGrid<dim> grid(scene.parameters.mesh);
    std::array<std::vector<unsigned int>, 2>
      entries; // of their first component
    for (const Field::Block field : all_fields)
      if (is_by_planes && discretization.has_field(field))
        {
          const auto &values = discretization.nodal_values(field);
          entries[field].resize(grid.n_nodes());
          for (unsigned int i = 0; i < values.size(); ++i)
            if (values[i].component == 0 &&
                discretization.is_in_body(values[i].node))
              entries[field][grid.number(values[i].node)] = i;
        }
    on_grid = std::make_unique<const OnGrid>(scene, geometry, grid, &entries);
  }



  template <int dim, typename Number>
  LevelVector<Number>
  CellProducts<dim, Number>::make_vector(const Field::Block field) const
  {
    return fields[field].prototype;
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::tabulate()
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
  std::vector<std::vector<typename CellProducts<dim, Number>::Cell>>
  CellProducts<dim, Number>::make_batches(const bool has_massless_nodes)
  {
    std::vector<std::vector<Cell>> cells;
    for (const bool at_end : {false, true})
      {
        const unsigned int n_before = first_at_end = cells.size();
        for (const Cell &cell :
             discretization.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned() && !discretization.is_gap(cell) &&
              touches_contact_end<dim>(cell) == at_end)
            {
              if (cells.size() == n_before || cells.back().size() == n_lanes)
                cells.emplace_back();
              cells.back().push_back(cell);
            }
        for (unsigned int b = n_before; b < cells.size(); ++b)
          {
            Batch batch;
            batch.n_cells        = cells[b].size();
            batch.has_axial_mass = !(at_end && has_massless_nodes);
            for (unsigned int lane = 0; lane < n_lanes; ++lane)
              {
                const Tensor<1, dim> size =
                  CellShape<dim>(cells[b][lane < batch.n_cells ? lane : 0])
                    .sides();
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
  CellProducts<dim, Number>::compute_radial(
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
              point[1] += rule.point(q)[0] * CellShape<dim>(cell).sides()[1];
              radial.push_back(is_strain ?
                                 geometry.strain_per_displacement(point) :
                                 geometry.weight_at(point));
            }
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::compute_strides()
  {
    // a FESystem numbers the components of a vertex, line, face one by one
    lexicographic = FETools::hierarchic_to_lexicographic_numbering<dim>(n - 1);
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
  CellProducts<dim, Number>::local_positions(const Field::Block field,
                                             const Cell        &cell) const
  {
    const FiniteElement<dim>            &fe = discretization.finite_element();
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    cell->get_dof_indices(dofs);
    std::vector<unsigned int> positions(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < n_components<dim>(field); ++c)
        {
          const unsigned int at =
            position(field,
                     dofs[fe.component_to_system_index(
                       discretization.first_component(field) + c, i)]);
          unsigned int &first = positions[lexicographic[i]];
          if (c == 0)
            first = at;
          AssertThrow(at == first + c * strides[lexicographic[i]],
                      ExcInternalError());
        }
    return positions;
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::compute_positions(
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
  CellProducts<dim, Number>::collect_lumped_mass(
    const Field::Block                    field,
    const std::vector<std::vector<Cell>> &cells)
  {
    LevelVector<Number>     &mass = fields[field].lumped_mass;
    const QGaussLobatto<dim> nodes(n);
    mass = fields[field].prototype;
    for (unsigned int b = 0; b < cells.size(); ++b)
      for (const Cell &cell : cells[b])
        {
          const std::vector<unsigned int> positions =
            local_positions(field, cell);
          const CellShape<dim> shape(cell);
          double               volume = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            volume *= shape.sides()[d];
          const bool has_first =
            field == Field::temperature || batches[b].has_axial_mass;
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (unsigned int c = has_first ? 0 : 1;
                 c < n_components<dim>(field);
                 ++c)
              mass.begin()[positions[i] + c * strides[i]] +=
                nodes.weight(i) * volume *
                geometry.weight_at(shape.point(nodes.point(i)));
        }
    mass.compress(VectorOperation::add);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::collect_faces(const Scene &scene)
  {
    using Sums = std::map<std::pair<unsigned int, unsigned int>, double>;
    const FiniteElement<dim> &fe = discretization.finite_element();
    HeatExchangeFaces<dim>    faces(scene, discretization);
    FEValues<dim>             massless_values(discretization.mapping(),
                                  fe.base_element(0),
                                  massless_quadrature<dim>(n - 1,
                                                           has_lumped_mass),
                                  update_values | update_quadrature_points |
                                    update_JxW_values);
    std::vector<std::size_t>  nodes, axial_dofs;
    for (unsigned int i = 0; scene.contact.has_massless_nodes && i < n_nodes;
         ++i)
      {
        nodes.push_back(i);
        axial_dofs.push_back(fe.component_to_system_index(
          discretization.first_component(Field::displacement), i));
      }

    std::array<Sums, 2>                  at_end; // of the fields
    Sums                                 at_sides;
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    for (const Cell &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary() &&
          !discretization.is_gap(cell))
        {
          cell->get_dof_indices(dofs);
          const auto add = [&](const Field::Block field,
                               const CellMatrix  &of_cell,
                               Sums              &sums) {
            const double rounding =
              Tolerances::rounding_of_sum * of_cell.matrix.linfty_norm();
            for (unsigned int i = 0; i < of_cell.dofs.size(); ++i)
              for (unsigned int j = 0; j < of_cell.dofs.size(); ++j)
                if (std::abs(of_cell.matrix(i, j)) > rounding)
                  sums[{position(field, dofs[of_cell.dofs[i]]),
                        position(field, dofs[of_cell.dofs[j]])}] +=
                    of_cell.matrix(i, j);
          };
          faces.visit(cell,
                      [&](const CellMatrix &exchange, const bool is_lateral) {
                        add(Field::temperature,
                            exchange,
                            is_lateral ? at_sides : at_end[Field::temperature]);
                      });
          if (!scene.contact.has_massless_nodes ||
              !touches_contact_end<dim>(cell))
            continue;
          massless_values.reinit(
            typename Triangulation<dim>::active_cell_iterator(cell));
          CellMatrix mass = mass_between<dim>(discretization,
                                              nodes,
                                              massless_values,
                                              [](const auto &) { return 1.; });
          mass.dofs       = axial_dofs;
          add(Field::displacement, mass, at_end[Field::displacement]);
        }
    const auto keep = [](const Sums &sums, std::vector<Entry> &entries) {
      for (const auto &[place, value] : sums)
        entries.push_back({place.first, place.second, Number(value)});
    };
    for (const Field::Block field : all_fields)
      keep(at_end[field], fields[field].at_end);
    keep(at_sides, fields[Field::temperature].at_sides);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::collect_extension()
  {
    const FullMatrix<double> of_cell =
      extension_to_contact_nodes(discretization);
    const auto &partitioner =
      *fields[Field::displacement].prototype.get_partitioner();
    std::vector<types::global_dof_index>                    dofs(of_cell.m());
    std::map<std::pair<unsigned int, unsigned int>, double> factors;
    for (const Cell &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && touches_contact_end<dim>(cell))
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (of_cell(i, i) == 0.)
              for (unsigned int j = 0; j < dofs.size(); ++j)
                if (of_cell(i, j) != 0.)
                  factors[{position(Field::displacement, dofs[i]),
                           position(Field::displacement, dofs[j])}] =
                    of_cell(i, j);
        }
    for (const auto &[place, factor] : factors)
      if (place.first < partitioner.locally_owned_size())
        extension.push_back({place.first, place.second, Number(factor)});
  }



  template class CellProducts<2, float>;
  template class CellProducts<2, double>;
  template class CellProducts<3, float>;
  template class CellProducts<3, double>;
} // namespace ThermoContact
