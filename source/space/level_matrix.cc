// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/level_matrix.h>

#include <algorithm>
#include <initializer_list>

namespace ThermoContact
{
  template <int dim, typename Number>
  LevelMatrix<dim, Number>::LevelMatrix(const Scene          &scene,
                                        const Geometry<dim>  &geometry,
                                        const LevelGrid<dim> &grid,
                                        const Entries        *of_body)
    : grid(grid)
    , degree(grid.degree())
    , width(2 * degree + 1)
    , n_plane(grid.strides()[0])
    , length((n_plane + n_lanes - 1) / n_lanes * n_lanes)
    , stride(length +
             (degree * grid.strides()[1] + n_lanes) / n_lanes * n_lanes)
  {
    if (of_body != nullptr)
      entries = *of_body;
    else
      for (const Field::Block field : all_fields)
        for (unsigned int node = 0; node < grid.n_nodes(); ++node)
          entries[field].push_back(n_components<dim>(field) * node);
    integrate(geometry,
              scene.material,
              false,
              of_body != nullptr && scene.contact.has_massless_nodes);
    integrate(geometry, scene.material, true, false);
    make_sums(scene.material, of_body == nullptr || !scene.has_lumped_mass);
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::integrate(const Geometry<dim> &geometry,
                                      const Material      &material,
                                      const bool           is_across,
                                      const bool           has_massless_nodes)
  {
    const std::vector<double>   &x    = grid.positions(is_across);
    std::array<Banded, n_kinds> &axis = axes[is_across];
    for (Banded &matrix : axis)
      matrix.assign(width, std::vector<double>(x.size()));
    visit_products(x, degree, [&](const BasisProduct &at) {
      Point<dim> point;
      point[1] = at.x;
      const double weight =
        at.weight * (is_across ? geometry.weight_at(point) : 1.);
      const double across =
        is_across ? geometry.strain_per_displacement(point) : 0.;
      const auto add_to = [&](const Kind kind, const double value) {
        axis[kind][degree + at.j - at.i][at.i] += value;
      };
      const auto add = [&](const Kind kind, const double value) {
        add_to(kind, weight * value);
      };
      const auto &[value, slope]             = at.of_i;
      const auto &[other_value, other_slope] = at.of_j;
      const double hoop = across * value, other_hoop = across * other_value;
      const double strain       = slope + hoop,
                   other_strain = other_slope + other_hoop;
      add_to(mass_of_mesh, at.weight * value * other_value);
      add_to(gradients_of_mesh, at.weight * slope * other_slope);
      add(mass_of_all, value * other_value);
      if (!has_massless_nodes || at.x < x[x.size() - 1 - degree])
        add(mass_of_axial, value * other_value);
      add(gradients, slope * other_slope);
      add(normal,
          material.lambda * strain * other_strain +
            material.two_mu * (slope * other_slope + hoop * other_hoop));
      add(gradient, value * other_slope);
      add(of_test, slope * other_value);
      add(dilatation, value * other_strain);
      add(of_test_dilatation, strain * other_value);
    });
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::make_sums(const Material &material,
                                      const bool      has_mass)
  {
    const auto add =
      [&](const Operator                                              op,
          const unsigned int                                          row,
          const unsigned int                                          column,
          const double                                                factor,
          const std::initializer_list<std::pair<unsigned int, Kind>> &kinds,
          const Kind                                                  mass) {
        std::array<Kind, dim> of;
        of.fill(op == laplacian ? mass_of_mesh : mass_of_all);
        for (const auto &[direction, kind] : kinds)
          of[direction] = kind;
        std::vector<Line> &lines = sums[op].lines;
        const Line line{column, of[0], has_mass ? mass : nothing, factor};
        const unsigned int number =
          std::find_if(lines.begin(),
                       lines.end(),
                       [&](const Line &other) {
                         return other.column == line.column &&
                                other.kind == line.kind &&
                                other.mass == line.mass;
                       }) -
          lines.begin();
        if (number == lines.size())
          lines.push_back(line);
        sums[op].terms[{row, of[dim - 1]}].push_back({number, factor, of[1]});
      };
    const double mu = 0.5 * material.two_mu;
    for (unsigned int c = 0; c < dim; ++c)
      {
        const Kind mass = c == 0 ? mass_of_all : nothing;
        add(heat, 0, 0, 1., {{c, gradients}}, mass);
        add(laplacian, 0, 0, 1., {{c, gradients_of_mesh}}, nothing);
        add(divergence, 0, c, 1., {{c, dilatation}}, nothing);
        add(thermal_stress, c, 0, 1., {{c, of_test_dilatation}}, nothing);
        add(
          momentum, c, c, 1., {{c, normal}}, c == 0 ? mass_of_axial : nothing);
        for (unsigned int d = 0; d < dim; ++d)
          if (d != c)
            {
              add(momentum, d, d, mu, {{c, gradients}}, mass);
              add(momentum,
                  c,
                  d,
                  material.lambda,
                  {{c, of_test_dilatation}, {d, dilatation}},
                  nothing);
              add(momentum, c, d, mu, {{c, gradient}, {d, of_test}}, nothing);
            }
      }
  }



  template <int dim, typename Number>
  LevelVector<Number>
  LevelMatrix<dim, Number>::make_vector(const Field::Block field) const
  {
    return LevelVector<Number>(grid.n_nodes() * n_components<dim>(field));
  }



  template <int dim, typename Number>
  double
  LevelMatrix<dim, Number>::diagonal_entry(
    const Operator                        op,
    const unsigned int                    row,
    const typename LevelGrid<dim>::Index &index,
    const double                          mass,
    const double                          stiffness) const
  {
    double     result = 0.;
    const Sum &sum    = sums[op];
    for (const auto &[place, terms] : sum.terms)
      for (const Term &term : terms)
        if (const Line &line = sum.lines[term.line];
            place.first == row && line.column == row)
          result +=
            scale(line, term, stiffness) *
            along(line, mass, stiffness, degree, index[0]) *
            axes[1][term.kind][degree][index[1]] *
            (dim == 3 ? axes[1][place.second][degree][index[dim - 1]] : 1.);
    return result;
  }



  template <int dim, typename Number>
  LevelVector<Number>
  LevelMatrix<dim, Number>::diagonal(const Field::Block field,
                                     const double       mass,
                                     const double       stiffness) const
  {
    LevelVector<Number> result = make_vector(field);
    for (unsigned int node = 0; node < grid.n_nodes(); ++node)
      for (unsigned int c = 0; c < n_components<dim>(field); ++c)
        result.local_element(entries[field][node] + c) =
          diagonal_entry(of(field), c, grid.index(node), mass, stiffness);
    return result;
  }



  template <int dim, typename Number>
  unsigned int
  LevelMatrix<dim, Number>::band(const Field::Block field) const
  {
    unsigned int nodes = 0;
    for (const unsigned int to_next : grid.strides())
      nodes += degree * to_next;
    return (nodes + 1) * n_components<dim>(field) - 1;
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::prepare_planes() const
  {
    Assert(degree <= 2, ExcNotImplemented());
    scratch.resize(stride *
                   (dim + 1 + max_lines +
                    dim * (grid.positions(0).size() + 2 * degree) + 1));
    coefficients.resize(std::size_t(dim - 1) * n_kinds * width * length);
    for (unsigned int d = 1; d < dim; ++d)
      for (unsigned int kind = 0; kind < n_kinds; ++kind)
        for (unsigned int k = 0; k < width; ++k)
          for (unsigned int node = 0; node < n_plane; ++node)
            coefficients[coefficient(d, Kind(kind)) + k * length + node] =
              axes[1][kind][k][grid.index(node)[d]];
  }



  namespace
  {
    /**
     * @p to = or += @p factor times coefficients times @p width neighbours, from
     * the one that @p from is the place of, @p stride places to the next.
     *
     * @param coefficient of a neighbour and a batch of nodes
     */
    template <unsigned int width, typename Number, typename Coefficient>
    void
    add_neighbours(const Coefficient &coefficient,
                   const Number      *from,
                   const std::size_t  stride,
                   const unsigned int length,
                   const Number       factor,
                   Number            *to,
                   const bool         is_first)
    {
      using Batched = Lanes<Number>;
      for (unsigned int i = 0; i < length; i += Batched::n_lanes)
        {
          Batched sum{};
          for (unsigned int k = 0; k < width; ++k)
            sum += Batched::load(from + k * stride + i) * coefficient(k, i);
          Batched result = is_first ? Batched{} : Batched::load(to + i);
          result += sum * factor;
          result.store(to + i);
        }
    }
  } // namespace



  template <int dim, typename Number>
  template <unsigned int width>
  void
  LevelMatrix<dim, Number>::add_planes(const Operator op,
                                       const double   mass,
                                       const double   stiffness,
                                       Number        *y,
                                       const Number  *x,
                                       const bool     replaces) const
  {
    const Field::Block from = op == heat || op == thermal_stress ?
                                Field::temperature :
                                Field::displacement;
    const Field::Block to =
      op == heat || op == divergence ? Field::temperature : Field::displacement;
    const unsigned int n_planes = grid.positions(0).size();
    const auto         plane    = [&](const unsigned int i) {
      return scratch.data() + i * stride + stride - length;
    };
    // the first and the last lines of a component are not there: zero
    const auto first_of = [&](const unsigned int component) {
      return dim + 1 + max_lines + component * (n_planes + 2 * degree);
    };
    for (unsigned int i = 0; i < n_planes; ++i)
      for (unsigned int c = 0; c < n_components<dim>(from); ++c)
        {
          const unsigned int *const entry  = &entries[from][i * n_plane];
          Number *const             values = plane(first_of(c) + degree + i);
          for (unsigned int node = 0; node < n_plane; ++node)
            values[node] = x[entry[node] + c];
        }
    const auto strides = grid.strides();
    const auto across  = [&](const unsigned int direction,
                            const Kind         kind,
                            const Number      *values,
                            const Number       factor,
                            Number            *sum,
                            const bool         is_first) {
      const Number *const of_nodes =
        &coefficients[coefficient(direction, kind)];
      add_neighbours<width>(
        [&](const unsigned int k, const unsigned int node) {
          return Lanes<Number>::load(of_nodes + k * length + node);
        },
        values - degree * strides[direction],
        strides[direction],
        length,
        factor,
        sum,
        is_first);
    };
    const Sum    &sum   = sums[op];
    Number *const sheet = plane(dim);
    for (unsigned int i = 0; i < n_planes; ++i)
      {
        for (unsigned int l = 0; l < sum.lines.size(); ++l)
          {
            std::array<Number, width> factors;
            for (unsigned int k = 0; k < width; ++k)
              factors[k] = along(sum.lines[l], mass, stiffness, k, i);
            add_neighbours<width>(
              [&](const unsigned int k, const unsigned int) {
                return factors[k];
              },
              plane(first_of(sum.lines[l].column) + i),
              stride,
              length,
              Number(1),
              plane(dim + 1 + l),
              true);
          }
        std::fill_n(plane(0), n_components<dim>(to) * stride, Number());
        for (const auto &[place, terms] : sum.terms)
          {
            bool is_first = true;
            for (const Term &term : terms)
              {
                across(1,
                       term.kind,
                       plane(dim + 1 + term.line),
                       scale(sum.lines[term.line], term, stiffness),
                       dim == 3 ? sheet : plane(place.first),
                       dim == 3 && is_first);
                is_first = false;
              }
            if (dim == 3)
              across(2, place.second, sheet, 1, plane(place.first), false);
          }
        const unsigned int *const entry = &entries[to][i * n_plane];
        for (unsigned int c = 0; c < n_components<dim>(to); ++c)
          for (unsigned int node = 0; node < n_plane; ++node)
            y[entry[node] + c] =
              (replaces ? Number() : y[entry[node] + c]) + plane(c)[node];
      }
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::add(const Operator op,
                                const double   mass,
                                const double   stiffness,
                                Number        *y,
                                const Number  *x,
                                const bool     replaces) const
  {
    if (scratch.empty())
      prepare_planes();
    if (degree == 1)
      add_planes<3>(op, mass, stiffness, y, x, replaces);
    else
      add_planes<5>(op, mass, stiffness, y, x, replaces);
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::vmult(const Field::Block         field,
                                  const double               mass,
                                  const double               stiffness,
                                  LevelVector<Number>       &y,
                                  const LevelVector<Number> &x) const
  {
    add(of(field), mass, stiffness, y.begin(), x.begin(), true);
  }



  template class LevelMatrix<2, float>;
  template class LevelMatrix<2, double>;
  template class LevelMatrix<3, float>;
  template class LevelMatrix<3, double>;
} // namespace ThermoContact
