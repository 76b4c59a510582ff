// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/stage_factors.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** The scene with matrices, refined from the same cells as the body. */
    Parameters
    with_matrices(const Scene &scene)
    {
      Parameters         result = scene.parameters;
      MeshParameters    &mesh   = result.mesh;
      const unsigned int n      = mesh.n_halvings();
      mesh.cells_across         = mesh.n_cells_across() >> n;
      mesh.cells >>= n;
      mesh.refinements += n;
      result.contact.massless_nodes =
        scene.contact.has_massless_nodes ? "on" : "off";
      result.solver.linear_solver = "direct";
      return result;
    }



    /** @p matrix with springs, and with held rows and columns of the identity. */
    SparseMatrix
    with_rows(const SparseMatrix &matrix, const ContactRows &rows)
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
          const auto                           own = local_rows(rows.held);
          std::vector<types::global_dof_index> all;
          for (const auto &of_rank :
               Utilities::MPI::all_gather(matrix.get_mpi_communicator(), own))
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
  } // namespace



  double
  factor_bytes(const double n_unknowns, const unsigned int dim)
  {
    return dim == 2 ? 330. * std::pow(n_unknowns, 1.22) :
                      92. * std::pow(n_unknowns, 1.54);
  }



  template <int dim>
  BodyMatrices<dim>::BodyMatrices(const Body<dim> &body)
    : scene(with_matrices(body.scene))
    , discretization(scene, body.discretization.communicator())
    , equations(scene, discretization)
  {}



  template <int dim>
  StageFactors<dim>::StageFactors(const BodyMatrices<dim> &matrices,
                                  const Field::Block       field,
                                  const double             tau)
    : without_contact(std::make_unique<DirectSolver>(
        field == Field::temperature ?
          matrices.operator_with_matrices().heat_stage_matrix(tau) :
          matrices.operator_with_matrices().momentum_stage_matrix(tau)))
  {}



  template <int dim>
  void
  StageFactors<dim>::set_contact(const ContactRows *rows,
                                 const bool         are_as_before)
  {
    has_contact = rows != nullptr;
    if (!has_contact || (are_as_before && with_contact))
      return;
    with_contact.reset(); // its memory, before there are other factors
    with_contact = std::make_unique<DirectSolver>(
      with_rows(without_contact->matrix(), *rows));
  }



  template <int dim>
  void
  StageFactors<dim>::vmult(Vector &z, const Vector &r) const
  {
    (has_contact ? with_contact : without_contact)->solve(z, r);
  }



  template class BodyMatrices<2>;
  template class BodyMatrices<3>;
  template class StageFactors<2>;
  template class StageFactors<3>;
} // namespace ThermoContact
