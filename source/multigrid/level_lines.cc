// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/level_lines.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <tuple>

namespace ThermoContact
{
  namespace
  {
    /** Integrals of basis functions of an axis and of their derivatives. */
    struct AxisIntegrals
    {
      unsigned int        degree;
      std::vector<double> mass, stiffness;

      /** Where that of a node and of the one @p distance before it is. */
      std::size_t
      place(const unsigned int node, const unsigned int distance) const
      {
        return std::size_t(node) * (degree + 1) + distance;
      }
    };



    /** @param weight of a point of the axis */
    template <typename Weight>
    AxisIntegrals
    integrate(const std::vector<double> &nodes,
              const unsigned int         degree,
              const Weight              &weight)
    {
      AxisIntegrals axis{degree, {}, {}};
      axis.mass.resize(nodes.size() * (degree + 1));
      axis.stiffness = axis.mass;
      const QGauss<1> rule(degree + 1);
      const auto      basis = Polynomials::generate_complete_Lagrange_basis(
        QGaussLobatto<1>(degree + 1).get_points());
      for (unsigned int first = 0; first + 1 < nodes.size(); first += degree)
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const double size  = nodes[first + degree] - nodes[first];
            const double place = rule.point(q)[0];
            const double w =
              rule.weight(q) * size * weight(nodes[first] + place * size);
            for (unsigned int i = 0; i <= degree; ++i)
              for (unsigned int j = 0; j <= i; ++j)
                {
                  const std::size_t entry = axis.place(first + i, i - j);
                  axis.mass[entry] +=
                    w * basis[i].value(place) * basis[j].value(place);
                  axis.stiffness[entry] += w / (size * size) *
                                           basis[i].derivative().value(place) *
                                           basis[j].derivative().value(place);
                }
          }
      return axis;
    }



    /** The number of the position that is next. */
    unsigned int
    nearest(const std::vector<double> &positions, const double x)
    {
      const auto above =
        std::lower_bound(positions.begin() + 1, positions.end() - 1, x);
      return above - positions.begin() - (x - *(above - 1) < *above - x);
    }
  } // namespace



  template <int dim, typename Number>
  LevelLines<dim, Number>::LevelLines(
    const LevelGrid<dim>               &grid,
    const std::vector<NodalValue<dim>> &values,
    const Field::Block                  field,
    const Material                     &material,
    const Geometry<dim>                &geometry,
    const LevelVector<Number>          &diagonal)
    : n_components(field == Field::temperature ? 1 : dim)
    , width(grid.degree())
    , order(values.size())
    , couplings(values.size() * width)
  {
    const AxisIntegrals along =
      integrate(grid.positions(0), width, [](const double) { return 1.; });
    const AxisIntegrals across =
      integrate(grid.positions(1), width, [&](const double y) {
        Point<dim> point;
        point[1] = y;
        return geometry.weight_at(point);
      });

    // line, node of it, component, entry of vectors
    using Place =
      std::tuple<unsigned int, unsigned int, unsigned int, unsigned int>;
    std::vector<Place>  places;
    std::vector<double> of_stretch(values.size()); // factors of both integrals
    std::vector<double> of_values(values.size());
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        const auto &[component, point] = values[i];
        const unsigned int node        = nearest(grid.positions(0), point[0]);
        unsigned int       line        = 0;
        of_stretch[i]                  = field == Field::temperature ? 1. :
                                         component == 0 ? material.lambda + material.two_mu :
                                                          0.5 * material.two_mu;
        for (unsigned int d = 1; d < dim; ++d)
          {
            const unsigned int k = nearest(grid.positions(d), point[d]);
            line                 = line * grid.positions(d).size() + k;
            of_stretch[i] *= across.mass[across.place(k, 0)];
          }
        const std::size_t own = along.place(node, 0);
        of_values[i]          = std::max(0.,
                                (diagonal.local_element(i) -
                                 of_stretch[i] * along.stiffness[own]) /
                                  along.mass[own]);
        places.emplace_back(line, node, component, i);
      }
    std::sort(places.begin(), places.end());
    for (unsigned int i = 0; i < places.size(); ++i)
      {
        const auto &[line, node, component, entry] = places[i];
        order[i]                                   = entry;
        for (unsigned int k = 0; k < width && (k + 1) * n_components <= i; ++k)
          {
            const auto &[other_line, other_node, other_component, other] =
              places[i - (k + 1) * n_components];
            if (other_line != line || node - other_node > width)
              break;
            const std::size_t both = along.place(node, node - other_node);
            couplings[(i / n_components * width + k) * n_components +
                      component]   = of_stretch[other] * along.stiffness[both] +
                                   of_values[other] * along.mass[both];
          }
      }
  }



  /** Of the diagonal, that rounding leaves of a pivot. */
  constexpr double smallest_pivot = 1e-5;



  template <int dim, typename Number>
  LineFactors<dim, Number>::LineFactors(
    const LevelLines<dim, Number> &lines,
    const double                   stiffness,
    const LevelVector<Number>     &inverse_diagonal)
    : lines(lines)
    , multipliers(lines.couplings.size() +
                  lines.width * lines.width * lines.n_components)
    , inverse_pivots(lines.order.size())
    , scratch(lines.order.size() + 2 * lines.width * lines.n_components)
  {
    const unsigned int width = lines.width, n = lines.n_components;
    const auto         place = [&](const unsigned int i, const unsigned int k) {
      return (i / n * width + k) * n + i % n;
    };
    for (unsigned int i = 0; i < lines.order.size(); ++i)
      {
        const double inverse = inverse_diagonal.local_element(lines.order[i]);
        if (inverse == 0.)
          continue;
        double pivot = 1. / inverse;
        // from the farthest one on: entries of L times pivots, then of L
        std::vector<double> row(width);
        for (unsigned int k = width; k-- > 0;)
          if ((k + 1) * n <= i && inverse_pivots[i - (k + 1) * n] > 0)
            {
              const unsigned int other = i - (k + 1) * n;
              row[k] = stiffness * lines.couplings[place(i, k)];
              for (unsigned int m = k + 1; m < width; ++m)
                row[k] -= row[m] * multipliers[place(other, m - k - 1)];
              const double multiplier  = row[k] * inverse_pivots[other];
              multipliers[place(i, k)] = multiplier;
              pivot -= multiplier * row[k];
            }
        inverse_pivots[i] = 1. / std::max(pivot, smallest_pivot / inverse);
      }
  }



  template <int dim, typename Number>
  template <unsigned int n>
  void
  LineFactors<dim, Number>::solve_components(Number *values) const
  {
    const unsigned int  width   = lines.width;
    const unsigned int  n_nodes = lines.order.size() / n;
    const unsigned int *order   = lines.order.data();
    const Number       *l       = multipliers.data();
    Number             *x       = scratch.data() + std::size_t(width) * n;
    for (unsigned int i = 0; i < n_nodes; ++i, order += n, x += n)
      {
        for (unsigned int c = 0; c < n; ++c)
          x[c] = values[order[c]];
        for (unsigned int k = 1; k <= width; ++k, l += n)
          for (unsigned int c = 0; c < n; ++c)
            x[c] -= l[c] * (x - k * n)[c];
      }
    const Number *inverse = inverse_pivots.data() + lines.order.size();
    for (unsigned int i = n_nodes; i-- > 0;)
      {
        order -= n;
        x -= n;
        inverse -= n;
        l -= width * n;
        for (unsigned int c = 0; c < n; ++c)
          x[c] *= inverse[c];
        for (unsigned int k = 0; k < width; ++k)
          for (unsigned int c = 0; c < n; ++c)
            x[c] -= l[((k + 1) * width + k) * n + c] * x[(k + 1) * n + c];
        for (unsigned int c = 0; c < n; ++c)
          values[order[c]] = x[c];
      }
  }



  template <int dim, typename Number>
  void
  LineFactors<dim, Number>::solve(LevelVector<Number> &values) const
  {
    if (lines.n_components == 1)
      solve_components<1>(values.begin());
    else
      solve_components<dim>(values.begin());
  }



  template struct LevelLines<2, float>;
  template struct LevelLines<2, double>;
  template struct LevelLines<3, float>;
  template struct LevelLines<3, double>;
  template class LineFactors<2, float>;
  template class LineFactors<2, double>;
  template class LineFactors<3, float>;
  template class LineFactors<3, double>;
} // namespace ThermoContact
