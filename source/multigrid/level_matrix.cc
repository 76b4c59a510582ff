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
    /** What a basis function is at a quadrature point. */
    template <int dim>
    struct BasisPoint
    {
      double                  value;
      Tensor<1, dim>          gradient;
      std::array<Strain, dim> strains; ///< of a displacement along each axis
    };



    /**
     * @param corner its node; bit d: the upper one along direction d
     * @param place in the unit cell
     * @param point in the body
     * @param size of the cell
     */
    template <int dim>
    BasisPoint<dim>
    basis_at(const Geometry<dim>  &geometry,
             const unsigned int    corner,
             const Point<dim>     &place,
             const Point<dim>     &point,
             const Tensor<1, dim> &size)
    {
      BasisPoint<dim> basis{1., {}, {}};
      for (unsigned int d = 0; d < dim; ++d)
        {
          const bool is_upper = (corner >> d & 1U) != 0;
          basis.value *= is_upper ? place[d] : 1. - place[d];
          basis.gradient[d] = is_upper ? 1. / place[d] : -1. / (1. - place[d]);
        }
      for (unsigned int d = 0; d < dim; ++d)
        basis.gradient[d] *= basis.value / size[d];
      for (unsigned int c = 0; c < dim; ++c)
        {
          Tensor<2, dim> gradient;
          Tensor<1, dim> value;
          gradient[c]      = basis.gradient;
          value[c]         = basis.value;
          basis.strains[c] = geometry.strain(gradient, value, point);
        }
      return basis;
    }



    /**
     * For each of the positions, the first one with the same distances to the
     * next ones on both sides.
     */
    std::vector<unsigned int>
    first_of_same(const std::vector<double> &positions)
    {
      const auto distance = [&](const unsigned int i) {
        return i == 0 || i == positions.size() ?
                 0. :
                 positions[i] - positions[i - 1];
      };
      const auto are_equal = [&](const unsigned int i, const unsigned int j) {
        return std::abs(distance(i) - distance(j)) <=
               Tolerances::rounding_of_data * (distance(i) + distance(j));
      };
      std::vector<unsigned int> first;
      for (unsigned int i = 0; i < positions.size(); ++i)
        {
          unsigned int j = 0;
          while (!are_equal(j, i) || !are_equal(j + 1, i + 1))
            ++j;
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
    : n_line(grid.positions(dim - 1).size())
    , n_lines(grid.n_nodes() / n_line)
    , length((n_line + n_lanes - 1) / n_lanes * n_lanes)
  {
    const auto along  = first_of_same(grid.positions(0)),
               across = first_of_same(grid.positions(dim - 1));
    std::map<std::array<unsigned int, 2>, std::vector<unsigned int>> same;
    for (unsigned int line = 0; line < n_lines; ++line)
      {
        const auto place = grid.index(line * n_line);
        same[{{along[place[0]], dim == 3 ? across[place[1]] : 0}}].push_back(
          line);
      }
    for (const auto &[first, lines] : same)
      {
        Kind kind{lines, {}, {}, {}};
        kind.mass.resize(power_of(3, dim) * length);
        for (const Field::Block field : all_fields)
          if (discretization.has_field(field))
            kind.stiffness[field].resize(kind.mass.size() *
                                         power_of(n_components(field), 2));
        add_cells(scene, discretization.geometry(), grid, kind);
        kinds.push_back(kind);
      }
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::add_cells(const Scene          &scene,
                                      const Geometry<dim>  &geometry,
                                      const LevelGrid<dim> &grid,
                                      Kind                 &kind) const
  {
    constexpr unsigned int n_corners = 1U << dim, upper_end = n_corners / 2;
    const auto             place = grid.index(kind.lines[0] * n_line);
    const QGauss<dim>      rule(2);
    std::vector<Number>   &conduction = kind.stiffness[Field::temperature];
    std::vector<Number>   &elasticity = kind.stiffness[Field::displacement];
    std::map<unsigned int, int> neighbours; // offsets
    for (unsigned int own = 0; own < upper_end; ++own)
      {
        // the line is at this corner of cells that begin at
        auto first   = place;
        bool is_cell = true;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          {
            const unsigned int upper = own >> d & 1U;
            is_cell                  = is_cell && first[d] >= upper &&
                      first[d] - upper + 1 < grid.positions(d).size();
            first[d] -= upper;
          }
        for (; is_cell && first[dim - 1] + 1 < n_line; ++first[dim - 1])
          {
            const Point<dim> corner = grid.node(first);
            double           volume = 1.;
            Tensor<1, dim>   size;
            for (unsigned int d = 0; d < dim; ++d)
              {
                size[d] = grid.positions(d)[first[d] + 1] - corner[d];
                volume *= size[d];
              }
            for (unsigned int q = 0; q < rule.size(); ++q)
              {
                Point<dim> point = corner;
                for (unsigned int d = 0; d < dim; ++d)
                  point[d] += rule.point(q)[d] * size[d];
                const double weight =
                  rule.weight(q) * volume * geometry.weight_at(point);
                std::array<BasisPoint<dim>, n_corners> basis;
                for (unsigned int i = 0; i < n_corners; ++i)
                  basis[i] = basis_at(geometry, i, rule.point(q), point, size);
                for (const unsigned int i : {own, own + upper_end})
                  for (unsigned int j = 0; j < n_corners; ++j)
                    {
                      Neighbour neighbour{0, 0};
                      for (unsigned int d = 0; d + 1 < dim; ++d)
                        {
                          const int step = int(j >> d & 1U) - int(i >> d & 1U);
                          neighbour.number = 3 * neighbour.number + step + 1;
                          neighbour.offset +=
                            step * int(grid.strides()[d] / n_line);
                        }
                      neighbours[neighbour.number] = neighbour.offset;
                      const unsigned int is_upper  = i / upper_end;
                      const unsigned int k   = 1 + j / upper_end - is_upper;
                      const auto         add = [&](std::vector<Number> &to,
                                           const unsigned int   n,
                                           const unsigned int   c,
                                           const unsigned int   e,
                                           const double         value) {
                        to[index(n, neighbour.number, c, k, e) * length +
                           first[dim - 1] + is_upper] += weight * value;
                      };
                      add(kind.mass, 1, 0, 0, basis[i].value * basis[j].value);
                      if (!conduction.empty())
                        add(conduction,
                            1,
                            0,
                            0,
                            basis[i].gradient * basis[j].gradient);
                      if (!elasticity.empty())
                        for (unsigned int c = 0; c < dim; ++c)
                          for (unsigned int e = 0; e < dim; ++e)
                            add(elasticity,
                                dim,
                                c,
                                e,
                                elastic_product(scene.material,
                                                basis[i].strains[c],
                                                basis[j].strains[e]));
                    }
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
  void
  LevelMatrix<dim, Number>::combine(const Kind        &kind,
                                    const Field::Block field,
                                    const double       mass,
                                    const double       stiffness) const
  {
    const unsigned int n = n_components(field);
    const Number       of_mass(mass), of_stiffness(stiffness);
    coefficients = kind.stiffness[field];
    for (Number &coefficient : coefficients)
      coefficient *= of_stiffness;
    for (const Neighbour &neighbour : kind.neighbours)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int c = 0; c < n; ++c)
          {
            const Number *const from =
              &kind.mass[index(1, neighbour.number, 0, k, 0) * length];
            Number *const to =
              &coefficients[index(n, neighbour.number, c, k, c) * length];
            for (unsigned int node = 0; node < length; ++node)
              to[node] += of_mass * from[node];
          }
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
    factors.assign(n * stride + 2 * n_lanes, Number());
    sums.assign(n * stride, Number());
    Number *const in           = factors.data() + n_lanes;
    const auto    visit_values = [&](const auto &visit) {
      for (unsigned int line = 0, i = 0; line < n_lines; ++line)
        for (unsigned int node = 0; node < n_line; ++node)
          for (unsigned int c = 0; c < n; ++c, ++i)
            visit(i, c * stride + line * length + node);
    };
    const Number *const from = x.begin();
    visit_values([&](const unsigned int i, const std::size_t place) {
      in[place] = from[i];
    });
    for (const Kind &kind : kinds)
      {
        combine(kind, field, mass, stiffness);
        for (const unsigned int line : kind.lines)
          for (const Neighbour &neighbour : kind.neighbours)
            for (unsigned int c = 0; c < n; ++c)
              {
                Number *const       sum = &sums[c * stride + line * length];
                const Number *const coefficient =
                  &coefficients[index(n, neighbour.number, c, 0, 0) * length];
                const Number *const beside =
                  in + (line + neighbour.offset) * length - 1;
                for (unsigned int node = 0; node < length; node += n_lanes)
                  {
                    Batched total = Batched::load(sum + node);
                    for (unsigned int k = 0; k < 3; ++k)
                      for (unsigned int e = 0; e < n; ++e)
                        total += Batched::load(coefficient +
                                               (k * n + e) * length + node) *
                                 Batched::load(beside + e * stride + node + k);
                    total.store(sum + node);
                  }
              }
      }
    Number *const to = y.begin();
    visit_values([&](const unsigned int i, const std::size_t place) {
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
