// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/field_maps.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>

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
      // deal.II's iterators set up arrays of the whole width at each row.
      const Epetra_CrsMatrix              &source = block.trilinos_matrix();
      std::vector<types::global_dof_index> columns;
      std::vector<double>                  values;
      for (int local_row = 0; local_row < source.NumMyRows(); ++local_row)
        {
          const types::global_dof_index row = source.RowMap().GID64(local_row);
          if (skipped.is_element(row))
            continue;
          int     n_entries   = 0;
          double *row_values  = nullptr;
          int    *row_columns = nullptr;
          source.ExtractMyRowView(local_row,
                                  n_entries,
                                  row_values,
                                  row_columns);
          columns.clear();
          values.clear();
          // On several ranks Trilinos adds zero entries of its own to the
          // pattern of a block, which the whole matrix does not have.
          for (int i = 0; i < n_entries; ++i)
            if (row_values[i] != 0.)
              {
                columns.push_back(source.ColMap().GID64(row_columns[i]) +
                                  column_offset);
                values.push_back(factor * row_values[i]);
              }
          target.add(row + row_offset,
                     columns.size(),
                     columns.data(),
                     values.data(),
                     false);
        }
    }



    template <int dim>
    std::unique_ptr<const CellProducts<dim, double>>
    make_cell_products(const Scene               &scene,
                       const Discretization<dim> &discretization)
    {
      if constexpr (dim > 1)
        if (!scene.linear_solver.has_matrices())
          return std::make_unique<const CellProducts<dim, double>>(
            scene, discretization);
      return nullptr;
    }

  } // namespace



  template <int dim>
  ThermoviscoelasticOperator<dim>::ThermoviscoelasticOperator(
    const Scene               &scene,
    const Discretization<dim> &discretization,
    const FieldMatrices<dim>  *matrices)
    : discretization(discretization)
    , material(scene.material)
    , has_own_viscous_stiffness(scene.has_elastic_contact_nodes())
    , is_along_rod(scene.linear_solver.is_along_rod)
    , matrices(matrices)
    , cell_products_(make_cell_products(scene, discretization))
    , heat_scratch(discretization.make_vector(Field::temperature))
    , momentum_scratch(discretization.make_vector(Field::displacement))
  {
    FieldMaps &maps = *this;
    if (matrices != nullptr)
      maps = FieldMaps(*matrices);
    else if constexpr (dim > 1)
      maps = FieldMaps(*cell_products_);
  }



  template <int dim>
  ThermoviscoelasticOperator<dim>::~ThermoviscoelasticOperator() = default;



  template <int dim>
  SparseMatrix
  ThermoviscoelasticOperator<dim>::sum(
    const Field::Block                                       field,
    const std::vector<std::pair<double, FieldMatrix::Kind>> &terms) const
  {
    SparseMatrix matrix;
    matrix.copy_from((*matrices)[terms.front().second]);
    matrix *= 0.;
    for (const auto &[factor, kind] : terms)
      matrix.add(factor, (*matrices)[kind]);

    const IndexSet &constrained = discretization.constrained(field);
    const std::vector<types::global_dof_index> rows(constrained.begin(),
                                                    constrained.end());
    matrix.clear_rows(rows, 1.);
    return matrix;
  }



  template <int dim>
  SparseMatrix
  ThermoviscoelasticOperator<dim>::heat_stage_matrix(const double tau,
                                                     const double mass) const
  {
    return sum(Field::temperature,
               {{mass, FieldMatrix::heat_mass},
                {tau, FieldMatrix::conduction}});
  }



  template <int dim>
  SparseMatrix
  ThermoviscoelasticOperator<dim>::momentum_stage_matrix(const double tau) const
  {
    const double viscous = tau * material.viscosity;
    if (!has_own_viscous_stiffness)
      return sum(Field::displacement,
                 {{material.inertia, FieldMatrix::momentum_mass},
                  {viscous + tau * tau, FieldMatrix::stiffness}});
    return sum(Field::displacement,
               {{tau * tau, FieldMatrix::stiffness},
                {viscous, FieldMatrix::viscous_stiffness},
                {material.inertia, FieldMatrix::momentum_mass}});
  }



  template <int dim>
  SparseMatrix
  ThermoviscoelasticOperator<dim>::stage_matrix(const double tau) const
  {
    Assert(material.has_thermal_stress(), ExcInternalError());
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

    const types::global_dof_index n = discretization.n_temperature_dofs();
    const IndexSet                none_of_heat(n);
    const IndexSet none_of_momentum(discretization.n_displacement_dofs());
    add_block(heat_stage_matrix(tau), 1., 0, 0, none_of_heat, matrix);
    add_block((*matrices)[FieldMatrix::divergence],
              tau * material.heating,
              0,
              n,
              discretization.constrained(Field::temperature),
              matrix);
    add_block((*matrices)[FieldMatrix::thermal_stress],
              -tau * material.thermal_stress,
              n,
              0,
              discretization.constrained(Field::displacement),
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
    if (rod() != nullptr)
      {
        rod_stage_rhs(known, tau, heat_load, momentum_load, heat, momentum);
        return;
      }
    if (discretization.has_field(Field::temperature))
      {
        conduction.vmult(heat, known.temperature);
        heat.sadd(-1., heat_load);
        zero_constrained(Field::temperature, heat);
      }
    if (!discretization.has_field(Field::displacement))
      return;
    momentum.equ(tau, momentum_load);
    stiffness.add(-tau, known.displacement, momentum, momentum_scratch);
    if (material.has_thermal_stress())
      thermal_stress.add(tau * material.thermal_stress,
                         known.temperature,
                         momentum,
                         momentum_scratch);
    if (material.has_inertia())
      momentum_mass.add(material.inertia,
                        known.velocity,
                        momentum,
                        momentum_scratch);
    zero_constrained(Field::displacement, momentum);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::rod_stage_rhs(const State  &known,
                                                 const double  tau,
                                                 const Vector &heat_load,
                                                 const Vector &momentum_load,
                                                 Vector       &heat,
                                                 Vector       &momentum) const
  {
    using Term                  = RodMatrices::Term;
    const RodMatrices &products = *rod();
    if (discretization.has_field(Field::temperature))
      {
        products.combine<1>(
          {{{-1., RodMatrices::conduction, known.temperature.begin()}}},
          1.,
          heat_load.begin(),
          heat.begin());
        zero_constrained(Field::temperature, heat);
      }
    if (!discretization.has_field(Field::displacement))
      return;
    const Term elastic = {-tau,
                          RodMatrices::stiffness,
                          known.displacement.begin()};
    const Term inertia = {material.inertia,
                          RodMatrices::momentum_mass,
                          known.velocity.begin()};
    const Term thermal = {tau * material.thermal_stress,
                          RodMatrices::thermal_stress,
                          known.temperature.begin()};
    const auto set     = [&](const auto &terms) {
      products.combine(terms, tau, momentum_load.begin(), momentum.begin());
    };
    if (material.has_inertia() && material.has_thermal_stress())
      set(std::array<Term, 3>{{elastic, inertia, thermal}});
    else if (material.has_inertia())
      set(std::array<Term, 2>{{elastic, inertia}});
    else if (material.has_thermal_stress())
      set(std::array<Term, 2>{{elastic, thermal}});
    else
      set(std::array<Term, 1>{{elastic}});
    zero_constrained(Field::displacement, momentum);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::momentum_residual(
    const State  &state,
    const Vector *velocity,
    const Vector *acceleration,
    const Vector &momentum_load,
    Vector       &residual) const
  {
    Vector &product = momentum_scratch;
    residual        = momentum_load;
    stiffness.add(-1., state.displacement, residual, product);
    if (material.has_thermal_stress())
      thermal_stress.add(material.thermal_stress,
                         state.temperature,
                         residual,
                         product);
    if (velocity != nullptr && material.has_viscosity())
      viscous_stiffness.add(-material.viscosity, *velocity, residual, product);
    if (acceleration != nullptr && material.has_inertia())
      momentum_mass.add(-material.inertia, *acceleration, residual, product);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::subtract_stage_product(
    const double  tau,
    const Vector &temperature_rate,
    const Vector &velocity,
    Vector       &heat,
    Vector       &momentum) const
  {
    if (discretization.has_field(Field::temperature))
      {
        heat_mass.add(-1., temperature_rate, heat, heat_scratch);
        conduction.add(-tau, temperature_rate, heat, heat_scratch);
        subtract_heating(velocity, heat);
        zero_constrained(Field::temperature, heat);
      }
    if (!discretization.has_field(Field::displacement))
      return;
    Vector &product = momentum_scratch;
    stiffness.add(-tau * tau, velocity, momentum, product);
    if (material.has_viscosity())
      viscous_stiffness.add(-tau * material.viscosity,
                            velocity,
                            momentum,
                            product);
    if (material.has_inertia())
      momentum_mass.add(-material.inertia, velocity, momentum, product);
    if (discretization.has_field(Field::temperature))
      add_thermal_stress(temperature_rate, tau * tau, momentum);
    zero_constrained(Field::displacement, momentum);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::subtract_heating(const Vector &velocity,
                                                    Vector       &heat) const
  {
    if (!material.has_heating())
      return;
    divergence.add(-material.heating, velocity, heat, heat_scratch);
    zero_constrained(Field::temperature, heat);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::add_thermal_stress(const Vector &temperature,
                                                      const double  factor,
                                                      Vector &momentum) const
  {
    if (!material.has_thermal_stress())
      return;
    thermal_stress.add(factor * material.thermal_stress,
                       temperature,
                       momentum,
                       momentum_scratch);
    zero_constrained(Field::displacement, momentum);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::zero_constrained(const Field::Block field,
                                                    Vector &vector) const
  {
    for (const unsigned int entry : discretization.constrained_entries(field))
      vector.begin()[entry] = 0.;
  }



  template class ThermoviscoelasticOperator<1>;
  template class ThermoviscoelasticOperator<2>;
  template class ThermoviscoelasticOperator<3>;
} // namespace ThermoContact
