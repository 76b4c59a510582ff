// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/level_matrix.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <map>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    template <int dim>
    typename std::array<std::vector<unsigned int>, 2>
    entries_of_level(const LevelGrid<dim> &grid)
    {
      std::array<std::vector<unsigned int>, 2> entries;
      for (unsigned int node = 0; node < grid.n_nodes(); ++node)
        {
          entries[Field::temperature].push_back(node);
          entries[Field::displacement].push_back(dim * node);
        }
      return entries;
    }
  } // namespace



  template <int dim, typename Number>
  LevelMatrix<dim, Number>::LevelMatrix(const Scene          &scene,
                                        const Geometry<dim>  &geometry,
                                        const LevelGrid<dim> &grid)
    : LevelMatrix(scene, geometry, grid, entries_of_level(grid), true, false)
  {}



  template <int dim, typename Number>
  LevelMatrix<dim, Number>::LevelMatrix(const Scene          &scene,
                                        const Geometry<dim>  &geometry,
                                        const LevelGrid<dim> &grid,
                                        Entries               entries)
    : LevelMatrix(scene,
                  geometry,
                  grid,
                  std::move(entries),
                  !scene.has_lumped_mass,
                  scene.contact.has_massless_nodes)
  {}



  template <int dim, typename Number>
  LevelMatrix<dim, Number>::LevelMatrix(const Scene          &scene,
                                        const Geometry<dim>  &geometry,
                                        const LevelGrid<dim> &grid,
                                        Entries               entries,
                                        const bool            has_mass,
                                        const bool has_massless_nodes)
    : material(scene.material)
    , grid(grid)
    , degree(grid.degree())
    , width(2 * degree + 1)
    , has_mass(has_mass)
    , entries(std::move(entries))
    , n_plane(grid.strides()[0])
    , margin((degree * grid.strides()[1] + n_lanes) / n_lanes * n_lanes)
    , length((n_plane + n_lanes - 1) / n_lanes * n_lanes)
    , coefficients(std::size_t(dim - 1) * n_kinds * width * length)
  {
    Assert(degree <= 2, ExcNotImplemented());
    integrate(geometry, false, has_massless_nodes);
    integrate(geometry, true, false);
    for (unsigned int d = 1; d < dim; ++d)
      for (unsigned int kind = 0; kind < n_kinds; ++kind)
        for (unsigned int k = 0; k < width; ++k)
          for (unsigned int node = 0; node < n_plane; ++node)
            coefficients[coefficient(d, Kind(kind)) + k * length + node] =
              axes[1][kind][k][grid.index(node)[d]];
    for (const Operator op : {heat, momentum, divergence, thermal_stress})
      plans[op] = make_plan(op);
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::integrate(const Geometry<dim> &geometry,
                                      const bool           is_across,
                                      const bool           has_massless_nodes)
  {
    const std::vector<double>   &x = grid.positions(is_across);
    const QGauss<1>              rule(degree + 1);
    std::array<Banded, n_kinds> &axis = axes[is_across];
    for (Banded &matrix : axis)
      matrix.assign(width, std::vector<double>(x.size()));
    std::vector<ValueAndSlope> basis(degree + 1);
    for (unsigned int first = 0; first + 1 < x.size(); first += degree)
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const double size = x[first + degree] - x[first];
          Point<dim>   point;
          point[1]            = x[first] + rule.point(q)[0] * size;
          const double weight = rule.weight(q) * size *
                                (is_across ? geometry.weight_at(point) : 1.);
          const double across =
            is_across ? geometry.strain_per_displacement(point) : 0.;
          for (unsigned int i = 0; i <= degree; ++i)
            basis[i] = lagrange(&x[first], degree, i, point[1]);
          for (unsigned int i = 0; i <= degree; ++i)
            for (unsigned int j = 0; j <= degree; ++j)
              {
                const auto add = [&](const Kind kind, const double value) {
                  axis[kind][degree + j - i][first + i] += weight * value;
                };
                const auto &[value, slope]             = basis[i];
                const auto &[other_value, other_slope] = basis[j];
                const double strain                    = slope + across * value;
                const double other_strain = other_slope + across * other_value;
                add(mass_of_all, value * other_value);
                if (!has_massless_nodes || first + degree + 1 < x.size())
                  add(mass_of_axial, value * other_value);
                add(gradients, slope * other_slope);
                add(normal,
                    material.lambda * strain * other_strain +
                      material.two_mu *
                        (slope * other_slope +
                         across * value * across * other_value));
                add(gradient, value * other_slope);
                add(of_test, slope * other_value);
                add(dilatation, value * other_strain);
                add(of_test_dilatation, strain * other_value);
              }
        }
  }



  template <int dim, typename Number>
  std::vector<typename LevelMatrix<dim, Number>::Term>
  LevelMatrix<dim, Number>::terms(const Operator op) const
  {
    std::vector<Term> result;
    const auto        add = [&](const unsigned int row,
                         const unsigned int column,
                         const double       mass,
                         const double       stiffness,
                         const auto        &set_kinds) {
      Term term{row, column, {}, mass, stiffness};
      set_kinds(term.kinds);
      result.push_back(term);
    };
    const double mass = has_mass ? 1. : 0., mu = 0.5 * material.two_mu;
    switch (op)
      {
        case heat:
          add(0, 0, mass, 0., [](auto &) {});
          for (unsigned int d = 0; d < dim; ++d)
            add(0, 0, 0., 1., [d](auto &kinds) { kinds[d] = gradients; });
          break;
        case momentum:
          for (unsigned int c = 0; c < dim; ++c)
            {
              add(c, c, mass, 0., [c](auto &kinds) {
                if (c == 0)
                  kinds[0] = mass_of_axial;
              });
              add(c, c, 0., 1., [c](auto &kinds) { kinds[c] = normal; });
              for (unsigned int d = 0; d < dim; ++d)
                if (d != c)
                  {
                    add(c, c, 0., mu, [d](auto &kinds) {
                      kinds[d] = gradients;
                    });
                    add(c, d, 0., material.lambda, [c, d](auto &kinds) {
                      kinds[c] = of_test_dilatation;
                      kinds[d] = dilatation;
                    });
                    add(c, d, 0., mu, [c, d](auto &kinds) {
                      kinds[d] = of_test;
                      kinds[c] = gradient;
                    });
                  }
            }
          break;
        case divergence:
          for (unsigned int c = 0; c < dim; ++c)
            add(0, c, 0., 1., [c](auto &kinds) { kinds[c] = dilatation; });
          break;
        case thermal_stress:
          for (unsigned int c = 0; c < dim; ++c)
            add(c, 0, 0., 1., [c](auto &kinds) {
              kinds[c] = of_test_dilatation;
            });
          break;
      }
    return result;
  }



  template <int dim, typename Number>
  typename LevelMatrix<dim, Number>::Plan
  LevelMatrix<dim, Number>::make_plan(const Operator op) const
  {
    Plan plan;
    plan.from = op == heat || op == thermal_stress ? Field::temperature :
                                                     Field::displacement;
    plan.to =
      op == heat || op == divergence ? Field::temperature : Field::displacement;
    // terms that differ along the body alone are one sum
    using Place = std::array<unsigned int, dim + 1>; // row, kinds, column
    std::map<Place, std::vector<Term>> same;
    for (const Term &term : terms(op))
      {
        Place place;
        place[0] = term.row;
        for (unsigned int d = 1; d < dim; ++d)
          place[dim - d] = term.kinds[d];
        place[dim] = term.column;
        same[place].push_back(term);
      }
    const auto key = [](const std::vector<Term> &terms) {
      std::vector<std::array<double, 4>> result;
      for (const Term &term : terms)
        result.push_back({{double(term.column),
                           double(term.kinds[0]),
                           term.mass,
                           term.stiffness}});
      return result;
    };
    std::map<std::vector<std::array<double, 4>>, unsigned int> sums;
    for (const auto &[place, terms] : same)
      if (sums.emplace(key(terms), plan.sums.size()).second)
        plan.sums.push_back({place[dim], terms});
    plan.n_buffers = plan.sums.size();
    for (unsigned int c = 0; c < n_components(plan.to); ++c)
      plan.rows.push_back(plan.n_buffers++);
    std::vector<bool> is_set(plan.n_buffers, false);
    const auto        add = [&](const unsigned int direction,
                         const unsigned int kind,
                         const unsigned int from,
                         const unsigned int to) {
      plan.steps.push_back({direction, Kind(kind), from, to, !is_set[to]});
      is_set[to] = true;
    };
    for (auto group = same.begin(); group != same.end();)
      {
        const Place place = group->first;
        if (dim == 2)
          {
            add(1, place[1], sums.at(key(group->second)), plan.rows[place[0]]);
            ++group;
            continue;
          }
        const unsigned int between = plan.n_buffers++;
        is_set.push_back(false);
        for (; group != same.end() && group->first[0] == place[0] &&
               group->first[1] == place[1];
             ++group)
          add(1, group->first[2], sums.at(key(group->second)), between);
        add(2, place[1], between, plan.rows[place[0]]);
      }
    return plan;
  }



  template <int dim, typename Number>
  LevelVector<Number>
  LevelMatrix<dim, Number>::make_vector(const Field::Block field) const
  {
    return LevelVector<Number>(grid.n_nodes() * n_components(field));
  }



  namespace
  {
    /**
     * @p to = or += coefficients times @p width neighbours, from the one that
     * @p from is the place of, @p stride places to the next.
     */
    template <unsigned int width, bool is_first, typename Number>
    void
    apply_within_plane(const Number      *coefficient,
                       const Number      *from,
                       Number            *to,
                       const unsigned int stride,
                       const unsigned int length)
    {
      using Batched = Lanes<Number>;
      for (unsigned int i = 0; i < length; i += Batched::n_lanes)
        {
          Batched sum = is_first ? Batched{} : Batched::load(to + i);
          for (unsigned int k = 0; k < width; ++k)
            sum += Batched::load(coefficient + k * length + i) *
                   Batched::load(from + k * stride + i);
          sum.store(to + i);
        }
    }
  } // namespace



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::add(const Operator op,
                                const double   mass,
                                const double   stiffness,
                                Number        *y,
                                const Number  *x) const
  {
    if (degree == 1)
      add_planes<3>(op, mass, stiffness, y, x);
    else
      add_planes<5>(op, mass, stiffness, y, x);
  }



  template <int dim, typename Number>
  template <unsigned int width>
  void
  LevelMatrix<dim, Number>::add_planes(const Operator op,
                                       const double   mass,
                                       const double   stiffness,
                                       Number        *y,
                                       const Number  *x) const
  {
    using Batched                   = Lanes<Number>;
    const Plan        &plan         = plans[op];
    const unsigned int n_from       = n_components(plan.from);
    const unsigned int n_to         = n_components(plan.to);
    const unsigned int n_planes     = grid.positions(0).size();
    const std::size_t  stride       = margin + length;
    const std::size_t  n_of_planes  = stride * n_planes * n_from + margin;
    const std::size_t  n_of_buffers = stride * plan.n_buffers + margin;
    if (planes.size() < n_of_planes)
      planes.resize(n_of_planes);
    if (buffers.size() < n_of_buffers)
      buffers.resize(n_of_buffers);
    const auto plane = [&](const unsigned int c, const unsigned int i) {
      return planes.data() + margin + (std::size_t(c) * n_planes + i) * stride;
    };
    const auto buffer = [&](const unsigned int b) {
      return buffers.data() + margin + b * stride;
    };
    const auto strides = grid.strides();
    for (unsigned int c = 0; c < n_from; ++c)
      for (unsigned int i = 0; i < n_planes; ++i)
        {
          const unsigned int *const entry = &entries[plan.from][i * n_plane];
          Number *const             to    = plane(c, i);
          for (unsigned int node = 0; node < n_plane; ++node)
            to[node] = x[entry[node] + c];
        }
    for (unsigned int i = 0; i < n_planes; ++i)
      {
        for (unsigned int s = 0; s < plan.sums.size(); ++s)
          {
            std::array<const Number *, width> from;
            std::array<Number, width>         factors;
            for (unsigned int k = 0; k < width; ++k)
              {
                double sum = 0.; // of what is not there: 0
                for (const Term &term : plan.sums[s].terms)
                  sum += (mass * term.mass + stiffness * term.stiffness) *
                         axes[0][term.kinds[0]][k][i];
                factors[k] = sum;
                from[k] =
                  plane(plan.sums[s].column,
                        std::clamp(i + k, degree, n_planes + degree - 1) -
                          degree);
              }
            Number *const to = buffer(s);
            for (unsigned int node = 0; node < length; node += n_lanes)
              {
                Batched sum{};
                for (unsigned int k = 0; k < width; ++k)
                  sum += Batched::load(from[k] + node) * factors[k];
                sum.store(to + node);
              }
          }
        for (const Step &step : plan.steps)
          {
            const auto apply = step.is_first ?
                                 apply_within_plane<width, true, Number> :
                                 apply_within_plane<width, false, Number>;
            apply(&coefficients[coefficient(step.direction, step.kind)],
                  buffer(step.from) - degree * strides[step.direction],
                  buffer(step.to),
                  strides[step.direction],
                  length);
          }
        const unsigned int *const entry = &entries[plan.to][i * n_plane];
        for (unsigned int c = 0; c < n_to; ++c)
          {
            const Number *const from = buffer(plan.rows[c]);
            for (unsigned int node = 0; node < n_plane; ++node)
              y[entry[node] + c] += from[node];
          }
      }
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::vmult(const Field::Block         field,
                                  const double               mass,
                                  const double               stiffness,
                                  LevelVector<Number>       &y,
                                  const LevelVector<Number> &x) const
  {
    y = Number();
    add(of(field), mass, stiffness, y.begin(), x.begin());
  }



  template class LevelMatrix<2, float>;
  template class LevelMatrix<2, double>;
  template class LevelMatrix<3, float>;
  template class LevelMatrix<3, double>;
} // namespace ThermoContact
