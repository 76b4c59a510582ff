// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/level_transfer.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::reinit(const LevelGrid<dim>               &coarse,
                                     const std::vector<NodalValue<dim>> &fine,
                                     const unsigned int n_components,
                                     const MPI_Comm     communicator)
  {
    this->communicator = communicator;
    entries.clear();
    const auto strides = coarse.strides();
    for (unsigned int corner = 0; corner < n_corners; ++corner)
      {
        corners[corner] = 0;
        for (unsigned int d = 0; d < dim; ++d)
          if ((corner >> d & 1U) != 0)
            corners[corner] += strides[d] * n_components;
      }
    for (const NodalValue<dim> &value : fine)
      {
        Entry entry{static_cast<unsigned int>(entries.size()),
                    value.component,
                    0,
                    {}};
        for (unsigned int d = 0; d < dim; ++d)
          {
            const std::vector<double> &x = coarse.positions(d);
            // the last node is the upper one of the last cell
            unsigned int cell =
              std::upper_bound(x.begin() + 1, x.end() - 1, value.node[d]) -
              x.begin() - 1;
            const double place =
              (value.node[d] - x[cell]) / (x[cell + 1] - x[cell]);
            if (std::abs(place - std::round(place)) >=
                Tolerances::rounding_of_data)
              entry.between |= 1U << d;
            else
              cell += std::lround(place);
            entry.place[d] = place;
            entry.first += strides[d] * n_components * cell;
          }
        entries.push_back(entry);
      }
    // processors predict the loops over corners where they are alike
    std::stable_sort(entries.begin(),
                     entries.end(),
                     [](const Entry &a, const Entry &b) {
                       return a.between < b.between;
                     });
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::prolongate_and_add(
    LevelVector<Number>       &fine,
    const LevelVector<Number> &coarse) const
  {
    const Number *from = coarse.begin();
    Number       *to   = fine.begin();
    visit_weights(
      [&](const unsigned int row,
          const unsigned int column,
          const Number       weight) { to[row] += weight * from[column]; });
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::restrict_to(LevelVector<Number>       &coarse,
                                          const LevelVector<Number> &fine) const
  {
    coarse             = Number();
    const Number *from = fine.begin();
    Number       *to   = coarse.begin();
    visit_weights(
      [&](const unsigned int row,
          const unsigned int column,
          const Number       weight) { to[column] += weight * from[row]; });
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;
    const unsigned int        n = coarse.locally_owned_size();
    const std::vector<Number> own(to, to + n);
    Utilities::MPI::sum(make_array_view(own),
                        communicator,
                        make_array_view(to, to + n));
  }



  template class LevelTransfer<2, float>;
  template class LevelTransfer<2, double>;
  template class LevelTransfer<3, float>;
  template class LevelTransfer<3, double>;
} // namespace ThermoContact
