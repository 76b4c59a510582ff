// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/level_lines.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

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
    const LevelVector<Number>          &vector,
    const std::vector<NodalValue<dim>> &values)
    : n_components(field == Field::temperature ? 1 : dim)
  {
    const IndexSet    &owned        = vector.locally_owned_elements();
    const MPI_Comm     communicator = vector.get_mpi_communicator();
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_lines = grid.strides()[0]; // the largest one
    const unsigned int length  = grid.positions(0).size();

    // indices of vectors by rows of the matrix, whole on every rank
    std::vector<unsigned int> indices(grid.n_nodes() * n_components);
    for (unsigned int i = 0; i < values.size(); ++i)
      {
        unsigned int node = 0;
        for (unsigned int d = 0; d < dim; ++d)
          node +=
            grid.strides()[d] * nearest(grid.positions(d), values[i].node[d]);
        indices[node * n_components + values[i].component] =
          owned.nth_index_in_set(i);
      }
    Utilities::MPI::sum(indices, communicator, indices);

    std::vector<unsigned int> own; // indices, line by line
    for (unsigned int line = rank; line < n_lines; line += n_ranks)
      for (unsigned int i = 0; i < length; ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          own.push_back(indices[(i * n_lines + line) * n_components + c]);
    std::vector<unsigned int> sorted(own);
    std::sort(sorted.begin(), sorted.end());
    IndexSet relevant(owned.size());
    relevant.add_indices(sorted.begin(), sorted.end());
    partitioner =
      std::make_shared<const Utilities::MPI::Partitioner>(owned,
                                                          relevant,
                                                          communicator);
    for (const unsigned int index : own)
      entries.push_back(partitioner->global_to_local(index));

    diagonal.resize(entries.size());
    coupling.resize(entries.size());
    matrix.visit_entries(field,
                         0.,
                         1.,
                         [&](const unsigned int row,
                             const unsigned int column,
                             const Number       value) {
                           const unsigned int node = row / n_components;
                           const unsigned int line = node % n_lines;
                           if (line % n_ranks != rank)
                             return;
                           const unsigned int place =
                             (line / n_ranks * length + node / n_lines) *
                               n_components +
                             row % n_components;
                           if (column == row)
                             diagonal[place] = value;
                           else if (column + n_lines * n_components == row)
                             coupling[place] = value;
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
    Vector on_lines(lines.partitioner);
    on_lines.copy_locally_owned_data_from(rest);
    on_lines.update_ghost_values();
    for (unsigned int i = 0; i < lines.entries.size(); ++i)
      {
        const double diagonal = stiffness * lines.diagonal[i] +
                                on_lines.local_element(lines.entries[i]);
        double pivot = diagonal;
        if (lines.coupling[i] != 0)
          {
            const double coupling = stiffness * lines.coupling[i];
            multipliers[i] = coupling * inverse_pivots[i - lines.n_components];
            pivot -= multipliers[i] * coupling;
          }
        inverse_pivots[i] = 1. / std::max(pivot, smallest_pivot * diagonal);
      }
    if (Utilities::MPI::n_mpi_processes(
          lines.partitioner->get_mpi_communicator()) > 1)
      shared.reinit(lines.partitioner);
  }



  template <int dim, typename Number>
  void
  LineFactors<dim, Number>::solve(LevelVector<Number> &values) const
  {
    const unsigned int  n        = lines.n_components;
    const std::size_t   size     = lines.entries.size();
    const unsigned int *entries  = lines.entries.data();
    const Number       *l        = multipliers.data();
    Number             *x        = scratch.data();
    const bool          is_alone = shared.size() == 0;
    Number             *on_lines = is_alone ? values.begin() : shared.begin();
    if (!is_alone)
      {
        copy_values(shared, values);
        shared.update_ghost_values();
      }
    for (std::size_t i = 0; i < size; ++i)
      x[i + n] = on_lines[entries[i]] - l[i] * x[i];
    if (!is_alone)
      shared = Number(); // with its ghosts
    for (std::size_t i = size; i-- > 0;)
      on_lines[entries[i]] = x[i + n] =
        inverse_pivots[i] * x[i + n] - l[i + n] * x[i + 2 * n];
    if (!is_alone)
      {
        shared.compress(VectorOperation::add);
        copy_values(values, shared);
      }
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
