// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/level_lines.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace ThermoContact
{
  template <int dim, typename Number>
  LevelLines<dim, Number>::LevelLines(
    const LevelMatrix<dim, Number>     &matrix,
    const LevelGrid<dim>               &grid,
    const Field::Block                  field,
    const LevelVector<Number>          &stiffness,
    const std::vector<NodalValue<dim>> &values)
    : n_components(field == Field::temperature ? 1 : dim)
  {
    const IndexSet    &owned        = stiffness.locally_owned_elements();
    const MPI_Comm     communicator = stiffness.get_mpi_communicator();
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_lines = grid.strides()[0]; // the largest one
    const unsigned int length  = grid.positions(0).size();

    // indices of vectors by rows of the matrix, whole on every rank
    std::vector<unsigned int> indices(grid.n_nodes() * n_components);
    for (unsigned int i = 0; i < values.size(); ++i)
      indices[grid.number(values[i].node) * n_components +
              values[i].component] = owned.nth_index_in_set(i);
    Utilities::MPI::sum(indices, communicator, indices);

    std::vector<unsigned int> own; // indices, line by line
    for (unsigned int line = rank; line < n_lines; line += n_ranks)
      for (unsigned int i = 0; i < length; ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          own.push_back(indices[(i * n_lines + line) * n_components + c]);
    IndexSet relevant(owned.size());
    relevant.add_indices(own.begin(), own.end());
    partitioner =
      std::make_shared<const Utilities::MPI::Partitioner>(owned,
                                                          relevant,
                                                          communicator);
    for (const unsigned int index : own)
      entries.push_back(partitioner->global_to_local(index));

    diagonal.resize(entries.size());
    coupling.resize(entries.size());
    const auto take = [&](const unsigned int row,
                          const unsigned int column,
                          const Number       value) {
      const unsigned int node = row / n_components, line = node % n_lines;
      const unsigned int place =
        (line / n_ranks * length + node / n_lines) * n_components +
        row % n_components;
      if (line % n_ranks == rank && column == row)
        diagonal[place] = value;
      else if (line % n_ranks == rank && column + n_lines * n_components == row)
        coupling[place] = value;
    };
    matrix.visit_entries(field, 0., 1., take);
    LevelVector<Number> least(partitioner);
    copy_values(least, stiffness);
    least.update_ghost_values();
    for (unsigned int i = 0; i < entries.size(); ++i)
      diagonal[i] =
        std::max(diagonal[i], Number(0.2) * least.local_element(entries[i]));
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
    , on_lines(lines.partitioner)
  {
    Vector shared_rest(lines.partitioner);
    shared_rest.copy_locally_owned_data_from(rest);
    shared_rest.update_ghost_values();
    for (unsigned int i = 0; i < lines.entries.size(); ++i)
      {
        const double diagonal = stiffness * lines.diagonal[i] +
                                shared_rest.local_element(lines.entries[i]);
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
    const std::size_t   size    = lines.entries.size();
    const unsigned int *entries = lines.entries.data();
    const Number       *l       = multipliers.data();
    Number             *x       = scratch.data();
    Number             *shared  = on_lines.begin();
    copy_values(on_lines, values);
    on_lines.update_ghost_values();
    for (std::size_t i = 0; i < size; ++i)
      x[i + n] = shared[entries[i]] - l[i] * x[i];
    on_lines = Number(); // with its ghosts
    for (std::size_t i = size; i-- > 0;)
      shared[entries[i]] = x[i + n] =
        inverse_pivots[i] * x[i + n] - l[i + n] * x[i + 2 * n];
    on_lines.compress(VectorOperation::add);
    copy_values(values, on_lines);
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
