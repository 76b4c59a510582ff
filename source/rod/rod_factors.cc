// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/rod/fixed_degree.h>
#include <thermocontact/rod/rod_factors.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    // Blocks of one or two fields, by rows.
    template <std::size_t n>
    using Small = std::array<double, n>;

    Small<1>
    inverse(const Small<1> &a)
    {
      return {1. / a[0]};
    }

    Small<4>
    inverse(const Small<4> &a)
    {
      const double q = 1. / (a[0] * a[3] - a[1] * a[2]);
      return {a[3] * q, -a[1] * q, -a[2] * q, a[0] * q};
    }

    Small<1>
    operator*(const Small<1> &a, const Small<1> &b)
    {
      return {a[0] * b[0]};
    }

    Small<4>
    operator*(const Small<4> &a, const Small<4> &b)
    {
      return {a[0] * b[0] + a[1] * b[2],
              a[0] * b[1] + a[1] * b[3],
              a[2] * b[0] + a[3] * b[2],
              a[2] * b[1] + a[3] * b[3]};
    }

    template <std::size_t n>
    void
    subtract(Small<n> &a, const Small<n> &b)
    {
      for (unsigned int i = 0; i < n; ++i)
        a[i] -= b[i];
    }

    /** @p y $-=$ @p a @p x. */
    inline void
    subtract_product(Small<1> &y, const Small<1> &a, const Small<1> &x)
    {
      y[0] -= a[0] * x[0];
    }

    inline void
    subtract_product(Small<2> &y, const Small<4> &a, const Small<2> &x)
    {
      y[0] -= a[0] * x[0] + a[1] * x[1];
      y[1] -= a[2] * x[0] + a[3] * x[1];
    }

    inline Small<1>
    product(const Small<1> &a, const Small<1> &x)
    {
      return {a[0] * x[0]};
    }

    inline Small<2>
    product(const Small<4> &a, const Small<2> &x)
    {
      return {a[0] * x[0] + a[1] * x[1], a[2] * x[0] + a[3] * x[1]};
    }



    /**
     * @p a, by columns, becomes its inverse, by Gauss-Jordan elimination with
     * pivots from the columns. Returns the largest residual of a row of it, in
     * units of rounding; infinite without inverse.
     */
    double
    invert(std::vector<double> &a, const unsigned int n)
    {
      constexpr double none = std::numeric_limits<double>::infinity();
      // rows of different fields have different units
      std::vector<double> scales(n, 0.);
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          scales[i] = std::max(scales[i], std::abs(a[j * n + i]));
      for (const double scale : scales)
        if (!(scale > 0.) || !std::isfinite(scale))
          return none;
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          a[j * n + i] /= scales[i];
      const std::vector<double> scaled(a);
      std::vector<unsigned int> pivots(n);
      for (unsigned int k = 0; k < n; ++k)
        {
          double *const column = &a[k * n];
          pivots[k]            = k;
          for (unsigned int i = k + 1; i < n; ++i)
            if (std::abs(column[i]) > std::abs(column[pivots[k]]))
              pivots[k] = i;
          if (!(std::abs(column[pivots[k]]) > 0.))
            return none;
          for (unsigned int j = 0; j < n; ++j)
            std::swap(a[j * n + k], a[j * n + pivots[k]]);
          const double inverse = 1. / column[k];
          column[k]            = 1.;
          for (unsigned int j = 0; j < n; ++j)
            a[j * n + k] *= inverse;
          // column k of the row operation
          for (unsigned int j = 0; j < n; ++j)
            {
              if (j == k)
                continue;
              const double factor = a[j * n + k];
              for (unsigned int i = 0; i < n; ++i)
                if (i != k)
                  a[j * n + i] -= factor * column[i];
            }
          for (unsigned int i = 0; i < n; ++i)
            if (i != k)
              column[i] *= -inverse;
        }
      for (unsigned int k = n; k-- > 0;)
        if (pivots[k] != k)
          std::swap_ranges(&a[k * n], &a[k * n] + n, &a[pivots[k] * n]);

      double largest = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          double sum = 0.;
          for (unsigned int j = 0; j < n; ++j)
            {
              double residual = i == j ? -1. : 0.;
              for (unsigned int k = 0; k < n; ++k)
                residual += scaled[k * n + i] * a[j * n + k];
              sum += std::abs(residual);
            }
          if (!(sum <= largest))
            largest = sum;
        }
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          a[j * n + i] /= scales[j];
      return largest / std::numeric_limits<double>::epsilon();
    }



    /** How much larger the terms of a determinant are than itself. */
    double
    cancellation(const Small<1> &)
    {
      return 1.;
    }

    double
    cancellation(const Small<4> &a)
    {
      return (std::abs(a[0] * a[3]) + std::abs(a[1] * a[2])) /
             std::abs(a[0] * a[3] - a[1] * a[2]);
    }
  } // namespace



  template <unsigned int n_fields>
  RodFactors<n_fields>::RodFactors(const RodMatrices &matrices,
                                   const Blocks      &blocks)
    : layout(matrices.layout())
    , runs(matrices.runs())
    , n_inner(n_fields * (layout.degree - 1))
    , middle(layout.n_cells / 2)
    , cells(runs.size())
    , vertices(layout.n_cells)
    , vertex_values(n_fields * layout.n_cells)
    , inner_values(n_inner * layout.n_cells)
    , growth_(1.)
  {
    const unsigned int n_nodes = layout.nodes_per_cell();
    const unsigned int n       = n_fields * n_nodes;
    // vertices first, node by node; then inner nodes, field by field
    const auto place = [&](const unsigned int field, const unsigned int node) {
      return node < 2 ? node * n_fields + field :
                        2 * n_fields + field * (n_nodes - 2) + node - 2;
    };
    for (unsigned int r = 0; r < runs.size(); ++r)
      {
        std::vector<double> &system = cells[r].system;
        system.assign(n * n, 0.);
        for (unsigned int row = 0; row < n_fields; ++row)
          for (unsigned int column = 0; column < n_fields; ++column)
            for (const auto &[factor, matrix] : blocks[row][column])
              {
                const double *value = matrices.entries(runs[r], matrix);
                for (unsigned int j = 0; j < n_nodes; ++j)
                  for (unsigned int i = 0; i < n_nodes; ++i)
                    system[place(column, j) * n + place(row, i)] +=
                      factor * *value++;
              }
        eliminate_inner_nodes(cells[r]);
      }
    if (growth_ < std::numeric_limits<double>::infinity())
      factorize_vertices();
  }



  template <unsigned int n_fields>
  void
  RodFactors<n_fields>::note_growth(const double growth)
  {
    if (std::isnan(growth))
      growth_ = std::numeric_limits<double>::infinity();
    else
      growth_ = std::max(growth_, growth);
  }



  template <unsigned int n_fields>
  void
  RodFactors<n_fields>::eliminate_inner_nodes(Cell &cell)
  {
    constexpr unsigned int     n_outer = 2 * n_fields;
    const unsigned int         n       = n_outer + n_inner;
    const std::vector<double> &system  = cell.system;
    std::vector<double>        vertices(n_outer * n_outer);
    for (unsigned int j = 0; j < n_outer; ++j)
      for (unsigned int i = 0; i < n_outer; ++i)
        vertices[j * n_outer + i] = system[j * n + i];

    cell.inner_inverse.resize(n_inner * n_inner);
    cell.inner_to_vertices.resize(n_outer * n_inner);
    cell.vertices_to_inner.assign(n_inner * n_outer, 0.);
    for (unsigned int j = 0; j < n_inner; ++j)
      {
        const double *const column = &system[(n_outer + j) * n];
        std::copy(column + n_outer,
                  column + n,
                  &cell.inner_inverse[j * n_inner]);
        for (unsigned int i = 0; i < n_outer; ++i)
          cell.inner_to_vertices[i * n_inner + j] = column[i];
      }
    note_growth(invert(cell.inner_inverse, n_inner));
    if (growth_ == std::numeric_limits<double>::infinity())
      return;
    for (unsigned int j = 0; j < n_outer; ++j)
      {
        double *const to_inner = &cell.vertices_to_inner[j * n_inner];
        for (unsigned int k = 0; k < n_inner; ++k)
          for (unsigned int i = 0; i < n_inner; ++i)
            to_inner[i] +=
              cell.inner_inverse[k * n_inner + i] * system[j * n + n_outer + k];
        for (unsigned int i = 0; i < n_outer; ++i)
          for (unsigned int k = 0; k < n_inner; ++k)
            vertices[j * n_outer + i] -=
              cell.inner_to_vertices[i * n_inner + k] * to_inner[k];
      }
    cell.vertices.swap(vertices);
  }



  template <unsigned int n_fields>
  void
  RodFactors<n_fields>::factorize_vertices()
  {
    constexpr unsigned int n_outer = 2 * n_fields;
    const auto             block   = [&](const Cell &cell,
                           const bool  row,
                           const bool  column) {
      Small a;
      for (unsigned int i = 0; i < n_fields; ++i)
        for (unsigned int j = 0; j < n_fields; ++j)
          a[i * n_fields + j] =
            cell
              .vertices[(column * n_fields + j) * n_outer + row * n_fields + i];
      return a;
    };
    const unsigned int        n = layout.n_cells;
    std::vector<const Cell *> cell(n);
    for (unsigned int r = 0; r < runs.size(); ++r)
      std::fill(cell.begin() + runs[r].begin,
                cell.begin() + runs[r].end,
                &cells[r]);

    // vertex i is the right one of cell i, the left one of cell i + 1
    const auto diagonal = [&](const unsigned int i) {
      Small a = block(*cell[i], true, true);
      if (i + 1 < n)
        {
          const Small b = block(*cell[i + 1], false, false);
          for (unsigned int k = 0; k < n_entries; ++k)
            a[k] += b[k];
        }
      return a;
    };
    const auto lower = [&](const unsigned int i) {
      return block(*cell[i], true, false);
    };
    const auto upper = [&](const unsigned int i) {
      return block(*cell[i + 1], false, true);
    };

    const auto eliminate = [&](const Small &factor, const Small &b, Small &d) {
      const Small step = factor * b;
      double      size = 0., change = 0.;
      for (unsigned int row = 0; row < n_fields; ++row)
        {
          // rows of different fields have different units
          const double *const old_row  = &d[row * n_fields];
          const double *const row_step = &step[row * n_fields];
          size = change = 0.;
          for (unsigned int k = 0; k < n_fields; ++k)
            {
              size += std::abs(old_row[k]);
              change += std::abs(row_step[k]);
            }
          note_growth(change / size);
        }
      subtract(d, step);
    };
    const auto invert_pivot = [&](const Small &d, Vertex &vertex) {
      note_growth(cancellation(d));
      vertex.inverse = inverse(d);
    };

    for (unsigned int i = 0; i < middle; ++i)
      {
        Small d = diagonal(i);
        if (i > 0)
          {
            vertices[i].elimination = lower(i) * vertices[i - 1].inverse;
            eliminate(vertices[i].elimination, upper(i - 1), d);
          }
        invert_pivot(d, vertices[i]);
        vertices[i].substitution = vertices[i].inverse * upper(i);
      }
    for (unsigned int i = n - 1; i > middle; --i)
      {
        Small d = diagonal(i);
        if (i < n - 1)
          {
            vertices[i].elimination = upper(i) * vertices[i + 1].inverse;
            eliminate(vertices[i].elimination, lower(i + 1), d);
          }
        invert_pivot(d, vertices[i]);
        vertices[i].substitution = vertices[i].inverse * lower(i);
      }
    Small d = diagonal(middle);
    if (middle > 0)
      {
        from_left = lower(middle) * vertices[middle - 1].inverse;
        eliminate(from_left, upper(middle - 1), d);
      }
    if (middle + 1 < n)
      {
        from_right = upper(middle) * vertices[middle + 1].inverse;
        eliminate(from_right, lower(middle + 1), d);
      }
    invert_pivot(d, vertices[middle]);
  }



  template <unsigned int n_fields>
  template <typename Value, typename SetValue>
  void
  RodFactors<n_fields>::solve_vertices(const Value    &value,
                                       const SetValue &set_value) const
  {
    using Values            = std::array<double, n_fields>;
    const unsigned int n    = layout.n_cells;
    const auto         load = [&](const unsigned int i) {
      Values values;
      for (unsigned int k = 0; k < n_fields; ++k)
        values[k] = value(i, k);
      return values;
    };
    double *const eliminated = vertex_values.data();
    const auto    keep       = [&](const unsigned int i, const Values &values) {
      for (unsigned int k = 0; k < n_fields; ++k)
        eliminated[i * n_fields + k] = values[k];
    };
    const auto kept = [&](const unsigned int i) {
      Values values;
      for (unsigned int k = 0; k < n_fields; ++k)
        values[k] = eliminated[i * n_fields + k];
      return values;
    };
    const auto set = [&](const unsigned int i, const Values &values) {
      for (unsigned int k = 0; k < n_fields; ++k)
        set_value(i, k, values[k]);
    };

    Values       a{}, b{};
    unsigned int i = 0, j = n - 1;
    const auto   eliminate = [&](const unsigned int vertex, Values &before) {
      Values values = load(vertex);
      subtract_product(values, vertices[vertex].elimination, before);
      keep(vertex, values);
      before = values;
    };
    for (; i < middle && j > middle; ++i, --j)
      {
        eliminate(i, a);
        eliminate(j, b);
      }
    for (; i < middle; ++i)
      eliminate(i, a);
    for (; j > middle; --j)
      eliminate(j, b);

    Values last = load(middle);
    if (middle > 0)
      subtract_product(last, from_left, a);
    if (middle + 1 < n)
      subtract_product(last, from_right, b);
    a = b = product(vertices[middle].inverse, last);
    set(middle, a);

    const auto substitute = [&](const unsigned int vertex, Values &known) {
      Values values = product(vertices[vertex].inverse, kept(vertex));
      subtract_product(values, vertices[vertex].substitution, known);
      set(vertex, values);
      known = values;
    };
    i = middle;
    j = middle + 1;
    for (; i > 0 && j < n; --i, ++j)
      {
        substitute(i - 1, a);
        substitute(j, b);
      }
    for (; i > 0; --i)
      substitute(i - 1, a);
    for (; j < n; ++j)
      substitute(j, b);
  }



  template <unsigned int n_fields>
  template <unsigned int fixed_degree>
  void
  RodFactors<n_fields>::condense(const Right &right) const
  {
    const unsigned int p     = fixed_degree > 0 ? fixed_degree : layout.degree;
    const unsigned int ni    = n_fields * (p - 1);
    double *const      outer = vertex_values.data();
    for (unsigned int r = 0; r < runs.size(); ++r)
      {
        const double *const inverse     = cells[r].inner_inverse.data();
        const double *const to_vertices = cells[r].inner_to_vertices.data();
        for (unsigned int cell = runs[r].begin; cell < runs[r].end; ++cell)
          {
            double *__restrict__ inner = inner_values.data() + cell * ni;
            for (unsigned int i = 0; i < ni; ++i)
              inner[i] = 0.;
            for (unsigned int k = 0; k < n_fields; ++k)
              for (unsigned int m = 0; m + 1 < p; ++m)
                {
                  const double        load   = right[k][cell * p + 2 + m];
                  const double *const column = inverse + (k * (p - 1) + m) * ni;
                  for (unsigned int i = 0; i < ni; ++i)
                    inner[i] += column[i] * load;
                }
            for (unsigned int k = 0; k < 2 * n_fields; ++k)
              {
                double force = 0.;
                for (unsigned int i = 0; i < ni; ++i)
                  force += to_vertices[k * ni + i] * inner[i];
                if (k >= n_fields)
                  outer[cell * n_fields + k - n_fields] =
                    right[k - n_fields][cell * p + 1] - force;
                else if (cell > 0)
                  outer[(cell - 1) * n_fields + k] -= force;
              }
          }
      }
  }



  template <unsigned int n_fields>
  template <unsigned int fixed_degree>
  void
  RodFactors<n_fields>::solve_inner_nodes(const Solution &solution) const
  {
    const unsigned int p  = fixed_degree > 0 ? fixed_degree : layout.degree;
    const unsigned int ni = n_fields * (p - 1);
    for (unsigned int r = 0; r < runs.size(); ++r)
      {
        const double *const to_inner = cells[r].vertices_to_inner.data();
        for (unsigned int cell = runs[r].begin; cell < runs[r].end; ++cell)
          {
            double *__restrict__ inner = inner_values.data() + cell * ni;
            for (unsigned int k = 0; k < 2 * n_fields; ++k)
              {
                const double vertex = k >= n_fields ?
                                        solution[k - n_fields][cell * p + 1] :
                                        solution[k][layout.left_vertex(cell)];
                for (unsigned int i = 0; i < ni; ++i)
                  inner[i] -= to_inner[k * ni + i] * vertex;
              }
            for (unsigned int k = 0; k < n_fields; ++k)
              for (unsigned int m = 0; m + 1 < p; ++m)
                solution[k][cell * p + 2 + m] = inner[k * (p - 1) + m];
          }
      }
  }



  template <unsigned int n_fields>
  void
  RodFactors<n_fields>::solve(const Right    &right,
                              const Solution &solution) const
  {
    for (double *const field : solution)
      field[0] = 0.;
    with_fixed_degree(layout.degree, [&](const auto degree) {
      const unsigned int p = degree.value > 0 ? degree.value : layout.degree;
      const auto         set_value = [&](const unsigned int vertex,
                                 const unsigned int field,
                                 const double       value) {
        solution[field][vertex * p + 1] = value;
      };
      if constexpr (degree.value == 1)
        solve_vertices(
          [&](const unsigned int vertex, const unsigned int field) {
            return right[field][vertex + 1];
          },
          set_value);
      else
        {
          condense<degree.value>(right);
          solve_vertices(
            [&](const unsigned int vertex, const unsigned int field) {
              return vertex_values[vertex * n_fields + field];
            },
            set_value);
          solve_inner_nodes<degree.value>(solution);
        }
    });
  }



  template class RodFactors<1>;
  template class RodFactors<2>;
} // namespace ThermoContact
