// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/band_factors.h>
#include <thermocontact/multigrid/level_subspaces.h>
#include <thermocontact/space/lanes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** $\lambda/\mu$ from where what keeps its volume is soft. */
    constexpr double stiff = 6.;



    template <typename Number>
    Band<Number>
    transposed(const Band<Number> &band)
    {
      const unsigned int n_rows = band.first.size();
      Band<Number>       result{n_rows, 0, {}, {}};
      const auto         visit = [&](const auto &act) {
        for (unsigned int i = 0; i < band.entries.size(); ++i)
          if (const Number entry = band.entries[i]; entry != 0)
            act(band.first[i / band.width] + i % band.width,
                i / band.width,
                entry);
      };
      result.first.resize(band.n_columns, n_rows);
      visit([&](const unsigned int row, const unsigned int column, Number) {
        unsigned int &first = result.first[row]; // columns ascend
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



    template <typename Number>
    Band<double>
    squared(const Band<Number> &band)
    {
      Band<double> result{band.n_columns, band.width, band.first, {}};
      for (const double entry : band.entries)
        result.entries.push_back(entry * entry);
      return result;
    }



    /**
     * @p y = (+) the matrix times @p x for the middle index of an array.
     *
     * @tparam n_static width of the matrix, or 0
     */
    template <bool add, unsigned int n_static, typename Number>
    void
    multiply_band(const Band<Number> &band,
                  const unsigned int  n_blocks,
                  const std::size_t   n_inner,
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
            std::size_t   i  = 0;
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



    template <bool add, typename Number>
    void
    multiply_band(const Band<Number> &band,
                  const unsigned int  n_blocks,
                  const std::size_t   n_inner,
                  const Number       *x,
                  Number             *y)
    {
      if (band.width == 3) // splines of degree 2
        multiply_band<add, 3>(band, n_blocks, n_inner, x, y);
      else if (band.width == 5)
        multiply_band<add, 5>(band, n_blocks, n_inner, x, y);
      else
        multiply_band<add, 0>(band, n_blocks, n_inner, x, y);
    }



    /**
     * In place: right-hand sides to solutions, for the first index of an array
     * before and behind which are @p degree rows of zeros.
     *
     * @tparam n_static @p degree, or 0
     * @param multipliers with the row before, the one before that, ...
     */
    template <unsigned int n_static, typename Number>
    void
    solve(const unsigned int degree_,
          const unsigned int n,
          const std::size_t  n_inner,
          const Number      *multipliers,
          const Number      *inverse,
          Number            *x)
    {
      const unsigned int degree = n_static > 0 ? n_static : degree_;
      const std::size_t  size   = n * n_inner;
      for (std::size_t first = 0; first < size; first += n_inner)
#pragma GCC ivdep
        for (std::size_t j = first; j < first + n_inner; ++j)
          {
            Number value = x[j];
            for (unsigned int k = 1; k <= degree; ++k)
              value -= multipliers[(k - 1) * size + j] * *(x + j - k * n_inner);
            x[j] = value;
          }
      for (std::size_t end = size; end > 0; end -= n_inner)
#pragma GCC ivdep
        for (std::size_t j = end - n_inner; j < end; ++j)
          {
            Number value = inverse[j] * x[j];
            for (unsigned int k = 1; k <= degree; ++k)
              value -= multipliers[(k - 1) * size + j + k * n_inner] *
                       x[j + k * n_inner];
            x[j] = value;
          }
    }
  } // namespace



  template <typename Number>
  SplineAxis<Number>::SplineAxis(const std::vector<double> &nodes,
                                 const unsigned int         degree)
    : degree(degree)
    , n_nodes(nodes.size())
    , mass(n_nodes * (degree + 1))
    , stiffness(mass)
  {
    visit_products(nodes, degree, [&](const BasisProduct &at) {
      if (at.i < at.j)
        return;
      const unsigned int entry = at.i * (degree + 1) + at.i - at.j;
      mass[entry] += at.weight * at.of_i.value * at.of_j.value;
      stiffness[entry] += at.weight * at.of_i.slope * at.of_j.slope;
    });

    make_splines(nodes);
    value_transposed = transposed(value);
    slope_transposed = transposed(slope);
    const auto form  = [&](const std::vector<double> &matrix,
                          const Band<Number>        &functions,
                          const unsigned int         function) {
      const Number *const f   = &functions.entries[function * functions.width];
      double              sum = 0.;
      for (unsigned int i = 0; i < functions.width; ++i)
        for (unsigned int k = 0; k <= std::min(i, degree); ++k)
          sum += (k == 0 ? 1. : 2.) * f[i] * f[i - k] *
                 matrix[(functions.first[function] + i) * (degree + 1) + k];
      return sum;
    };
    for (unsigned int f = 0; f < value_transposed.first.size(); ++f)
      {
        const double of_slopes = form(stiffness, value_transposed, f);
        integrals.push_back({form(mass, value_transposed, f),
                             of_slopes,
                             form(stiffness, slope_transposed, f),
                             -of_slopes});
      }
    // by parts, with f = 1 at an end
    integrals.front().with_curvature -= slope_transposed.entries.front();
    integrals.back().with_curvature += slope_transposed.entries.back();
  }



  template <typename Number>
  void
  SplineAxis<Number>::make_splines(const std::vector<double> &nodes)
  {
    // inner knots are there degree - 1 times (de Boor)
    const unsigned int n_cells = (n_nodes - 1) / degree;
    const auto         knot    = [&](const unsigned int k) {
      const unsigned int cell =
        k <= degree ? 0 : 1 + (k - degree - 1) / (degree - 1);
      return nodes[std::min(cell, n_cells) * degree];
    };
    const auto over = [](const double a, const double b) {
      return b > 0. ? a / b : 0.;
    };
    value.n_columns = n_cells * (degree - 1) + 2;
    value.width     = degree + 1;
    slope           = value;
    for (unsigned int node = 0; node < n_nodes; ++node)
      {
        const unsigned int first = // of the splines that are not zero in a cell
          std::min(node / degree, n_cells - 1) * (degree - 1);
        std::vector<ValueAndSlope> b(degree + 2);
        b[degree].value = 1.;
        for (unsigned int q = 1; q <= degree; ++q)
          for (unsigned int i = degree - q; i <= degree; ++i)
            {
              const double begin = knot(first + i),
                           end   = knot(first + i + q + 1);
              const double f = over(b[i].value, knot(first + i + q) - begin);
              const double g = over(b[i + 1].value, end - knot(first + i + 1));
              b[i] = {(nodes[node] - begin) * f + (end - nodes[node]) * g,
                      q * (f - g)};
            }
        for (Band<Number> *band : {&value, &slope})
          {
            band->first.push_back(first);
            for (unsigned int i = 0; i <= degree; ++i)
              band->entries.push_back(band == &value ? b[i].value : b[i].slope);
          }
      }
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
    , axes{{{grid.positions(0), grid.degree()},
            {grid.positions(1), grid.degree()}}}
  {
    const IndexSet &owned        = prototype.locally_owned_elements();
    const MPI_Comm  communicator = prototype.get_mpi_communicator();
    partitioner = std::make_shared<const Utilities::MPI::Partitioner>(
      owned, complete_index_set(owned.size()), communicator);

    std::vector<unsigned int> entries(dim * grid.n_nodes()); // node by node
    for (unsigned int i = 0; i < values.size(); ++i)
      entries[grid.number(values[i].node) * dim + values[i].component] =
        owned.nth_index_in_set(i);
    Utilities::MPI::sum(entries, communicator, entries);

    std::array<unsigned int, 3> strides{}; // of nodes
    for (unsigned int d = 0; d < dim; ++d)
      strides[d] = grid.strides()[d];
    for (unsigned int a = partitioner->this_mpi_process(); a < dim;
         a += partitioner->n_mpi_processes())
      {
        const unsigned int b = (a + 1) % dim, c = dim == 3 ? (a + 2) % dim : 2;
        Family             family{a, b, c, {}, {}, dim == 3 || a == 0};
        for (unsigned int i = 0; i < n_nodes(a); ++i)
          for (unsigned int j = 0; j < n_nodes(b); ++j)
            for (unsigned int k = 0; k < n_nodes(c); ++k)
              {
                const unsigned int *const of_node =
                  &entries[(i * strides[a] + j * strides[b] + k * strides[c]) *
                           dim];
                family.of_a.push_back(partitioner->global_to_local(of_node[a]));
                family.of_b.push_back(partitioner->global_to_local(of_node[b]));
              }
        families.push_back(std::move(family));
      }
  }



  template <int dim, typename Number>
  SubspaceFactors<dim, Number>::SubspaceFactors(
    const LevelSubspaces<dim, Number> &spaces,
    const double                       stiffness)
    : spaces(spaces)
    , stiffness(stiffness)
    , rest(spaces.partitioner)
    , factors(spaces.families.size())
    , sum(spaces.partitioner->size())
  {
    std::fill(rest.begin(), rest.begin() + sum.size(), -1.);
    if (spaces.partitioner->n_mpi_processes() > 1)
      whole = std::make_unique<LevelVector<Number>>(spaces.partitioner);
    for (std::vector<Number> *array : {&values_b, &half, &flows, &other_flows})
      array->resize(sum.size() / dim);
    for (unsigned int f = 0; f < factors.size(); ++f)
      {
        const std::size_t         n_places = spaces.families[f].of_a.size();
        const SplineAxis<Number> &axis     = spaces.axis(spaces.families[f].a);
        factors[f].inverse_pivots.resize(n_places);
        factors[f].multipliers.resize(axis.degree * // with zeros behind
                                      (n_places + n_places / axis.n_nodes));
      }
  }



  template <int dim, typename Number>
  void
  SubspaceFactors<dim, Number>::update(const Vector &new_rest)
  {
    Vector shared(spaces.partitioner);
    shared.copy_locally_owned_data_from(new_rest);
    shared.update_ghost_values();
    for (unsigned int f = 0; f < factors.size(); ++f)
      factorize(spaces.families[f], shared, factors[f]);
    rest.swap(shared);
    for (unsigned int f = 0; f < factors.size(); ++f)
      if (spaces.families[f].has_flows)
        compute_energies(spaces.families[f], factors[f].inverse_energies);
  }



  template <int dim, typename Number>
  void
  SubspaceFactors<dim, Number>::factorize(const Family &family,
                                          const Vector &new_rest,
                                          Factors      &factors)
  {
    const SplineAxis<Number> &axis = spaces.axis(family.a);
    const unsigned int        n = axis.n_nodes, degree = axis.degree;
    const std::size_t   n_places = family.of_a.size(), n_lines = n_places / n;
    const unsigned int  n_c     = spaces.n_nodes(family.c);
    const double        mu      = 0.5 * spaces.material.two_mu;
    const double        tension = spaces.material.lambda + 2. * mu;
    std::vector<double> extra(n);
    for (std::size_t line = 0; line < n_lines; ++line)
      {
        bool has_changed = false;
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int entry = family.of_a[i * n_lines + line];
            extra[i]                 = new_rest.local_element(entry);
            has_changed = has_changed || extra[i] != rest.local_element(entry);
          }
        if (!has_changed)
          continue;
        const auto b      = spaces.diagonals(family.b, line / n_c),
                   c      = spaces.diagonals(family.c, line % n_c);
        const double mass = tension * b.mass * c.mass,
                     change =
                       mu * (b.mass * c.stiffness + b.stiffness * c.mass);
        const auto is_held = [&](const unsigned int i) {
          return extra[i] >= Tolerances::stiffest_spring;
        };
        BandFactors matrix(n, degree);
        for (unsigned int i = 0; i < n; ++i)
          {
            for (unsigned int k = 0; k <= std::min(i, degree); ++k)
              if (!is_held(i) && !is_held(i - k))
                {
                  const unsigned int at = i * (degree + 1) + k;
                  matrix.entry(i, i - k) =
                    stiffness *
                    (mass * axis.stiffness[at] + change * axis.mass[at]);
                }
            matrix.entry(i, i) += extra[i];
          }
        matrix.factorize(Tolerances::smallest_single_pivot);
        for (unsigned int i = 0; i < n; ++i)
          {
            const std::size_t place = i * n_lines + line;
            factors.inverse_pivots[place] =
              is_held(i) ? 0. : 1. / matrix.entry(i, i);
            for (unsigned int k = 1; k <= std::min(i, degree); ++k)
              factors.multipliers[(k - 1) * n_places + place] =
                matrix.entry(i, i - k);
          }
      }
  }



  template <int dim, typename Number>
  void
  SubspaceFactors<dim, Number>::compute_energies(
    const Family        &family,
    std::vector<Number> &inverse) const
  {
    inverse.clear();
    const SplineAxis<Number> &a = spaces.axis(family.a),
                             &b = spaces.axis(family.b);
    const unsigned int n_c = spaces.n_nodes(family.c), m_a = a.integrals.size(),
                       m_b = b.integrals.size();
    std::vector<double> of_nodes, of_half(family.of_a.size()),
      sum(m_a * m_b * n_c);
    const auto add = [&](const std::vector<unsigned int> &entries,
                         const Band<double>              &of_a,
                         const Band<double>              &of_b) {
      of_nodes.clear();
      for (const unsigned int entry : entries)
        of_nodes.push_back(rest.local_element(entry));
      multiply_band<false>(
        of_b, a.n_nodes, n_c, of_nodes.data(), of_half.data());
      multiply_band<true>(of_a, 1, m_b * n_c, of_half.data(), sum.data());
    };
    add(family.of_a, squared(a.value_transposed), squared(b.slope_transposed));
    add(family.of_b, squared(a.slope_transposed), squared(b.value_transposed));
    for (std::size_t i = 0; i < sum.size(); ++i)
      {
        const auto &f         = a.integrals[i / n_c / m_b],
                   &g         = b.integrals[i / n_c % m_b];
        const auto   across   = spaces.diagonals(family.c, i % n_c);
        const double in_plane = 2. * f.square_of_slope * g.square_of_slope +
                                0.5 * (f.square * g.square_of_curvature +
                                       f.square_of_curvature * g.square) -
                                f.with_curvature * g.with_curvature;
        const double between =
          0.5 * (f.square * g.square_of_slope + f.square_of_slope * g.square);
        // with three dimensions a flow is in two families
        inverse.push_back(
          sum[i] > Tolerances::energy_of_held ?
            0. :
            1. / ((dim - 1) *
                  (stiffness * spaces.material.two_mu *
                     (in_plane * across.mass + between * across.stiffness) +
                   sum[i])));
      }
  }



  template <int dim, typename Number>
  void
  SubspaceFactors<dim, Number>::apply(const Family  &family,
                                      const Factors &factors,
                                      const Number  *vector) const
  {
    const SplineAxis<Number> &a = spaces.axis(family.a),
                             &b = spaces.axis(family.b);
    const unsigned int n_c = spaces.n_nodes(family.c), n_a = a.n_nodes;
    const std::size_t  n_places = family.of_a.size(), n_lines = n_places / n_a;
    const std::size_t  of_half = b.integrals.size() * n_c;
    values_a.assign(n_places + 2 * a.degree * n_lines, Number());
    Number *const of_a = &values_a[a.degree * n_lines];
    Number *const of_b = values_b.data(), *const flow = flows.data(),
                  *const other = other_flows.data();
    const auto gather = [vector](const std::vector<unsigned int> &entries,
                                 Number                          *values) {
      for (std::size_t i = 0; i < entries.size(); ++i)
        values[i] = vector[entries[i]];
    };
    const auto add = [this](const std::vector<unsigned int> &entries,
                            const Number                    *values) {
      for (std::size_t i = 0; i < entries.size(); ++i)
        sum[entries[i]] += values[i];
    };
    gather(family.of_a, of_a);
    if (family.has_flows)
      {
        // the curl of f(a) g(b) is (f g', - f' g)
        gather(family.of_b, of_b);
        multiply_band<false>(b.slope_transposed, n_a, n_c, of_a, half.data());
        multiply_band<false>(a.value_transposed, 1, of_half, half.data(), flow);
        multiply_band<false>(b.value_transposed, n_a, n_c, of_b, half.data());
        multiply_band<false>(
          a.slope_transposed, 1, of_half, half.data(), other);
        for (std::size_t i = 0; i < factors.inverse_energies.size(); ++i)
          {
            flow[i]  = factors.inverse_energies[i] * (flow[i] - other[i]);
            other[i] = -flow[i];
          }
      }
    const auto solve_lines =
      a.degree == 2 ? solve<2, Number> : solve<0, Number>;
    solve_lines(a.degree,
                n_a,
                n_lines,
                factors.multipliers.data(),
                factors.inverse_pivots.data(),
                of_a);
    if (family.has_flows)
      {
        multiply_band<false>(a.value, 1, of_half, flow, half.data());
        multiply_band<true>(b.slope, n_a, n_c, half.data(), of_a);
        multiply_band<false>(a.slope, 1, of_half, other, half.data());
        multiply_band<false>(b.value, n_a, n_c, half.data(), of_b);
        add(family.of_b, of_b);
      }
    add(family.of_a, of_a);
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
    LevelVector<Number> &shared = whole ? *whole : vector;
    std::fill(sum.begin(), sum.end(), Number());
    for (unsigned int p = 0; p < factors.size(); ++p)
      apply(spaces.families[p], factors[p], shared.begin());
    if (whole)
      whole->zero_out_ghost_values();
    std::copy(sum.begin(), sum.end(), shared.begin());
    if (whole)
      {
        whole->compress(VectorOperation::add);
        copy_values(vector, *whole);
      }
  }



  template struct SplineAxis<float>;
  template struct SplineAxis<double>;
  template class LevelSubspaces<2, float>;
  template class LevelSubspaces<2, double>;
  template class LevelSubspaces<3, float>;
  template class LevelSubspaces<3, double>;
  template class SubspaceFactors<2, float>;
  template class SubspaceFactors<2, double>;
  template class SubspaceFactors<3, float>;
  template class SubspaceFactors<3, double>;
} // namespace ThermoContact
