// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/level_subspaces.h>
#include <thermocontact/space/lanes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  AxisElements::AxisElements(const std::vector<double> &nodes,
                             const unsigned int         degree)
    : degree(degree)
    , n_nodes(nodes.size())
    , mass(n_nodes * (degree + 1))
    , stiffness(mass)
  {
    const QGauss<1> rule(degree + 1);
    for (unsigned int first = 0; first + 1 < n_nodes; first += degree)
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const double length = nodes[first + degree] - nodes[first];
          const double x      = nodes[first] + rule.point(q)[0] * length;
          const double weight = rule.weight(q) * length;
          for (unsigned int i = 0; i <= degree; ++i)
            for (unsigned int j = 0; j <= i; ++j)
              {
                const ValueAndSlope f = lagrange(&nodes[first], degree, i, x),
                                    g = lagrange(&nodes[first], degree, j, x);
                const std::size_t at  = (first + i) * (degree + 1) + i - j;
                mass[at] += weight * f.value * g.value;
                stiffness[at] += weight * f.slope * g.slope;
              }
        }
    make_splines(nodes);
  }



  void
  AxisElements::make_splines(const std::vector<double> &nodes)
  {
    // B-splines whose inner knots are there degree - 1 times (de Boor)
    const unsigned int n_cells = (n_nodes - 1) / degree;
    const auto         knot    = [&](const unsigned int k) {
      const unsigned int cell =
        k <= degree ? 0 :
                                 std::min(1 + (k - degree - 1) / (degree - 1), n_cells);
      return nodes[cell * degree];
    };
    const auto over = [](const double a, const double b) {
      return b > 0. ? a / b : 0.;
    };
    splines.resize(n_cells * (degree - 1) + 2, {n_nodes, {}, 0., 0., 0., 0.});
    const QGauss<1> rule(degree + 1);
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      {
        const unsigned int first = cell * (degree - 1); // of the splines here
        // value, slope and curvature of those that are not zero
        const auto at = [&](const double x) {
          std::vector<std::array<double, 3>> b(degree + 2);
          b[degree][0] = 1.;
          for (unsigned int q = 1; q <= degree; ++q)
            for (unsigned int i = degree - q; i <= degree; ++i)
              {
                const unsigned int j      = first + i;
                const double       before = knot(j + q) - knot(j);
                const double       after  = knot(j + q + 1) - knot(j + 1);
                for (unsigned int r = 2; r > 0; --r)
                  b[i][r] = q * (over(b[i][r - 1], before) -
                                 over(b[i + 1][r - 1], after));
                b[i][0] = over((x - knot(j)) * b[i][0], before) +
                          over((knot(j + q + 1) - x) * b[i + 1][0], after);
              }
          return b;
        };
        for (unsigned int k = 0; k <= degree; ++k)
          {
            const unsigned int node = cell * degree + k;
            const auto         b    = at(nodes[node]);
            for (unsigned int i = 0; i <= degree; ++i)
              {
                Spline &spline    = splines[first + i];
                spline.first_node = std::min(spline.first_node, node);
                spline.at_nodes.resize(node - spline.first_node + 1);
                spline.at_nodes.back() = {b[i][0], b[i][1]};
              }
          }
        const double length = nodes[(cell + 1) * degree] - nodes[cell * degree];
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const double weight = rule.weight(q) * length;
            const auto b = at(nodes[cell * degree] + rule.point(q)[0] * length);
            for (unsigned int i = 0; i <= degree; ++i)
              {
                Spline &spline = splines[first + i];
                spline.square += weight * b[i][0] * b[i][0];
                spline.square_of_slope += weight * b[i][1] * b[i][1];
                spline.square_of_curvature += weight * b[i][2] * b[i][2];
                spline.with_curvature += weight * b[i][0] * b[i][2];
              }
          }
      }
    const auto is_zero = [](const ValueAndSlope &at) {
      return at.value == 0. && at.slope == 0.;
    };
    for (Spline &spline : splines)
      {
        while (is_zero(spline.at_nodes.back()))
          spline.at_nodes.pop_back();
        while (is_zero(spline.at_nodes.front()))
          {
            spline.at_nodes.erase(spline.at_nodes.begin());
            ++spline.first_node;
          }
      }
  }



  namespace
  {
    /** $\lambda/\mu$ from where what keeps its volume is soft. */
    constexpr double stiff = 6.;

    template <typename Number>
    Band<Number>
    transposed(const Band<Number> &band)
    {
      const unsigned int n_rows = band.first.size();
      Band<Number>       result{n_rows,
                          0,
                          std::vector<unsigned int>(band.n_columns, n_rows),
                          {}};
      const auto         visit = [&](const auto &act) {
        for (unsigned int i = 0; i < n_rows; ++i)
          for (unsigned int k = 0; k < band.width; ++k)
            if (const Number entry = band.entries[i * band.width + k];
                entry != 0)
              act(band.first[i] + k, i, entry);
      };
      visit([&](const unsigned int row, const unsigned int column, Number) {
        unsigned int &first = result.first[row];
        first               = std::min(first, column);
        result.width        = std::max(result.width, column - first + 1);
      });
      for (unsigned int &first : result.first)
        first = std::min(first, n_rows - result.width);
      result.entries.resize(band.n_columns * result.width);
      visit([&](const unsigned int row,
                const unsigned int column,
                const Number       entry) {
        result.entries[row * result.width + column - result.first[row]] = entry;
      });
      return result;
    }



    /**
     * @p y = (+) the matrix times @p x for the middle index of an array.
     *
     * @tparam n_static width of the matrix, or 0
     */
    template <bool add, unsigned int n_static, typename Number, typename Inner>
    void
    multiply(const Band<Number> &band,
             const unsigned int  n_blocks,
             const Inner         n_inner,
             const Number       *x,
             Number             *y)
    {
      using Batched                  = Lanes<Number>;
      constexpr unsigned int n_lanes = Batched::n_lanes;
      const unsigned int     n_rows  = band.first.size();
      const unsigned int     width   = n_static > 0 ? n_static : band.width;
      for (unsigned int block = 0; block < n_blocks; ++block)
        for (unsigned int row = 0; row < n_rows; ++row)
          {
            const Number *const f = &band.entries[row * width];
            const Number *const from =
              x + (block * band.n_columns + band.first[row]) * n_inner;
            Number *const to = y + (block * n_rows + row) * n_inner;
            unsigned int  i  = 0;
            for (; i + n_lanes <= n_inner; i += n_lanes)
              {
                Batched sum = add ? Batched::load(to + i) : Batched{};
                for (unsigned int k = 0; k < width; ++k)
                  sum += Batched::load(from + k * n_inner + i) * f[k];
                sum.store(to + i);
              }
            for (; i < n_inner; ++i)
              {
                Number sum = add ? to[i] : 0;
                for (unsigned int k = 0; k < width; ++k)
                  sum += from[k * n_inner + i] * f[k];
                to[i] = sum;
              }
          }
    }



    template <bool add, typename Number, typename Inner>
    void
    multiply(const Band<Number> &band,
             const unsigned int  n_blocks,
             const Inner         n_inner,
             const Number       *x,
             Number             *y)
    {
      if (band.width == 3) // those of degree 2
        multiply<add, 3>(band, n_blocks, n_inner, x, y);
      else if (band.width == 5)
        multiply<add, 5>(band, n_blocks, n_inner, x, y);
      else
        multiply<add, 0>(band, n_blocks, n_inner, x, y);
    }



    /**
     * In place: right-hand sides to solutions, for the middle index of arrays.
     *
     * @tparam n_static @p degree, the width of the factors, or 0
     * @param stride from the multipliers of one node before to the next one
     */
    template <unsigned int n_static, typename Number, typename Inner>
    void
    solve(const unsigned int degree_,
          const unsigned int n_blocks,
          const unsigned int n,
          const Inner        n_inner,
          const Number      *multipliers,
          const std::size_t  stride,
          const Number      *inverse,
          Number            *x)
    {
      const unsigned int degree = n_static > 0 ? n_static : degree_;
      const auto         visit =
        [&](const std::size_t at, const unsigned int n_others, const auto &go) {
          // their number is known when compiling where it can be
          if (n_others < degree)
            go(at, n_others);
          else
            go(at, degree);
        };
      const auto forward = [&](const std::size_t at, const unsigned int m) {
#pragma GCC ivdep
        for (std::size_t j = at; j < at + n_inner; ++j)
          {
            Number value = x[j];
            for (unsigned int k = 1; k <= m; ++k)
              value -= multipliers[(k - 1) * stride + j] * x[j - k * n_inner];
            x[j] = value;
          }
      };
      const auto backward = [&](const std::size_t at, const unsigned int m) {
#pragma GCC ivdep
        for (std::size_t j = at; j < at + n_inner; ++j)
          {
            Number value = inverse[j] * x[j];
            for (unsigned int k = 1; k <= m; ++k)
              value -= multipliers[(k - 1) * stride + j + k * n_inner] *
                       x[j + k * n_inner];
            x[j] = value;
          }
      };
      for (std::size_t block = 0; block < n_blocks; ++block)
        {
          const std::size_t first = block * n * n_inner;
          for (unsigned int i = 1; i < n; ++i)
            visit(first + i * n_inner, i, forward);
          for (unsigned int i = n; i-- > 0;)
            visit(first + i * n_inner, n - 1 - i, backward);
        }
    }
  } // namespace



  template <typename Number, typename Of>
  Band<Number>
  AxisElements::splines_at_nodes(const Of &of) const
  {
    Band<Number> by_splines{n_nodes, 0, {}, {}};
    for (const Spline &spline : splines)
      by_splines.width =
        std::max<unsigned int>(by_splines.width, spline.at_nodes.size());
    by_splines.entries.resize(splines.size() * by_splines.width);
    for (unsigned int j = 0; j < splines.size(); ++j)
      {
        const Spline &spline = splines[j];
        by_splines.first.push_back(
          std::min(spline.first_node, n_nodes - by_splines.width));
        for (unsigned int k = 0; k < spline.at_nodes.size(); ++k)
          by_splines.entries[j * by_splines.width + spline.first_node + k -
                             by_splines.first[j]] = of(spline.at_nodes[k]);
      }
    return transposed(by_splines);
  }



  template <int dim, typename Number>
  bool
  LevelSubspaces<dim, Number>::are_for(const Scene         &scene,
                                       const Geometry<dim> &geometry)
  {
    return scene.parameters.mesh.degree > 1 && geometry.has_uniform_weight() &&
           scene.material.lambda > stiff * 0.5 * scene.material.two_mu;
  }



  template <int dim, typename Number>
  LevelSubspaces<dim, Number>::LevelSubspaces(
    const LevelGrid<dim>               &grid,
    const Material                     &material,
    const LevelVector<Number>          &prototype,
    const std::vector<NodalValue<dim>> &values)
    : material(material)
    , axes{{AxisElements(grid.positions(0), grid.degree()),
            AxisElements(grid.positions(1), grid.degree())}}
    , n_nodes(grid.n_nodes())
    , shape{{1, 1, 1}}
    , strides{}
  {
    const IndexSet    &owned        = prototype.locally_owned_elements();
    const MPI_Comm     communicator = prototype.get_mpi_communicator();
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);

    for (unsigned int d = 0; d < dim; ++d)
      {
        shape[d]   = grid.positions(d).size();
        strides[d] = grid.strides()[d];
      }
    for (unsigned int a = rank; a < (dim == 3 ? 3 : 1); a += n_ranks)
      {
        const unsigned int b = (a + 1) % dim, c = dim == 3 ? (a + 2) % dim : 2;
        planes.push_back(
          {a, b, c, dim == 2, std::size_t(shape[a]) * shape[b] * width});
      }

    entries.resize(dim * n_nodes);
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        const unsigned int node = grid.number(values[i].node);
        entries[values[i].component * n_nodes + node] =
          owned.nth_index_in_set(i);
      }
    Utilities::MPI::sum(entries, communicator, entries);
    partitioner = std::make_shared<const Utilities::MPI::Partitioner>(
      owned, complete_index_set(owned.size()), communicator);
    for (unsigned int &entry : entries)
      entry = partitioner->global_to_local(entry);
    for (unsigned int i = 0; i < 2; ++i)
      {
        bands[i].value = axes[i].template splines_at_nodes<Number>(
          [](const ValueAndSlope &at) { return at.value; });
        bands[i].slope = axes[i].template splines_at_nodes<Number>(
          [](const ValueAndSlope &at) { return at.slope; });
        bands[i].value_transposed = transposed(bands[i].value);
        bands[i].slope_transposed = transposed(bands[i].slope);
      }
  }



  template <int dim, typename Number>
  SubspaceFactors<dim, Number>::SubspaceFactors(
    const LevelSubspaces<dim, Number> &spaces,
    const double                       stiffness,
    const Vector                      &rest)
    : spaces(spaces)
    , factors(spaces.planes.size())
    , from(spaces.entries.size())
    , to(from)
  {
    if (spaces.partitioner->n_mpi_processes() > 1)
      whole = std::make_unique<LevelVector<Number>>(spaces.partitioner);
    Vector shared(spaces.partitioner);
    shared.copy_locally_owned_data_from(rest);
    shared.update_ghost_values();
    std::vector<double> diagonal;
    for (const unsigned int entry : spaces.entries)
      diagonal.push_back(shared.local_element(entry));
    for (unsigned int p = 0; p < factors.size(); ++p)
      {
        const Plane &plane = spaces.planes[p];
        factorize(plane, true, stiffness, diagonal, factors[p].along_a);
        if (plane.has_lines_along_b)
          factorize(plane, false, stiffness, diagonal, factors[p].along_b);
        compute_energies(plane,
                         stiffness,
                         diagonal,
                         factors[p].inverse_energies);
        for (std::vector<Number> *array :
             {&values[0], &values[1], &flows[0], &flows[1], &half})
          array->resize(std::max(array->size(), plane.n_places));
      }
  }



  template <int dim, typename Number>
  template <typename Visit>
  void
  SubspaceFactors<dim, Number>::visit_places(const Plane       &plane,
                                             const unsigned int first,
                                             const Visit       &visit) const
  {
    const unsigned int n_together =
      std::min(spaces.width, spaces.shape[plane.across] - first);
    const unsigned int stride = spaces.strides[plane.across];
    for (unsigned int i = 0, place = 0; i < spaces.shape[plane.a]; ++i)
      for (unsigned int j = 0; j < spaces.shape[plane.b];
           ++j, place += spaces.width)
        {
          const unsigned int node = i * spaces.strides[plane.a] +
                                    j * spaces.strides[plane.b] +
                                    first * stride;
          for (unsigned int lane = 0; lane < n_together; ++lane)
            visit(place + lane, node + lane * stride);
        }
  }



  template <int dim, typename Number>
  void
  SubspaceFactors<dim, Number>::factorize(const Plane               &plane,
                                          const bool                 is_along_a,
                                          const double               stiffness,
                                          const std::vector<double> &rest,
                                          Lines &lines) const
  {
    const unsigned int  direction = is_along_a ? plane.a : plane.b;
    const unsigned int  beside    = is_along_a ? plane.b : plane.a;
    const AxisElements &axis      = spaces.axis(direction),
                       &other     = spaces.axis(beside);
    const unsigned int n = axis.n_nodes, degree = axis.degree;
    const unsigned int n_groups =
      (spaces.shape[plane.across] + spaces.width - 1) / spaces.width;
    const std::size_t stride  = n_groups * plane.n_places;
    const std::size_t n_b     = spaces.shape[plane.b];
    const double      mu      = 0.5 * spaces.material.two_mu;
    const double      tension = spaces.material.lambda + 2. * mu;
    lines.inverse_pivots.resize(stride);
    lines.multipliers.resize(degree * stride);
    std::vector<double> pivots(n), band(n * degree);
    for (unsigned int k = 0; k < spaces.shape[plane.across]; ++k)
      for (unsigned int j = 0; j < other.n_nodes; ++j)
        {
          double mass   = other.mass[j * (degree + 1)];
          double change = other.stiffness[j * (degree + 1)];
          if (dim == 3)
            {
              const AxisElements &third = spaces.axis(plane.across);
              change = change * third.mass[k * (degree + 1)] +
                       mass * third.stiffness[k * (degree + 1)];
              mass *= third.mass[k * (degree + 1)];
            }
          for (unsigned int i = 0; i < n; ++i)
            {
              const std::size_t at =
                k / spaces.width * plane.n_places +
                (is_along_a ? i * n_b + j : j * n_b + i) * spaces.width +
                k % spaces.width;
              const double extra = rest[direction * spaces.n_nodes +
                                        i * spaces.strides[direction] +
                                        j * spaces.strides[beside] +
                                        k * spaces.strides[plane.across]];
              const auto   entry = [&](const unsigned int l) {
                const std::size_t m = i * (degree + 1) + l;
                return stiffness * (tension * mass * axis.stiffness[m] +
                                    mu * change * axis.mass[m]);
              };
              double       pivot    = entry(0) + extra;
              const double smallest = Tolerances::smallest_single_pivot * pivot;
              const bool   is_held  = extra >= Tolerances::stiffest_spring;
              for (unsigned int l = std::min(i, degree); l > 0; --l)
                {
                  double value = entry(l);
                  for (unsigned int m = l + 1; m <= std::min(i, degree); ++m)
                    value -= band[i * degree + m - 1] * pivots[i - m] *
                             band[(i - l) * degree + m - l - 1];
                  const double multiplier =
                    is_held || pivots[i - l] >= Tolerances::stiffest_spring ?
                      0. :
                      value / pivots[i - l];
                  band[i * degree + l - 1] = multiplier;
                  pivot -= multiplier * multiplier * pivots[i - l];
                  lines.multipliers[(l - 1) * stride + at] = multiplier;
                }
              pivots[i]                = std::max(pivot, smallest);
              lines.inverse_pivots[at] = is_held ? 0. : 1. / pivots[i];
            }
        }
  }



  template <int dim, typename Number>
  void
  SubspaceFactors<dim, Number>::compute_energies(
    const Plane               &plane,
    const double               stiffness,
    const std::vector<double> &rest,
    std::vector<Number>       &inverse) const
  {
    const AxisElements &a = spaces.axis(plane.a), &b = spaces.axis(plane.b);
    constexpr std::integral_constant<unsigned int,
                                     LevelSubspaces<dim, Number>::width>
               width;
    const auto squares = [](const AxisElements &axis, const auto of) {
      return transposed(axis.splines_at_nodes<double>(
        [of](const ValueAndSlope &at) { return at.*of * (at.*of); }));
    };
    constexpr auto value = &ValueAndSlope::value, slope = &ValueAndSlope::slope;
    const Band<double> a_value = squares(a, value), a_slope = squares(a, slope),
                       b_value = squares(b, value), b_slope = squares(b, slope);
    const std::size_t   n = a.splines.size() * b.splines.size() * width;
    std::vector<double> of_nodes(plane.n_places), of_half(plane.n_places), sum;
    for (unsigned int k = 0; k < spaces.shape[plane.across]; k += width)
      {
        sum.assign(n, 0.);
        const auto add = [&](const unsigned int  component,
                             const Band<double> &of_a,
                             const Band<double> &of_b) {
          std::fill(of_nodes.begin(), of_nodes.end(), 0.);
          visit_places(plane,
                       k,
                       [&](const unsigned int place, const unsigned int node) {
                         of_nodes[place] =
                           rest[component * spaces.n_nodes + node];
                       });
          multiply<false>(
            of_b, a.n_nodes, width, of_nodes.data(), of_half.data());
          multiply<true>(of_a,
                         1,
                         std::size_t(b.splines.size() * width),
                         of_half.data(),
                         sum.data());
        };
        add(plane.a, a_value, b_slope);
        add(plane.b, a_slope, b_value);
        for (std::size_t i = 0; i < n; ++i)
          {
            const Spline &f         = a.splines[i / width / b.splines.size()],
                         &g         = b.splines[i / width % b.splines.size()];
            double             mass = 1., change = 0.; // across the plane
            const unsigned int third    = k + i % width;
            const bool         is_there = third < spaces.shape[plane.across];
            if (dim == 3 && is_there)
              {
                const AxisElements &axis = spaces.axis(plane.across);
                mass                     = axis.mass[third * (axis.degree + 1)];
                change = axis.stiffness[third * (axis.degree + 1)];
              }
            const double in_plane = 2. * f.square_of_slope * g.square_of_slope +
                                    0.5 * (f.square * g.square_of_curvature +
                                           f.square_of_curvature * g.square) -
                                    f.with_curvature * g.with_curvature;
            const double across = 0.5 * (f.square * g.square_of_slope +
                                         f.square_of_slope * g.square);
            // with three dimensions a flow is in two families
            inverse.push_back(
              !is_there || sum[i] > Tolerances::energy_of_held ?
                0. :
                1. / ((dim - 1) * (stiffness * spaces.material.two_mu *
                                     (in_plane * mass + across * change) +
                                   sum[i])));
          }
      }
  }



  template <int dim, typename Number>
  void
  SubspaceFactors<dim, Number>::apply(const Plane   &plane,
                                      const OfPlane &factors) const
  {
    constexpr std::integral_constant<unsigned int,
                                     LevelSubspaces<dim, Number>::width>
                       width;
    const unsigned int n_a = spaces.shape[plane.a], n_b = spaces.shape[plane.b];
    const unsigned int degree = spaces.axes[0].degree;
    const auto &a = spaces.bands[plane.a > 0], &b = spaces.bands[plane.b > 0];
    const unsigned int m_a             = spaces.axis(plane.a).splines.size(),
                       m_b             = spaces.axis(plane.b).splines.size();
    const std::size_t          n_flows = std::size_t(m_a) * m_b * width;
    const std::size_t          stride  = factors.along_a.inverse_pivots.size();
    const unsigned int         row = n_b * width, row_of_flows = m_b * width;
    const Number *const        from_a = &from[plane.a * spaces.n_nodes],
                        *const from_b = &from[plane.b * spaces.n_nodes];
    Number *const              to_a   = &to[plane.a * spaces.n_nodes],
                  *const       to_b   = &to[plane.b * spaces.n_nodes];
    Number *const of_a = values[0].data(), *const of_b = values[1].data(),
                  *const flow = flows[0].data(), *const other = flows[1].data();
    const auto solve_lines = [&](const Lines       &lines,
                                 const std::size_t  at,
                                 const unsigned int n_blocks,
                                 const unsigned int n,
                                 const auto         n_inner,
                                 Number            *x) {
      const Number *const multipliers = &lines.multipliers[at];
      const Number *const inverse     = &lines.inverse_pivots[at];
      if (degree == 2)
        solve<2>(degree, n_blocks, n, n_inner, multipliers, stride, inverse, x);
      else
        solve<0>(degree, n_blocks, n, n_inner, multipliers, stride, inverse, x);
    };
    for (unsigned int k = 0; k < spaces.shape[plane.across]; k += width)
      {
        visit_places(plane,
                     k,
                     [&](const unsigned int place, const unsigned int node) {
                       of_a[place] = from_a[node];
                       of_b[place] = from_b[node];
                     });
        // the curl of f(a) g(b) is (f g', - f' g)
        const Number *const inverse =
          &factors.inverse_energies[k / width * n_flows];
        multiply<false>(b.slope_transposed, n_a, width, of_a, half.data());
        multiply<false>(a.value_transposed, 1, row_of_flows, half.data(), flow);
        multiply<false>(b.value_transposed, n_a, width, of_b, half.data());
        multiply<false>(
          a.slope_transposed, 1, row_of_flows, half.data(), other);
        for (std::size_t i = 0; i < n_flows; ++i)
          {
            flow[i]  = inverse[i] * (flow[i] - other[i]);
            other[i] = -flow[i];
          }
        const std::size_t at = k / width * plane.n_places;
        solve_lines(factors.along_a, at, 1, n_a, row, of_a);
        if (plane.has_lines_along_b)
          solve_lines(factors.along_b, at, n_a, n_b, width, of_b);
        else
          std::fill_n(of_b, plane.n_places, Number());
        multiply<false>(a.value, 1, row_of_flows, flow, half.data());
        multiply<true>(b.slope, n_a, width, half.data(), of_a);
        multiply<false>(a.slope, 1, row_of_flows, other, half.data());
        multiply<true>(b.value, n_a, width, half.data(), of_b);
        visit_places(plane,
                     k,
                     [&](const unsigned int place, const unsigned int node) {
                       to_a[node] += of_a[place];
                       to_b[node] += of_b[place];
                     });
      }
  }



  template <int dim, typename Number>
  void
  SubspaceFactors<dim, Number>::apply(LevelVector<Number> &vector) const
  {
    if (whole)
      {
        copy_values(*whole, vector);
        whole->update_ghost_values();
      }
    Number *const shared = whole ? whole->begin() : vector.begin();
    for (std::size_t i = 0; i < from.size(); ++i)
      from[i] = shared[spaces.entries[i]];
    std::fill(to.begin(), to.end(), Number());
    for (unsigned int p = 0; p < factors.size(); ++p)
      apply(spaces.planes[p], factors[p]);
    if (whole)
      *whole = Number(); // with its ghosts
    for (std::size_t i = 0; i < to.size(); ++i)
      shared[spaces.entries[i]] = to[i];
    if (whole)
      {
        whole->compress(VectorOperation::add);
        copy_values(vector, *whole);
      }
  }



  template class LevelSubspaces<2, float>;
  template class LevelSubspaces<2, double>;
  template class LevelSubspaces<3, float>;
  template class LevelSubspaces<3, double>;
  template class SubspaceFactors<2, float>;
  template class SubspaceFactors<2, double>;
  template class SubspaceFactors<3, float>;
  template class SubspaceFactors<3, double>;
} // namespace ThermoContact
