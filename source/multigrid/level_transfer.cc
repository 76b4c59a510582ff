// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/level_transfer.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ThermoContact
{
  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::reinit(const LevelGrid<dim>               &coarse,
                                     const std::vector<NodalValue<dim>> &fine,
                                     const unsigned int n_components,
                                     const MPI_Comm     communicator)
  {
    this->n_components = n_components;
    this->communicator = communicator;
    degree             = coarse.degree();
    strides            = {};
    for (unsigned int d = 0; d < dim; ++d)
      strides[d] = coarse.strides()[d] * n_components;
    std::vector<Entry> values;
    for (const NodalValue<dim> &value : fine)
      {
        Entry entry{};
        entry.rows[value.component] = values.size();
        for (unsigned int d = 0; d < dim; ++d)
          {
            const std::vector<double> &x = coarse.positions(d);
            const double               at =
              value.node[d] * (1. - Tolerances::rounding_of_data);
            unsigned int node =
              std::lower_bound(x.begin(), x.end(), at) - x.begin();
            entry.weights[d] = {{1.}};
            if (std::abs(x[node] - value.node[d]) >
                Tolerances::rounding_of_data * x.back())
              {
                entry.between |= 1U << d;
                node = (node - 1) / degree * degree; // its cell begins there
                for (unsigned int k = 0; k <= degree; ++k)
                  entry.weights[d][k] =
                    lagrange(&x[node], degree, k, value.node[d]).value;
              }
            entry.first += strides[d] * node;
          }
        values.push_back(entry);
      }
    // processors predict the loops over corners where they are alike
    std::sort(values.begin(), values.end(), [](const Entry &a, const Entry &b) {
      return std::tie(a.between, a.first, a.weights) <
             std::tie(b.between, b.first, b.weights);
    });
    entries.clear();
    for (unsigned int i = 0; i < values.size(); ++i)
      if (i % n_components == 0)
        entries.push_back(values[i]);
      else
        for (unsigned int c = 0; c < n_components; ++c)
          entries.back().rows[c] += values[i].rows[c]; // the others have none
  }



  template <int dim, typename Number>
  template <unsigned int n>
  void
  LevelTransfer<dim, Number>::prolongate(Number       *fine,
                                         const Number *coarse) const
  {
    for (const Entry &entry : entries)
      {
        std::array<Number, n> sum{};
        visit_weights(entry,
                      [&](const unsigned int column, const Number weight) {
                        for (unsigned int c = 0; c < n; ++c)
                          sum[c] += weight * coarse[column + c];
                      });
        for (unsigned int c = 0; c < n; ++c)
          fine[entry.rows[c]] += sum[c];
      }
  }



  template <int dim, typename Number>
  template <unsigned int n>
  void LevelTransfer<dim, Number>::restrict(Number       *coarse,
                                            const Number *fine,
                                            const bool    is_diagonal) const
  {
    for (const Entry &entry : entries)
      {
        std::array<Number, n> value;
        for (unsigned int c = 0; c < n; ++c)
          value[c] = fine[entry.rows[c]];
        visit_weights(entry,
                      [&](const unsigned int column, const Number weight) {
                        for (unsigned int c = 0; c < n; ++c)
                          coarse[column + c] +=
                            (is_diagonal ? std::abs(weight) : weight) *
                            value[c];
                      });
      }
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::prolongate_and_add(
    LevelVector<Number>       &fine,
    const LevelVector<Number> &coarse) const
  {
    if (n_components == 1)
      prolongate<1>(fine.begin(), coarse.begin());
    else
      prolongate<dim>(fine.begin(), coarse.begin());
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::restrict_to(LevelVector<Number>       &coarse,
                                          const LevelVector<Number> &fine,
                                          const bool is_diagonal) const
  {
    coarse = Number();
    if (n_components == 1)
      restrict<1>(coarse.begin(), fine.begin(), is_diagonal);
    else
      restrict<dim>(coarse.begin(), fine.begin(), is_diagonal);
    sum_over_ranks(coarse);
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::inject_to(LevelVector<Number>       &coarse,
                                        const LevelVector<Number> &fine) const
  {
    coarse = Number();
    for (const Entry &entry : entries)
      if (entry.between == 0)
        for (unsigned int c = 0; c < n_components; ++c)
          coarse.local_element(entry.first + c) =
            fine.local_element(entry.rows[c]);
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
