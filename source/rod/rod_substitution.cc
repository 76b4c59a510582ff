// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/rod/fixed_degree.h>
#include <thermocontact/rod/rod_factors.h>
#include <thermocontact/rod/small_blocks.h>

namespace ThermoContact
{
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
    // there are as many on the left, or one more
    for (; j > middle; ++i, --j)
      {
        eliminate(i, a);
        eliminate(j, b);
      }
    for (; i < middle; ++i)
      eliminate(i, a);

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
    for (; j < n; --i, ++j)
      {
        substitute(i - 1, a);
        substitute(j, b);
      }
    for (; i > 0; --i)
      substitute(i - 1, a);
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
                else if (has_left)
                  left_values[k] = right[k][0] - force;
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
    // the part of node 0 in the vertex behind it
    std::array<double, n_fields> from_node_0{};
    const auto                   eliminate_node_0 = [&]() {
      for (unsigned int k = 0; k < n_fields; ++k)
        if (held[k])
          left_values[k] = 0.;
      subtract_product(from_node_0, left.elimination, left_values);
    };
    const auto substitute_node_0 = [&]() {
      std::array<double, n_fields> behind;
      for (unsigned int k = 0; k < n_fields; ++k)
        behind[k] = solution[k][1]; // the right vertex of cell 0
      auto values = product(left.inverse, left_values);
      subtract_product(values, left.substitution, behind);
      for (unsigned int k = 0; k < n_fields; ++k)
        if (!held[k])
          solution[k][0] = values[k];
    };
    with_fixed_degree(layout.degree, [&](const auto degree) {
      const unsigned int p = degree.value > 0 ? degree.value : layout.degree;
      const auto         set_value = [&](const unsigned int vertex,
                                 const unsigned int field,
                                 const double       value) {
        solution[field][vertex * p + 1] = value;
      };
      if constexpr (degree.value == 1)
        {
          const auto load = [&](const unsigned int vertex,
                                const unsigned int field) {
            return right[field][vertex + 1];
          };
          if (!has_left)
            return solve_vertices(load, set_value);
          for (unsigned int k = 0; k < n_fields; ++k)
            left_values[k] = right[k][0];
          eliminate_node_0();
          solve_vertices(
            [&](const unsigned int vertex, const unsigned int field) {
              return load(vertex, field) +
                     (vertex == 0 ? from_node_0[field] : 0.);
            },
            set_value);
          substitute_node_0();
        }
      else
        {
          condense<degree.value>(right);
          for (unsigned int k = 0; k < n_fields; ++k)
            if (held_right[k])
              vertex_values[(layout.n_cells - 1) * n_fields + k] = 0.;
          if (has_left)
            {
              eliminate_node_0();
              for (unsigned int k = 0; k < n_fields; ++k)
                vertex_values[k] += from_node_0[k];
            }
          solve_vertices(
            [&](const unsigned int vertex, const unsigned int field) {
              return vertex_values[vertex * n_fields + field];
            },
            set_value);
          if (has_left)
            substitute_node_0();
          solve_inner_nodes<degree.value>(solution);
        }
    });
  }



  template void
  RodFactors<1>::solve(const Right &, const Solution &) const;
  template void
  RodFactors<2>::solve(const Right &, const Solution &) const;
  template void
  RodFactors<3>::solve(const Right &, const Solution &) const;
} // namespace ThermoContact
