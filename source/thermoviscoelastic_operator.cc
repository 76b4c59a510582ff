// SPDX-License-Identifier: LGPL-2.1-or-later

#include "thermoviscoelastic_operator.h"

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/block_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>
#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

namespace ThermoContact
{
  namespace
  {
    const FEValuesExtractors::Scalar temperature(0);
    const FEValuesExtractors::Vector displacement(1);

    /** Field matrices know nothing of the fixed end. */
    AffineConstraints<double>
    no_constraints()
    {
      AffineConstraints<double> constraints;
      constraints.close();
      return constraints;
    }



    /**
     * Adds @p factor times @p block to @p target at the offsets of the block
     * in the whole system. Rows in @p skipped are left out; columns of
     * constrained degrees of freedom stay, since they meet vanishing rates.
     */
    void
    add_block(const SparseMatrix           &block,
              const double                  factor,
              const types::global_dof_index row_offset,
              const types::global_dof_index column_offset,
              const IndexSet               &skipped,
              SparseMatrix                 &target)
    {
      std::vector<types::global_dof_index> columns;
      std::vector<double>                  values;
      for (const types::global_dof_index row :
           block.locally_owned_range_indices())
        {
          if (skipped.is_element(row))
            continue;
          columns.clear();
          values.clear();
          // On several ranks Trilinos adds zero entries of its own to the
          // pattern of a block, which the whole matrix does not have.
          for (auto entry = block.begin(row); entry != block.end(row); ++entry)
            if (entry->value() != 0.)
              {
                columns.push_back(entry->column() + column_offset);
                values.push_back(factor * entry->value());
              }
          target.add(row + row_offset,
                     columns.size(),
                     columns.data(),
                     values.data(),
                     false);
        }
    }
  } // namespace



  template <int dim>
  ThermoviscoelasticOperator<dim>::ThermoviscoelasticOperator(
    const Discretization<dim> &discretization,
    const Parameters          &parameters)
    : discretization(discretization)
    , model(parameters.model)
    , boundary(parameters.boundary)
    , heat_scratch(discretization.make_vector(0))
    , momentum_scratch(discretization.make_vector(1))
  {
    setup_matrices();
    assemble_cells();
    assemble_contact_end();
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::setup_matrices()
  {
    const auto make_matrix = [this](const bool         couples_fields,
                                    BlockSparseMatrix &matrix) {
      Table<2, DoFTools::Coupling> couplings(1 + dim, 1 + dim);
      for (unsigned int i = 0; i < 1 + dim; ++i)
        for (unsigned int j = 0; j < 1 + dim; ++j)
          couplings(i, j) = ((i == 0) == (j == 0)) != couples_fields ?
                              DoFTools::always :
                              DoFTools::none;
      TrilinosWrappers::BlockSparsityPattern pattern(
        discretization.owned_by_block(),
        discretization.owned_by_block(),
        discretization.relevant_by_block(),
        discretization.communicator());
      DoFTools::make_sparsity_pattern(discretization.dof_handler(),
                                      couplings,
                                      pattern,
                                      AffineConstraints<double>(),
                                      true,
                                      Utilities::MPI::this_mpi_process(
                                        discretization.communicator()));
      pattern.compress();
      matrix.reinit(pattern);
    };
    make_matrix(false, mass);
    make_matrix(false, stiffness_);
    make_matrix(true, coupling);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::assemble_cells()
  {
    const FiniteElement<dim>       &fe = discretization.finite_element();
    FEValues<dim>                   fe_values(discretization.mapping(),
                            fe,
                            QGauss<dim>(fe.degree + 1),
                            update_values | update_gradients |
                              update_JxW_values);
    const AffineConstraints<double> unconstrained = no_constraints();

    const unsigned int                   n = fe.dofs_per_cell;
    FullMatrix<double>                   cell_mass(n, n);
    FullMatrix<double>                   cell_stiffness(n, n);
    FullMatrix<double>                   cell_coupling(n, n);
    std::vector<types::global_dof_index> dofs(n);

    // Elasticity scaled to unit P-wave modulus, doc/model.md (M.6).
    const double nu     = model.poisson_ratio;
    const double lambda = nu / (1. - nu);
    const double two_mu = (1. - 2. * nu) / (1. - nu);

    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          cell_mass         = 0.;
          cell_stiffness    = 0.;
          cell_coupling     = 0.;
          const auto &theta = fe_values[temperature];
          const auto &u     = fe_values[displacement];
          for (const unsigned int q : fe_values.quadrature_point_indices())
            for (const unsigned int i : fe_values.dof_indices())
              for (const unsigned int j : fe_values.dof_indices())
                {
                  const double JxW = fe_values.JxW(q);
                  cell_mass(i, j) += (theta.value(i, q) * theta.value(j, q) +
                                      u.value(i, q) * u.value(j, q)) *
                                     JxW;
                  cell_stiffness(i, j) +=
                    (theta.gradient(i, q) * theta.gradient(j, q) +
                     lambda * u.divergence(i, q) * u.divergence(j, q) +
                     two_mu * (u.symmetric_gradient(i, q) *
                               u.symmetric_gradient(j, q))) *
                    JxW;
                  cell_coupling(i, j) +=
                    (theta.value(i, q) * u.divergence(j, q) +
                     u.divergence(i, q) * theta.value(j, q)) *
                    JxW;
                }
          cell->get_dof_indices(dofs);
          unconstrained.distribute_local_to_global(cell_mass, dofs, mass);
          unconstrained.distribute_local_to_global(cell_stiffness,
                                                   dofs,
                                                   stiffness_);
          unconstrained.distribute_local_to_global(cell_coupling,
                                                   dofs,
                                                   coupling);
        }
    for (BlockSparseMatrix *matrix : {&mass, &stiffness_, &coupling})
      matrix->compress(VectorOperation::add);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::assemble_contact_end()
  {
    const FiniteElement<dim>       &fe = discretization.finite_element();
    FEFaceValues<dim>               face_values(discretization.mapping(),
                                  fe,
                                  QGauss<dim - 1>(fe.degree + 1),
                                  update_values | update_JxW_values);
    const AffineConstraints<double> unconstrained = no_constraints();

    FullMatrix<double> cell_matrix(fe.dofs_per_cell, fe.dofs_per_cell);
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    const auto                          &theta = face_values[temperature];
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == contact_boundary_id)
            {
              face_values.reinit(cell, f);
              cell_matrix = 0.;
              for (const unsigned int q :
                   face_values.quadrature_point_indices())
                for (const unsigned int i : face_values.dof_indices())
                  for (const unsigned int j : face_values.dof_indices())
                    cell_matrix(i, j) += boundary.heat_exchange *
                                         theta.value(i, q) * theta.value(j, q) *
                                         face_values.JxW(q);
              cell->get_dof_indices(dofs);
              unconstrained.distribute_local_to_global(cell_matrix,
                                                       dofs,
                                                       stiffness_);
            }
    stiffness_.compress(VectorOperation::add);
  }



  template <int dim>
  SparseMatrix
  ThermoviscoelasticOperator<dim>::heat_stage_matrix(const double tau) const
  {
    return combine(heat_mass(), 1., conduction(), tau, 0);
  }



  template <int dim>
  SparseMatrix
  ThermoviscoelasticOperator<dim>::momentum_stage_matrix(const double tau) const
  {
    return combine(momentum_mass(),
                   model.inertia,
                   stiffness(),
                   tau * model.viscosity + tau * tau,
                   1);
  }



  template <int dim>
  SparseMatrix
  ThermoviscoelasticOperator<dim>::combine(const SparseMatrix &first,
                                           const double        first_factor,
                                           const SparseMatrix &second,
                                           const double        second_factor,
                                           const unsigned int  block) const
  {
    SparseMatrix matrix;
    matrix.copy_from(first);
    matrix *= first_factor;
    matrix.add(second_factor, second);

    std::vector<types::global_dof_index> rows;
    discretization.constrained(block).fill_index_vector(rows);
    matrix.clear_rows(rows, 1.);
    return matrix;
  }



  template <int dim>
  SparseMatrix
  ThermoviscoelasticOperator<dim>::stage_matrix(const double tau) const
  {
    TrilinosWrappers::SparsityPattern pattern(discretization.owned(),
                                              discretization.owned(),
                                              discretization.relevant(),
                                              discretization.communicator());
    DoFTools::make_sparsity_pattern(discretization.dof_handler(),
                                    pattern,
                                    AffineConstraints<double>(),
                                    true,
                                    Utilities::MPI::this_mpi_process(
                                      discretization.communicator()));
    pattern.compress();
    SparseMatrix matrix;
    matrix.reinit(pattern);

    const double                  a = model.coupling;
    const types::global_dof_index n = discretization.n_temperature_dofs();
    const IndexSet                none_of_heat(n);
    const IndexSet none_of_momentum(discretization.n_displacement_dofs());
    add_block(heat_stage_matrix(tau), 1., 0, 0, none_of_heat, matrix);
    add_block(divergence(), a, 0, n, discretization.constrained(0), matrix);
    add_block(thermal_stress(),
              -tau * tau * a,
              n,
              0,
              discretization.constrained(1),
              matrix);
    add_block(momentum_stage_matrix(tau), 1., n, n, none_of_momentum, matrix);
    matrix.compress(VectorOperation::add);
    return matrix;
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::stage_rhs(const State  &known,
                                             const double  tau,
                                             const Vector &heat_load,
                                             const Vector &momentum_load,
                                             Vector       &heat,
                                             Vector       &momentum) const
  {
    conduction().vmult(heat, known.temperature);
    heat.sadd(-1., heat_load);
    zero_constrained(0, heat);

    thermal_stress().vmult(momentum, known.temperature);
    momentum *= model.coupling;
    stiffness().vmult(momentum_scratch, known.displacement);
    momentum.add(-1., momentum_scratch, 1., momentum_load);
    momentum_mass().vmult(momentum_scratch, known.velocity);
    momentum.sadd(tau, model.inertia, momentum_scratch);
    zero_constrained(1, momentum);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::subtract_heating(const Vector &velocity,
                                                    Vector       &heat) const
  {
    divergence().vmult(heat_scratch, velocity);
    heat.add(-model.coupling, heat_scratch);
    zero_constrained(0, heat);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::add_thermal_stress(const Vector &temperature,
                                                      const double  factor,
                                                      Vector &momentum) const
  {
    thermal_stress().vmult(momentum_scratch, temperature);
    momentum.add(factor * model.coupling, momentum_scratch);
    zero_constrained(1, momentum);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::subtract_pressure(
    const std::vector<double> &pressure,
    const double               factor,
    Vector                    &momentum) const
  {
    for (const auto &[node, entry] : discretization.contact_entries(1))
      momentum.begin()[entry] -=
        factor * discretization.contact_nodes()[node].weight * pressure[node];
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::zero_constrained(const unsigned int block,
                                                    Vector &vector) const
  {
    for (const unsigned int entry : discretization.constrained_entries(block))
      vector.begin()[entry] = 0.;
  }



  template class ThermoviscoelasticOperator<1>;
  template class ThermoviscoelasticOperator<2>;
  template class ThermoviscoelasticOperator<3>;
} // namespace ThermoContact
