// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/level_lines.h>

#include <algorithm>
#include <utility>

namespace ThermoContact
{
  namespace
  {
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
    const LevelMatrix<dim, Number>     &matrix,
    const LevelGrid<dim>               &grid,
    const Field::Block                  field,
    const std::vector<NodalValue<dim>> &values)
    : n_components(field == Field::temperature ? 1 : dim)
    , diagonal(values.size())
    , coupling(values.size())
  {
    const unsigned int line_stride = grid.strides()[0]; // the largest one
    const unsigned int row_stride  = line_stride * n_components;

    // rows of the matrix, by lines, and entries of vectors
    std::vector<std::pair<std::array<unsigned int, 3>, unsigned int>> places;
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        unsigned int node = 0;
        for (unsigned int d = 0; d < dim; ++d)
          node +=
            grid.strides()[d] * nearest(grid.positions(d), values[i].node[d]);
        places.push_back(
          {{{node % line_stride, node, values[i].component}}, i});
      }
    std::sort(places.begin(), places.end());
    std::vector<unsigned int> place_of_row(grid.n_nodes() * n_components, -1U);
    for (const auto &[place, entry] : places)
      {
        place_of_row[place[1] * n_components + place[2]] = entries.size();
        entries.push_back(entry);
      }
    matrix.visit_entries(field,
                         0.,
                         1.,
                         [&](const unsigned int row,
                             const unsigned int column,
                             const Number       value) {
                           const unsigned int i = place_of_row[row];
                           if (i == -1U)
                             return;
                           if (column == row)
                             diagonal[i] = value;
                           else if (column + row_stride == row &&
                                    i >= n_components &&
                                    place_of_row[column] == i - n_components)
                             coupling[i] = value;
                         });
  }



  /** Of the diagonal, what rounding leaves of a pivot at least. */
  constexpr double smallest_pivot = 1e-5;



  template <int dim, typename Number>
  LineFactors<dim, Number>::LineFactors(const LevelLines<dim, Number> &lines,
                                        const double  stiffness,
                                        const Vector &rest)
    : lines(lines)
    , multipliers(lines.entries.size() + lines.n_components)
    , inverse_pivots(lines.entries.size())
    , scratch(lines.entries.size() + 2 * lines.n_components)
  {
    for (unsigned int i = 0; i < lines.entries.size(); ++i)
      {
        const double diagonal =
          stiffness * lines.diagonal[i] + rest.local_element(lines.entries[i]);
        double pivot = diagonal;
        if (lines.coupling[i] != 0)
          {
            const double coupling = stiffness * lines.coupling[i];
            multipliers[i] = coupling * inverse_pivots[i - lines.n_components];
            pivot -= multipliers[i] * coupling;
          }
        inverse_pivots[i] = 1. / std::max(pivot, smallest_pivot * diagonal);
      }
  }



  template <int dim, typename Number>
  void
  LineFactors<dim, Number>::solve(LevelVector<Number> &values) const
  {
    const unsigned int  n       = lines.n_components;
    const unsigned int *entries = lines.entries.data();
    const Number       *l       = multipliers.data();
    Number             *x       = scratch.data() + n;
    Number             *result  = values.begin();
    for (std::size_t i = 0; i < lines.entries.size(); ++i)
      x[i] = result[entries[i]] - l[i] * (x + i)[-int(n)];
    for (std::size_t i = lines.entries.size(); i-- > 0;)
      result[entries[i]] = x[i] =
        inverse_pivots[i] * x[i] - l[i + n] * x[i + n];
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
