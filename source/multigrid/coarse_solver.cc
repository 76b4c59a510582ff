// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/multigrid/coarse_solver.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_tools.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <vector>

namespace ThermoContact
{
  template <int dim>
  CoarseSolver<dim>::CoarseSolver(const DoFHandler<dim> &space,
                                  const Field::Block     field,
                                  SparseMatrix         &&matrix,
                                  const bool             has_factors)
  {
    if (has_factors)
      factors = std::make_unique<DirectSolver>(std::move(matrix));
    else
      {
        unfactorized = std::make_unique<const SparseMatrix>(std::move(matrix));
        make_cycle(space, field);
      }
  }



  template <int dim>
  void
  CoarseSolver<dim>::make_cycle(const DoFHandler<dim> &space,
                                const Field::Block     field)
  {
    TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.smoother_sweeps = 2;
    DoFTools::extract_constant_modes(
      space,
      ComponentMask(field == Field::temperature ? 1 : dim, true),
      data.constant_modes);
    Teuchos::ParameterList              parameters;
    std::unique_ptr<Epetra_MultiVector> modes;
    data.set_parameters(parameters, modes, *unfactorized);
    // from the rows of the matrix: estimates by iterations start at random and
    // differ from one time to the next
    parameters.set("eigen-analysis: type", "Anorm");
    cycle = std::make_unique<TrilinosWrappers::PreconditionAMG>();
    cycle->initialize(*unfactorized, parameters);
  }



  template <int dim>
  void
  CoarseSolver<dim>::solve(Vector &x, const Vector &b) const
  {
    if (factors)
      factors->solve(x, b);
    else
      cycle->vmult(x, b);
  }



  SparseMatrix
  with_contact(const SparseMatrix &matrix, const ContactRows &rows)
  {
    SparseMatrix result;
    result.copy_from(matrix);
    const auto local_rows = [](const Vector &values) {
      std::vector<types::global_dof_index> local;
      const IndexSet &owned = values.locally_owned_elements();
      for (unsigned int i = 0; i < values.locally_owned_size(); ++i)
        if (values.local_element(i) > 0.)
          local.push_back(owned.nth_index_in_set(i));
      return local;
    };
    if (rows.springs.size() > 0)
      {
        for (const types::global_dof_index row : local_rows(rows.springs))
          result.add(row, row, rows.springs(row));
        result.compress(VectorOperation::add);
      }
    if (rows.held.size() > 0)
      {
        const std::vector<types::global_dof_index> own = local_rows(rows.held);
        std::vector<types::global_dof_index>       all;
        for (const auto &of_rank :
             all_gather(matrix.get_mpi_communicator(), own))
          all.insert(all.end(), of_rank.begin(), of_rank.end());
        std::sort(all.begin(), all.end());
        for (const types::global_dof_index row :
             result.locally_owned_range_indices())
          for (auto entry = result.begin(row); entry != result.end(row);
               ++entry)
            if (std::binary_search(all.begin(), all.end(), entry->column()))
              entry->value() = 0.;
        result.compress(VectorOperation::insert);
        result.clear_rows(own, 1.);
      }
    return result;
  }



  template class CoarseSolver<2>;
  template class CoarseSolver<3>;
} // namespace ThermoContact
