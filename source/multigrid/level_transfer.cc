// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/level_transfer.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <type_traits>

namespace ThermoContact
{
  namespace
  {
    /** A number that the compiler knows. */
    template <unsigned int n>
    using Constant = std::integral_constant<unsigned int, n>;
  } // namespace



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::reinit(const LevelGrid<dim>               &coarse,
                                     const std::vector<NodalValue<dim>> &fine,
                                     const unsigned int n_components,
                                     const MPI_Comm     communicator)
  {
    this->n_components        = n_components;
    this->communicator        = communicator;
    const unsigned int degree = coarse.degree();
    for (unsigned int d = 0; d < dim; ++d)
      strides[d] = coarse.strides()[d] * n_components;

    struct Value
    {
      Run          run; // its end: the layer of cells
      unsigned int first, component, row;
    };
    std::vector<Value>                            values;
    std::map<std::array<Number, 3>, unsigned int> known;
    for (const NodalValue<dim> &value : fine)
      {
        Value at{{}, 0, value.component, unsigned(values.size())};
        for (unsigned int d = 0; d < dim; ++d)
          {
            const std::vector<double> &x = coarse.positions(d);
            const double               below =
              value.node[d] * (1. - Tolerances::rounding_of_data);
            unsigned int node =
              std::lower_bound(x.begin(), x.end(), below) - x.begin();
            Stencil stencil{1, {{1.}}};
            if (std::abs(x[node] - value.node[d]) >
                Tolerances::rounding_of_data * x.back())
              {
                node = (node - 1) / degree * degree; // its cell begins there
                stencil.n_nodes = degree + 1;
                for (unsigned int k = 0; k <= degree; ++k)
                  stencil.weights[k] = // the same in cells that round otherwise
                    Tolerances::rounding_of_data *
                    std::round(
                      lagrange(&x[node], degree, k, value.node[d]).value /
                      Tolerances::rounding_of_data);
              }
            const auto [place, is_new] =
              known.emplace(stencil.weights, stencils.size());
            if (is_new)
              stencils.push_back(stencil);
            at.run.stencils[d] = place->second;
            at.first += strides[d] * node;
          }
        at.run.end = at.first / (degree * strides[0]);
        values.push_back(at);
      }
    // A layer of coarse cells at a time stays in the cache, and processors
    // predict loops that are alike.
    std::sort(values.begin(), values.end(), [](const Value &a, const Value &b) {
      return std::tie(a.run.end, a.run.stencils, a.first) <
             std::tie(b.run.end, b.run.stencils, b.first);
    });
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        if (i % n_components == 0)
          {
            entries.push_back({values[i].first, {}});
            if (runs.empty() || runs.back().stencils != values[i].run.stencils)
              runs.push_back(values[i].run);
            runs.back().end = entries.size();
          }
        entries.back().rows[values[i].component] = values[i].row;
      }
  }



  template <int dim, typename Number>
  typename LevelTransfer<dim, Number>::Lines
  LevelTransfer<dim, Number>::lines_of(const Run &run,
                                       const bool is_diagonal) const
  {
    const auto stencil = [&](const unsigned int d) {
      Stencil result = stencils[run.stencils[d]];
      if (is_diagonal)
        for (Number &weight : result.weights)
          weight = std::abs(weight);
      return result;
    };
    const Stencil x = stencil(0),
                  y = dim == 3 ? stencil(1) : Stencil{1, {{1.}}};
    Lines result;
    for (unsigned int i = 0; i < x.n_nodes; ++i)
      for (unsigned int j = 0; j < y.n_nodes; ++j)
        {
          result.offsets[result.n_lines]   = i * strides[0] + j * strides[1];
          result.weights[result.n_lines++] = x.weights[i] * y.weights[j];
        }
    result.along = stencil(dim - 1);
    return result;
  }



  template <int dim, typename Number>
  template <typename Visit>
  void
  LevelTransfer<dim, Number>::visit_runs(const bool   is_diagonal,
                                         const Visit &visit) const
  {
    const Entry *begin = entries.data();
    for (const Run &run : runs)
      {
        const Lines  lines = lines_of(run, is_diagonal);
        const Entry *end   = entries.data() + run.end;
        const auto   pass  = [&](const auto n) {
          if (lines.along.n_nodes == 1)
            visit(n, Constant<1>(), lines, begin, end);
          else if (lines.along.n_nodes == 2)
            visit(n, Constant<2>(), lines, begin, end);
          else
            visit(n, Constant<3>(), lines, begin, end);
        };
        if (n_components == 1)
          pass(Constant<1>());
        else
          pass(Constant<dim>());
        begin = end;
      }
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::prolongate_and_add(
    LevelVector<Number>       &fine,
    const LevelVector<Number> &coarse) const
  {
    visit_runs(false,
               [x = coarse.begin(), y = fine.begin()](const auto   n,
                                                      const auto   n_along,
                                                      const Lines &lines,
                                                      const Entry *entry,
                                                      const Entry *end) {
                 for (; entry != end; ++entry)
                   {
                     std::array<Number, n * n_along> sum{};
                     for (unsigned int l = 0; l < lines.n_lines; ++l)
                       for (unsigned int i = 0; i < n * n_along; ++i)
                         sum[i] += lines.weights[l] *
                                   x[entry->first + lines.offsets[l] + i];
                     for (unsigned int c = 0; c < n; ++c)
                       {
                         Number value = 0;
                         for (unsigned int k = 0; k < n_along; ++k)
                           value += lines.along.weights[k] * sum[k * n + c];
                         y[entry->rows[c]] += value;
                       }
                   }
               });
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::restrict_to(LevelVector<Number>       &coarse,
                                          const LevelVector<Number> &fine,
                                          const bool is_diagonal) const
  {
    coarse = Number();
    visit_runs(is_diagonal,
               [x = fine.begin(), y = coarse.begin()](const auto   n,
                                                      const auto   n_along,
                                                      const Lines &lines,
                                                      const Entry *entry,
                                                      const Entry *end) {
                 for (; entry != end; ++entry)
                   {
                     std::array<Number, n * n_along> values;
                     for (unsigned int k = 0; k < n_along; ++k)
                       for (unsigned int c = 0; c < n; ++c)
                         values[k * n + c] =
                           lines.along.weights[k] * x[entry->rows[c]];
                     for (unsigned int l = 0; l < lines.n_lines; ++l)
                       for (unsigned int i = 0; i < n * n_along; ++i)
                         y[entry->first + lines.offsets[l] + i] +=
                           lines.weights[l] * values[i];
                   }
               });
    sum_over_ranks(coarse);
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::inject_to(LevelVector<Number>       &coarse,
                                        const LevelVector<Number> &fine) const
  {
    coarse = Number();
    visit_runs(false,
               [x = fine.begin(), y = coarse.begin()](const auto   n,
                                                      const auto   n_along,
                                                      const Lines &lines,
                                                      const Entry *entry,
                                                      const Entry *end) {
                 if (lines.n_lines == 1 && n_along == 1)
                   for (; entry != end; ++entry)
                     for (unsigned int c = 0; c < n; ++c)
                       y[entry->first + c] = x[entry->rows[c]];
               });
    sum_over_ranks(coarse);
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::sum_over_ranks(LevelVector<Number> &coarse) const
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;
    const unsigned int        n = coarse.locally_owned_size();
    const std::vector<Number> own(coarse.begin(), coarse.begin() + n);
    Utilities::MPI::sum(make_array_view(own),
                        communicator,
                        make_array_view(coarse.begin(), coarse.begin() + n));
  }



  template class LevelTransfer<2, float>;
  template class LevelTransfer<2, double>;
  template class LevelTransfer<3, float>;
  template class LevelTransfer<3, double>;
} // namespace ThermoContact
