// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/level_transfer.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace ThermoContact
{
  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::reinit(const LevelGrid<dim>         &coarse,
                                     const LevelGrid<dim>         &fine,
                                     std::vector<LevelNode<dim>> &&nodes,
                                     const unsigned int            n_components,
                                     const MPI_Comm                communicator)
  {
    this->nodes         = std::move(nodes);
    this->n_components  = n_components;
    this->communicator  = communicator;
    unsigned int stride = n_components;
    for (unsigned int d = dim; d-- > 0;)
      {
        strides[d] = stride;
        stride *= coarse.axis(d).n_nodes();
      }
    for (unsigned int d = 0; d < 2; ++d)
      {
        const GridAxis &from  = coarse.axis(d);
        const auto      basis = Polynomials::generate_complete_Lagrange_basis(
          QGaussLobatto<1>(from.degree + 1).get_points());
        Axis        &axis = axes[d];
        unsigned int cell = 0;
        axis.n_weights    = basis.size();
        for (const double x : fine.axis(d).nodes())
          {
            while (cell + 1 < from.n_cells() && x >= from.ends[cell + 1])
              ++cell;
            const double place =
              (x - from.ends[cell]) / (from.ends[cell + 1] - from.ends[cell]);
            axis.first.push_back(cell * from.degree);
            for (const auto &polynomial : basis)
              {
                const double weight = polynomial.value(place);
                axis.weights.push_back(
                  std::abs(weight) < Tolerances::rounding_of_sum ? 0. : weight);
              }
          }
      }
  }



  template <int dim, typename Number>
  template <typename Visit>
  inline void
  LevelTransfer<dim, Number>::visit_weights(const LevelNode<dim> &node,
                                            const Visit          &visit) const
  {
    std::array<const Number *, dim> weights;
    unsigned int                    first = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const Axis &axis = axes[d > 0];
        weights[d]       = &axis.weights[node.index[d] * axis.n_weights];
        first += strides[d] * axis.first[node.index[d]];
      }
    for (unsigned int i = 0; i < axes[0].n_weights; ++i)
      if (weights[0][i] != 0)
        for (unsigned int j = 0; j < axes[1].n_weights; ++j)
          if (weights[1][j] != 0)
            {
              const unsigned int entry =
                first + i * strides[0] + j * strides[1];
              const Number weight = weights[0][i] * weights[1][j];
              if constexpr (dim == 2)
                visit(entry, weight);
              else
                for (unsigned int k = 0; k < axes[1].n_weights; ++k)
                  if (weights[2][k] != 0)
                    visit(entry + k * strides[2], weight * weights[2][k]);
            }
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::prolongate_and_add(
    LevelVector<Number>       &fine,
    const LevelVector<Number> &coarse) const
  {
    const Number *from = coarse.begin();
    Number       *to   = fine.begin();
    for (const LevelNode<dim> &node : nodes)
      visit_weights(node, [&](const unsigned int entry, const Number weight) {
        for (unsigned int c = 0; c < n_components; ++c)
          to[node.position + c * node.stride] += weight * from[entry + c];
      });
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::restrict_to(LevelVector<Number>       &coarse,
                                          const LevelVector<Number> &fine) const
  {
    coarse             = Number();
    const Number *from = fine.begin();
    Number       *to   = coarse.begin();
    for (const LevelNode<dim> &node : nodes)
      visit_weights(node, [&](const unsigned int entry, const Number weight) {
        for (unsigned int c = 0; c < n_components; ++c)
          to[entry + c] += weight * from[node.position + c * node.stride];
      });
    sum_over_ranks(coarse);
  }



  template <int dim, typename Number>
  void
  LevelTransfer<dim, Number>::inject(LevelVector<Number>       &coarse,
                                     const LevelVector<Number> &fine) const
  {
    coarse = Number();
    for (const LevelNode<dim> &node : nodes)
      visit_weights(node, [&](const unsigned int entry, const Number weight) {
        if (weight == 1)
          for (unsigned int c = 0; c < n_components; ++c)
            coarse.local_element(entry + c) =
              fine.local_element(node.position + c * node.stride);
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
