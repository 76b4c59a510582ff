// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/dealii_versions.h>
#include <thermocontact/space/system_matrix.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <vector>

namespace ThermoContact
{
  namespace
  {
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
          read_row(block,
                   row,
                   [&](const types::global_dof_index column,
                       const double                  value) {
                     if (value != 0.)
                       {
                         columns.push_back(column + column_offset);
                         values.push_back(factor * value);
                       }
                   });
          target.add(row + row_offset,
                     columns.size(),
                     columns.data(),
                     values.data(),
                     false);
        }
    }
  } // namespace



  namespace
  {
    /** The field matrices of equations, one after the other. */
    template <int dim>
    class AssembledMatrices
    {
    public:
      explicit AssembledMatrices(
        const ThermoviscoelasticOperator<dim> &equations)
        : equations(equations)
      {}

      /** Of a rod assembled from its cells; valid until the next one is. */
      const SparseMatrix &
      operator[](const FieldMatrix::Kind kind)
      {
        const RodMatrices *const rod = equations.rod();
        if (rod == nullptr)
          return (*equations.matrices())[kind];
        const auto [rows, columns] = fields_of(kind);
        const auto        &owned   = equations.space().owned_by_block();
        const unsigned int n       = rod->layout().nodes_per_cell();
        std::vector<types::global_dof_index> nodes(n);
        TrilinosWrappers::SparsityPattern    pattern(
          owned[rows], owned[columns], equations.space().communicator(), 2 * n);
        const auto for_each_cell = [&](const auto &action) {
          for (const RodMatrices::Run &run : rod->runs())
            for (unsigned int cell = run.begin; cell < run.end; ++cell)
              {
                for (unsigned int i = 0; i < n; ++i)
                  nodes[i] = rod->layout().node(cell, i);
                action(run);
              }
        };
        for_each_cell([&](const RodMatrices::Run &) {
          for (const types::global_dof_index row : nodes)
            pattern.add_entries(row, nodes.begin(), nodes.end());
        });
        pattern.compress();
        of_rod.reinit(pattern);
        FullMatrix<double> entries(n, n);
        for_each_cell([&](const RodMatrices::Run &run) {
          const double *entry = rod->entries(run, kind);
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              entries(i, j) = *entry++;
          of_rod.add(nodes, nodes, entries);
        });
        of_rod.compress(VectorOperation::add);
        return of_rod;
      }

    private:
      const ThermoviscoelasticOperator<dim> &equations;
      SparseMatrix                           of_rod;
    };
  } // namespace



  template <int dim>
  SparseMatrix
  field_matrix(const ThermoviscoelasticOperator<dim> &equations,
               const SystemCoefficients              &coefficients,
               const Field::Block                     field)
  {
    AssembledMatrices<dim> matrices(equations);
    const bool             has_viscous =
      equations.matrices()->has(FieldMatrix::viscous_stiffness);
    SparseMatrix matrix;
    matrix.copy_from(
      matrices[field == Field::temperature ? FieldMatrix::heat_mass :
                                             FieldMatrix::momentum_mass]);
    matrix *= 0.;
    for (const auto &[factor, kind] :
         block_terms(coefficients, equations.coefficients(), field))
      if (factor != 0.)
        matrix.add(
          factor,
          matrices[kind == FieldMatrix::viscous_stiffness && !has_viscous ?
                     FieldMatrix::stiffness :
                     kind]);

    const IndexSet &constrained = equations.space().constrained(field);
    const std::vector<types::global_dof_index> rows(constrained.begin(),
                                                    constrained.end());
    matrix.clear_rows(rows, 1.);
    return matrix;
  }



  template <int dim>
  SparseMatrix
  whole_matrix(const ThermoviscoelasticOperator<dim> &equations,
               const SystemCoefficients              &coefficients)
  {
    const Discretization<dim> &space    = equations.space();
    const Material            &material = equations.coefficients();
    AssembledMatrices<dim>     matrices(equations);
    Assert(material.has_thermal_stress(), ExcInternalError());
    TrilinosWrappers::SparsityPattern pattern(space.owned(),
                                              space.owned(),
                                              space.relevant(),
                                              space.communicator());
    DoFTools::make_sparsity_pattern(space.dof_handler(),
                                    pattern,
                                    AffineConstraints<double>(),
                                    true,
                                    Utilities::MPI::this_mpi_process(
                                      space.communicator()));
    pattern.compress();
    SparseMatrix matrix;
    matrix.reinit(pattern);

    const types::global_dof_index n = space.n_temperature_dofs();
    for (const Field::Block field : all_fields)
      add_block(field_matrix(equations, coefficients, field),
                1.,
                space.first_dof(field),
                space.first_dof(field),
                IndexSet(space.owned_by_block()[field].size()),
                matrix);
    const CouplingFactors coupling = coupling_factors(coefficients, material);
    add_block(matrices[FieldMatrix::divergence],
              coupling.heating,
              0,
              n,
              space.constrained(Field::temperature),
              matrix);
    add_block(matrices[FieldMatrix::thermal_stress],
              coupling.thermal_stress,
              n,
              0,
              space.constrained(Field::displacement),
              matrix);
    matrix.compress(VectorOperation::add);
    return matrix;
  }



#define INSTANTIATE(dim)                     \
  template SparseMatrix field_matrix<dim>(   \
    const ThermoviscoelasticOperator<dim> &, \
    const SystemCoefficients &,              \
    const Field::Block);                     \
  template SparseMatrix whole_matrix<dim>(   \
    const ThermoviscoelasticOperator<dim> &, const SystemCoefficients &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
