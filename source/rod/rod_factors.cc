// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/rod/dense_inverse.h>
#include <thermocontact/rod/rod_factors.h>
#include <thermocontact/rod/small_blocks.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  template <unsigned int n_fields>
  RodFactors<n_fields>::RodFactors(const RodMatrices &matrices,
                                   const Blocks      &blocks,
                                   const Held        &held,
                                   const Held        &held_right)
    : layout(matrices.layout())
    , runs(matrices.runs())
    , n_inner(n_fields * (layout.degree - 1))
    , middle(layout.n_cells / 2)
    , held(held)
    , has_left(std::count(held.begin(), held.end(), false) > 0)
    , held_right(held_right)
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
    std::vector<Matrix> vertex_systems;
    for (unsigned int r = 0; r < runs.size(); ++r)
      {
        Matrix system(n * n, 0.);
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
        vertex_systems.push_back(eliminate_inner_nodes(system, cells[r]));
      }
    if (growth_ < infinity)
      factorize_vertices(vertex_systems);
  }



  template <unsigned int n_fields>
  void
  RodFactors<n_fields>::note_growth(const double growth)
  {
    if (std::isnan(growth))
      growth_ = infinity;
    else
      growth_ = std::max(growth_, growth);
  }



  template <unsigned int n_fields>
  typename RodFactors<n_fields>::Matrix
  RodFactors<n_fields>::eliminate_inner_nodes(const Matrix &system, Cell &cell)
  {
    constexpr unsigned int n_outer = 2 * n_fields;
    const unsigned int     n       = n_outer + n_inner;
    Matrix                 vertices(n_outer * n_outer);
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
    if (growth_ == infinity)
      return vertices;
    for (unsigned int j = 0; j < n_outer; ++j)
      {
        double *const to_inner = cell.vertices_to_inner.data() + j * n_inner;
        for (unsigned int k = 0; k < n_inner; ++k)
          for (unsigned int i = 0; i < n_inner; ++i)
            to_inner[i] +=
              cell.inner_inverse[k * n_inner + i] * system[j * n + n_outer + k];
        for (unsigned int i = 0; i < n_outer; ++i)
          for (unsigned int k = 0; k < n_inner; ++k)
            vertices[j * n_outer + i] -=
              cell.inner_to_vertices[i * n_inner + k] * to_inner[k];
      }
    return vertices;
  }



  template <unsigned int n_fields>
  void
  RodFactors<n_fields>::factorize_vertices(const std::vector<Matrix> &systems)
  {
    constexpr unsigned int n_outer = 2 * n_fields;
    const auto             block =
      [&](const Matrix &system, const bool row, const bool column) {
        NodeBlock a;
        for (unsigned int i = 0; i < n_fields; ++i)
          for (unsigned int j = 0; j < n_fields; ++j)
            a[i * n_fields + j] =
              system[(column * n_fields + j) * n_outer + row * n_fields + i];
        return a;
      };
    const unsigned int          n = layout.n_cells;
    std::vector<const Matrix *> cell(n);
    for (unsigned int r = 0; r < runs.size(); ++r)
      std::fill(cell.begin() + runs[r].begin,
                cell.begin() + runs[r].end,
                &systems[r]);

    // vertex i is the right one of cell i, the left one of cell i + 1
    const auto hold = [&](NodeBlock         &a,
                          const unsigned int row_vertex,
                          const unsigned int column_vertex) {
      for (unsigned int k = 0; k < n_fields; ++k)
        for (unsigned int j = 0; held_right[k] && j < n_fields; ++j)
          {
            const bool is_diagonal = row_vertex == column_vertex;
            if (row_vertex == n - 1)
              a[k * n_fields + j] = is_diagonal && j == k;
            if (column_vertex == n - 1)
              a[j * n_fields + k] = is_diagonal && j == k;
          }
      return a;
    };
    const auto diagonal = [&](const unsigned int i) {
      NodeBlock a = block(*cell[i], true, true);
      if (i + 1 < n)
        {
          const NodeBlock b = block(*cell[i + 1], false, false);
          for (unsigned int k = 0; k < n_entries; ++k)
            a[k] += b[k];
        }
      return hold(a, i, i);
    };
    const auto lower = [&](const unsigned int i) {
      NodeBlock a = block(*cell[i], true, false);
      return hold(a, i, i - 1);
    };
    const auto upper = [&](const unsigned int i) {
      NodeBlock a = block(*cell[i + 1], false, true);
      return hold(a, i, i + 1);
    };

    const auto eliminate =
      [&](const NodeBlock &factor, const NodeBlock &b, NodeBlock &d) {
        const NodeBlock step = factor * b;
        double          size = 0., change = 0.;
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
    const auto invert_pivot = [&](const NodeBlock &d, Vertex &vertex) {
      note_growth(cancellation(d));
      vertex.inverse = inverse(d);
    };
    // node 0 is in front of all
    NodeBlock first = diagonal(0);
    if (has_left)
      {
        NodeBlock d     = block(*cell[0], false, false);
        NodeBlock below = lower(0), behind = block(*cell[0], false, true);
        if (n == 1)
          for (unsigned int k = 0; k < n_fields; ++k)
            for (unsigned int j = 0; held_right[k] && j < n_fields; ++j)
              behind[j * n_fields + k] = 0.;
        for (unsigned int k = 0; k < n_fields; ++k)
          for (unsigned int j = 0; held[k] && j < n_fields; ++j)
            {
              d[k * n_fields + j] = d[j * n_fields + k] = (j == k);
              behind[k * n_fields + j] = below[j * n_fields + k] = 0.;
            }
        invert_pivot(d, left);
        left.elimination  = below * left.inverse;
        left.substitution = left.inverse * behind;
        eliminate(left.elimination, behind, first);
      }

    for (unsigned int i = 0; i < middle; ++i)
      {
        NodeBlock d = i == 0 ? first : diagonal(i);
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
        NodeBlock d = diagonal(i);
        if (i < n - 1)
          {
            vertices[i].elimination = upper(i) * vertices[i + 1].inverse;
            eliminate(vertices[i].elimination, lower(i + 1), d);
          }
        invert_pivot(d, vertices[i]);
        vertices[i].substitution = vertices[i].inverse * lower(i);
      }
    NodeBlock d = middle == 0 ? first : diagonal(middle);
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



  template class RodFactors<1>;
  template class RodFactors<2>;
  template class RodFactors<3>;
} // namespace ThermoContact
