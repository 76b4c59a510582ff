// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/level_matrix.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <map>

namespace ThermoContact
{
  namespace
  {
    /** Between the nodes of a cell, those along the first direction first. */
    struct ElementMatrices
    {
      unsigned int                       n_nodes;
      std::vector<double>                mass;
      std::array<std::vector<double>, 2> stiffness;

      /** Of components @p c and @p e of @p n at nodes @p i and @p j. */
      std::size_t
      index(const unsigned int n,
            const unsigned int i,
            const unsigned int c,
            const unsigned int j,
            const unsigned int e) const
      {
        return ((std::size_t(i) * n + c) * n_nodes + j) * n + e;
      }
    };



    /** @param first node of a cell */
    template <int dim>
    ElementMatrices
    element_matrices(const Scene                          &scene,
                     const Geometry<dim>                  &geometry,
                     const LevelGrid<dim>                 &grid,
                     const typename LevelGrid<dim>::Index &first)
    {
      const unsigned int n_line = grid.degree() + 1;
      const unsigned int n      = power_of(n_line, dim);
      ElementMatrices    matrices{n, {}, {}};
      matrices.mass.resize(n * n);
      matrices.stiffness[Field::temperature].resize(n * n);
      matrices.stiffness[Field::displacement].resize(n * n * dim * dim);
      const QGauss<dim>      rule(n_line);
      const Point<dim>       corner    = grid.node(first);
      constexpr unsigned int n_strains = 7; // trace, normal and shear strains
      std::vector<double>    values(n), gradients(dim * n),
        strains(n_strains * dim * n);
      const auto add = [&](std::vector<double> &matrix,
                           const double         factor,
                           const double        *rows,
                           const unsigned int   n_entries) {
        for (unsigned int i = 0; i < n_entries; ++i)
          for (unsigned int j = 0; j < n_entries; ++j)
            matrix[i * n_entries + j] += factor * rows[i] * rows[j];
      };
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          Point<dim> point;
          double     weight = rule.weight(q);
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double size =
                grid.positions(d)[first[d] + n_line - 1] - corner[d];
              point[d] = corner[d] + rule.point(q)[d] * size;
              weight *= size;
            }
          weight *= geometry.weight_at(point);
          for (unsigned int i = 0; i < n; ++i)
            {
              double         product = 1.;
              Tensor<1, dim> slopes;
              for (unsigned int d = 0; d < dim; ++d)
                slopes[d] = 1.;
              for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n_line)
                {
                  const ValueAndSlope along =
                    lagrange(&grid.positions(d)[first[d]],
                             n_line - 1,
                             rest % n_line,
                             point[d]);
                  product *= along.value;
                  for (unsigned int e = 0; e < dim; ++e)
                    slopes[e] *= d == e ? along.slope : along.value;
                }
              values[i] = product;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  Tensor<2, dim> gradient;
                  Tensor<1, dim> value;
                  gradient[c]          = slopes;
                  value[c]             = product;
                  gradients[c * n + i] = slopes[c];
                  const Strain strain = geometry.strain(gradient, value, point);
                  double *const to    = &strains[i * dim + c];
                  to[0]               = strain.trace;
                  for (unsigned int k = 0; k < 6; ++k)
                    to[(k + 1) * dim * n] = strain.tensor.access_raw_entry(k);
                }
            }
          add(matrices.mass, weight, values.data(), n);
          for (unsigned int d = 0; d < dim; ++d)
            add(matrices.stiffness[Field::temperature],
                weight,
                &gradients[d * n],
                n);
          // elastic_product()
          for (unsigned int k = 0; k < n_strains; ++k)
            add(matrices.stiffness[Field::displacement],
                weight * (k == 0 ? scene.material.lambda :
                          k <= 3 ? scene.material.two_mu :
                                   2. * scene.material.two_mu),
                &strains[k * dim * n],
                dim * n);
        }
      return matrices;
    }



    /** For each cell of an axis, the first node of the first such cell. */
    std::vector<unsigned int>
    first_of_same(const std::vector<double> &nodes, const unsigned int degree)
    {
      const auto are_equal = [&](const unsigned int i, const unsigned int j) {
        for (unsigned int k = 1; k <= degree; ++k)
          if (std::abs(nodes[i + k] - nodes[i] - nodes[j + k] + nodes[j]) >
              Tolerances::rounding_of_data * nodes.back())
            return false;
        return true;
      };
      std::vector<unsigned int> first;
      for (unsigned int i = 0; i + 1 < nodes.size(); i += degree)
        {
          unsigned int j = 0;
          while (!are_equal(j, i))
            j += degree;
          first.push_back(j);
        }
      return first;
    }
  } // namespace



  template <int dim, typename Number>
  LevelMatrix<dim, Number>::LevelMatrix(
    const Scene               &scene,
    const Discretization<dim> &discretization,
    const LevelGrid<dim>      &grid)
    : degree(grid.degree())
    , reach(2 * degree + 1)
    , n_line(grid.positions(dim - 1).size())
    , n_lines(grid.n_nodes() / n_line)
    , length((n_line + n_lanes - 1) / n_lanes * n_lanes)
  {
    using Index                   = typename LevelGrid<dim>::Index;
    const Geometry<dim> &geometry = discretization.geometry();
    const std::array<std::vector<unsigned int>, 2> same{
      {first_of_same(grid.positions(0), degree),
       first_of_same(grid.positions(1), degree)}};
    std::map<Index, ElementMatrices> cells;
    const auto cell_of = [&](Index first) -> const ElementMatrices & {
      for (unsigned int d = 0; d < dim; ++d)
        if (geometry.has_uniform_weight() || d == 0)
          first[d] = same[d > 0][first[d] / degree];
      const auto known = cells.find(first);
      return known != cells.end() ?
               known->second :
               cells
                 .emplace(first,
                          element_matrices<dim>(scene, geometry, grid, first))
                 .first->second;
    };

    // lines are alike if they are at the same place between the same cells
    constexpr unsigned int                                           none = -1;
    std::map<std::array<unsigned int, 6>, std::vector<unsigned int>> alike;
    for (unsigned int line = 0; line < n_lines; ++line)
      {
        std::array<unsigned int, 6> key{};
        const Index                 place = grid.index(line * n_line);
        for (unsigned int d = 0; d + 1 < dim; ++d)
          {
            const unsigned int i = place[d];
            key[3 * d]           = i % degree;
            key[3 * d + 1] = i == 0 ? none : same[d > 0][(i - 1) / degree];
            key[3 * d + 2] = i + 1 == grid.positions(d).size() ?
                               none :
                               same[d > 0][i / degree];
          }
        alike[key].push_back(line);
      }
    for (const auto &[key, lines] : alike)
      {
        Kind kind{lines, {}, {}, {}};
        kind.mass.resize(power_of(reach, dim - 1) * reach * length);
        for (const Field::Block field : all_fields)
          if (discretization.has_field(field))
            kind.stiffness[field].resize(kind.mass.size() *
                                         power_of(n_components(field), 2));
        add_cells(grid, cell_of, kind);
        kinds.push_back(std::move(kind));
      }
  }



  template <int dim, typename Number>
  template <typename CellOf>
  void
  LevelMatrix<dim, Number>::add_cells(const LevelGrid<dim> &grid,
                                      const CellOf         &cell_of,
                                      Kind                 &kind) const
  {
    const unsigned int          n_own = power_of(degree + 1, dim - 1);
    const auto                  place = grid.index(kind.lines[0] * n_line);
    std::map<unsigned int, int> neighbours; // offsets
    for (unsigned int own = 0; own < n_own; ++own)
      {
        // the line is at this place of cells that begin at
        auto first   = place;
        bool is_cell = true;
        for (unsigned int d = 0, rest = own; d + 1 < dim;
             ++d, rest /= degree + 1)
          {
            const unsigned int at = rest % (degree + 1);
            is_cell               = is_cell && first[d] >= at &&
                      (first[d] - at) % degree == 0 &&
                      first[d] - at + 1 < grid.positions(d).size();
            first[d] -= at;
          }
        for (; is_cell && first[dim - 1] + 1 < n_line; first[dim - 1] += degree)
          {
            const auto &cell = cell_of(first);
            for (unsigned int i = own; i < cell.n_nodes; i += n_own)
              for (unsigned int j = 0; j < cell.n_nodes; ++j)
                {
                  Neighbour neighbour{0, 0};
                  for (unsigned int d = 0, from = i, to = j; d + 1 < dim;
                       ++d, from /= degree + 1, to /= degree + 1)
                    {
                      const int step =
                        int(to % (degree + 1)) - int(from % (degree + 1));
                      neighbour.number =
                        reach * neighbour.number + step + degree;
                      neighbour.offset +=
                        step * int(grid.strides()[d] / n_line);
                    }
                  neighbours[neighbour.number] = neighbour.offset;
                  const unsigned int row       = i / n_own;
                  const unsigned int k         = degree + j / n_own - row;
                  const unsigned int node      = first[dim - 1] + row;
                  kind.mass[index(1, neighbour.number, 0, k, 0, node)] +=
                    cell.mass[i * cell.n_nodes + j];
                  for (const Field::Block field : all_fields)
                    for (unsigned int c = 0, n = n_components(field); c < n;
                         ++c)
                      for (unsigned int e = 0; e < n; ++e)
                        if (!kind.stiffness[field].empty())
                          kind.stiffness[field][index(
                            n, neighbour.number, c, k, e, node)] +=
                            cell.stiffness[field][cell.index(n, i, c, j, e)];
                }
          }
      }
    for (const auto &[number, offset] : neighbours)
      kind.neighbours.push_back({number, offset});
  }



  template <int dim, typename Number>
  LevelVector<Number>
  LevelMatrix<dim, Number>::make_vector(const Field::Block field) const
  {
    return LevelVector<Number>(n_lines * n_line * n_components(field));
  }



  template <int dim, typename Number>
  template <unsigned int n, typename Visit>
  void
  LevelMatrix<dim, Number>::visit_values(const Visit &visit) const
  {
    for (unsigned int line = 0, i = 0; line < n_lines; ++line)
      for (unsigned int node = 0; node < n_line; ++node)
        for (unsigned int c = 0; c < n; ++c, ++i)
          visit(i, (c * n_lines + line) * length + node);
  }



  template <int dim, typename Number>
  template <unsigned int n>
  void
  LevelMatrix<dim, Number>::multiply(const Field::Block         field,
                                     const double               mass,
                                     const double               stiffness,
                                     LevelVector<Number>       &y,
                                     const LevelVector<Number> &x) const
  {
    using Batched            = Lanes<Number>;
    const std::size_t stride = n_lines * length; // of a component
    const auto fill = [&](std::vector<Number> &lines, const double factor) {
      lines.assign(n * stride + 2 * n_lanes, Number());
      visit_values<n>([&](const unsigned int i, const std::size_t place) {
        lines[n_lanes + place] = Number(factor) * x.local_element(i);
      });
    };
    fill(of_stiffness, stiffness);
    if (mass > 0.)
      fill(of_mass, mass);
    sums.resize(n * stride);
    const std::size_t of_component = reach * n * length;
    for (const Kind &kind : kinds)
      for (const unsigned int line : kind.lines)
        for (unsigned int node = 0; node < length; node += n_lanes)
          {
            std::array<Batched, n> total{};
            for (const Neighbour &neighbour : kind.neighbours)
              {
                const std::size_t beside =
                  n_lanes + (line + neighbour.offset) * length + node - degree;
                const Number *s =
                  &kind.stiffness[field]
                                 [index(n, neighbour.number, 0, 0, 0, node)];
                const Number *const xs = &of_stiffness[beside];
                for (unsigned int k = 0; k < reach; ++k)
                  for (unsigned int e = 0; e < n; ++e, s += length)
                    {
                      const Batched x = Batched::load(xs + e * stride + k);
                      for (unsigned int c = 0; c < n; ++c)
                        total[c] += Batched::load(s + c * of_component) * x;
                    }
                if (mass == 0.)
                  continue;
                const Number *const m =
                  &kind.mass[index(1, neighbour.number, 0, 0, 0, node)];
                const Number *const xm = &of_mass[beside];
                for (unsigned int k = 0; k < reach; ++k)
                  for (unsigned int c = 0; c < n; ++c)
                    total[c] += Batched::load(m + k * length) *
                                Batched::load(xm + c * stride + k);
              }
            for (unsigned int c = 0; c < n; ++c)
              total[c].store(&sums[c * stride + line * length + node]);
          }
    Number *const to = y.begin();
    visit_values<n>([&](const unsigned int i, const std::size_t place) {
      to[i] = sums[place];
    });
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::vmult(const Field::Block         field,
                                  const double               mass,
                                  const double               stiffness,
                                  LevelVector<Number>       &y,
                                  const LevelVector<Number> &x) const
  {
    if (field == Field::temperature)
      multiply<1>(field, mass, stiffness, y, x);
    else
      multiply<dim>(field, mass, stiffness, y, x);
  }



  template class LevelMatrix<2, float>;
  template class LevelMatrix<2, double>;
  template class LevelMatrix<3, float>;
  template class LevelMatrix<3, double>;
} // namespace ThermoContact
