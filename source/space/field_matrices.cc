// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/field_matrices.h>
#include <thermocontact/space/lateral_exchange.h>
#include <thermocontact/space/massless_contact.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/block_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

namespace ThermoContact
{
  namespace
  {
    /** Field matrices know nothing of the fixed end. */
    AffineConstraints<double>
    no_constraints()
    {
      AffineConstraints<double> constraints;
      constraints.close();
      return constraints;
    }



    /** What the products need of a basis function at a point. */
    template <int dim>
    struct CellBasis
    {
      double         theta = 0.;
      Tensor<1, dim> grad_theta;
      Strain         strain;
    };



    /** All basis functions of a cell; those of absent fields do not exist. */
    template <int dim>
    void
    evaluate_basis(const Discretization<dim>   &discretization,
                   const FEValues<dim>         &fe_values,
                   const unsigned int           q,
                   std::vector<CellBasis<dim>> &basis)
    {
      if (discretization.has_field(Field::temperature))
        {
          const auto &theta = fe_values[discretization.temperature_extractor()];
          for (const unsigned int i : fe_values.dof_indices())
            {
              basis[i].theta      = theta.value(i, q);
              basis[i].grad_theta = theta.gradient(i, q);
            }
        }
      if (discretization.has_field(Field::displacement))
        {
          const auto &u = fe_values[discretization.displacement_extractor()];
          for (const unsigned int i : fe_values.dof_indices())
            basis[i].strain =
              discretization.geometry().strain(u.gradient(i, q),
                                               u.value(i, q),
                                               fe_values.quadrature_point(q));
        }
    }



    /**
     * True if the integrals over this cell are those over the one before: in a
     * body, whose products are many, not in a rod, which joins equal cells.
     */
    template <int dim>
    bool
    has_last_integrals(const Discretization<dim> &discretization,
                       const FEValues<dim>       &fe_values)
    {
      return dim > 1 && discretization.geometry().has_uniform_weight() &&
             fe_values.get_cell_similarity() ==
               dealii::CellSimilarity::translation;
    }



    /** Integrals of products of the basis functions of a cell. */
    template <int dim>
    void
    integrate_products(const Material              &material,
                       const Discretization<dim>   &discretization,
                       const FEValues<dim>         &fe_values,
                       std::vector<CellBasis<dim>> &basis,
                       FullMatrix<double>          &stiffness,
                       FullMatrix<double>          &coupling)
    {
      stiffness = 0.;
      coupling  = 0.;
      for (const unsigned int q : fe_values.quadrature_point_indices())
        {
          evaluate_basis(discretization, fe_values, q, basis);
          const double weight = discretization.geometry().weight(fe_values, q);
          for (unsigned int i = 0; i < basis.size(); ++i)
            for (unsigned int j = 0; j < basis.size(); ++j)
              {
                const CellBasis<dim> &f = basis[i], &g = basis[j];
                stiffness(i, j) +=
                  (f.grad_theta * g.grad_theta +
                   elastic_product(material, f.strain, g.strain)) *
                  weight;
                coupling(i, j) +=
                  (f.theta * g.strain.trace + f.strain.trace * g.theta) *
                  weight;
              }
        }
    }
  } // namespace



  template <int dim>
  FieldMatrices<dim>::FieldMatrices(const SpatialScene        &scene,
                                    const Discretization<dim> &discretization)
    : scene(scene)
    , discretization(discretization)
  {
    setup_matrix(false, mass);
    setup_matrix(false, stiffness);
    if (scene.material.has_thermal_stress())
      setup_matrix(true, coupling);
    if (scene.has_elastic_contact_nodes)
      setup_matrix(false, viscous_stiffness);
    if (scene.lateral_exchange > 0.)
      setup_matrix(false, lateral_exchange);
    start_rod();
    assemble_mass();
    assemble_stiffness();
    if (scene.fields.has_temperature)
      {
        assemble_contact_end();
        assemble_lateral_exchange();
      }
    if (rod_cells)
      rod = rod_cells->make();
    rod_cells.reset();
  }



  template <int dim>
  void
  FieldMatrices<dim>::start_rod()
  {
    if constexpr (dim == 1)
      {
        if (Utilities::MPI::n_mpi_processes(discretization.communicator()) > 1)
          return;
        rod_cells = std::make_unique<RodCells>(discretization);
        if (!rod_cells->is_in_order())
          rod_cells.reset();
      }
  }



  template <int dim>
  void
  FieldMatrices<dim>::setup_matrix(const bool         couples_fields,
                                   BlockSparseMatrix &matrix) const
  {
    const unsigned int                   n = discretization.n_components();
    dealii::Table<2, DoFTools::Coupling> couplings(n, n);
    const bool has_temperature = discretization.has_field(Field::temperature);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          const bool is_same_field = !has_temperature || (i == 0) == (j == 0);
          couplings(i, j) =
            is_same_field != couples_fields ? DoFTools::always : DoFTools::none;
        }
    std::vector<IndexSet> owned, relevant;
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        {
          owned.push_back(discretization.owned_by_block()[field]);
          relevant.push_back(discretization.relevant_by_block()[field]);
        }
    TrilinosWrappers::BlockSparsityPattern pattern(
      owned, owned, relevant, discretization.communicator());
    DoFTools::make_sparsity_pattern(discretization.dof_handler(),
                                    couplings,
                                    pattern,
                                    AffineConstraints<double>(),
                                    true,
                                    Utilities::MPI::this_mpi_process(
                                      discretization.communicator()));
    pattern.compress();
    matrix.reinit(pattern);
  }



  template <int dim>
  void
  FieldMatrices<dim>::assemble_mass()
  {
    const FiniteElement<dim> &fe        = discretization.finite_element();
    const bool                is_lumped = scene.has_lumped_mass;
    const UpdateFlags         flags =
      update_values | update_quadrature_points | update_JxW_values;
    FEValues<dim>                   fe_values(discretization.mapping(),
                            fe,
                            mass_quadrature<dim>(fe.degree, is_lumped),
                            flags);
    FEValues<dim>                   axial_values(discretization.mapping(),
                               fe,
                               scene.has_midpoint_mass ?
                                                   midpoint_quadrature<dim>() :
                                                   massless_quadrature<dim>(fe.degree, is_lumped),
                               flags);
    const AffineConstraints<double> unconstrained = no_constraints();

    const unsigned int                   n = fe.dofs_per_cell;
    FullMatrix<double>                   cell_mass(n, n);
    std::vector<types::global_dof_index> dofs(n);
    const unsigned int                   axial =
      scene.fields.has_displacement ?
                          discretization.first_component(Field::displacement) :
                          numbers::invalid_unsigned_int;

    const auto integrate = [&](const FEValues<dim> &values,
                               const auto          &is_wanted) {
      for (const unsigned int i : values.dof_indices())
        for (const unsigned int j : values.dof_indices())
          {
            const unsigned int c = fe.system_to_component_index(i).first;
            if (c == fe.system_to_component_index(j).first && is_wanted(c))
              for (const unsigned int q : values.quadrature_point_indices())
                cell_mass(i, j) += values.shape_value(i, q) *
                                   values.shape_value(j, q) *
                                   discretization.geometry().weight(values, q);
          }
    };
    bool had_axial_rule = false;
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const bool has_axial_rule =
            scene.has_midpoint_mass ||
            (scene.has_massless_nodes && touches_contact_end<dim>(cell));
          fe_values.reinit(cell);
          if (!has_last_integrals(discretization, fe_values) ||
              has_axial_rule != had_axial_rule)
            {
              cell_mass = 0.;
              integrate(fe_values, [&](const unsigned int c) {
                return !(has_axial_rule && c == axial);
              });
              if (has_axial_rule)
                {
                  axial_values.reinit(cell);
                  integrate(axial_values,
                            [&](const unsigned int c) { return c == axial; });
                }
            }
          had_axial_rule = has_axial_rule;
          cell->get_dof_indices(dofs);
          unconstrained.distribute_local_to_global(cell_mass, dofs, mass);
          if (rod_cells)
            rod_cells->add_diagonal(RodMatrices::heat_mass,
                                    RodMatrices::momentum_mass,
                                    cell->active_cell_index(),
                                    cell_mass);
        }
    mass.compress(VectorOperation::add);
  }



  template <int dim>
  void
  FieldMatrices<dim>::assemble_stiffness()
  {
    const FiniteElement<dim>       &fe = discretization.finite_element();
    FEValues<dim>                   fe_values(discretization.mapping(),
                            fe,
                            QGauss<dim>(fe.degree + 1),
                            update_values | update_gradients |
                              update_quadrature_points | update_JxW_values);
    const AffineConstraints<double> unconstrained = no_constraints();

    const unsigned int                   n = fe.dofs_per_cell;
    FullMatrix<double>                   cell_stiffness(n, n);
    FullMatrix<double>                   cell_coupling(n, n);
    std::vector<types::global_dof_index> dofs(n);
    std::vector<CellBasis<dim>>          basis(n);
    const bool               has_coupling = scene.material.has_thermal_stress();
    const bool               has_viscous  = scene.has_elastic_contact_nodes;
    const FullMatrix<double> extension =
      has_viscous ? extension_to_contact_nodes(discretization) :
                    FullMatrix<double>();

    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          if (!has_last_integrals(discretization, fe_values))
            integrate_products(scene.material,
                               discretization,
                               fe_values,
                               basis,
                               cell_stiffness,
                               cell_coupling);
          cell->get_dof_indices(dofs);
          unconstrained.distribute_local_to_global(cell_stiffness,
                                                   dofs,
                                                   stiffness);
          if (has_coupling)
            unconstrained.distribute_local_to_global(cell_coupling,
                                                     dofs,
                                                     coupling);
          if (rod_cells)
            {
              const unsigned int index = cell->active_cell_index();
              rod_cells->add_diagonal(RodMatrices::conduction,
                                      RodMatrices::stiffness,
                                      index,
                                      cell_stiffness);
              if (has_coupling)
                {
                  rod_cells->add(RodMatrices::divergence,
                                 index,
                                 Field::temperature,
                                 Field::displacement,
                                 cell_coupling);
                  rod_cells->add(RodMatrices::thermal_stress,
                                 index,
                                 Field::displacement,
                                 Field::temperature,
                                 cell_coupling);
                }
            }
          if (!has_viscous && !rod_cells)
            continue;
          FullMatrix<double> cell_viscous(cell_stiffness);
          if (has_viscous && touches_contact_end<dim>(cell))
            {
              cell_viscous = 0.;
              cell_viscous.triple_product(cell_stiffness,
                                          extension,
                                          extension,
                                          true);
            }
          if (has_viscous)
            unconstrained.distribute_local_to_global(cell_viscous,
                                                     dofs,
                                                     viscous_stiffness);
          if (rod_cells && scene.fields.has_displacement)
            rod_cells->add(RodMatrices::viscous_stiffness,
                           cell->active_cell_index(),
                           Field::displacement,
                           Field::displacement,
                           cell_viscous);
        }
    stiffness.compress(VectorOperation::add);
    if (has_coupling)
      coupling.compress(VectorOperation::add);
    if (has_viscous)
      viscous_stiffness.compress(VectorOperation::add);
  }



  template <int dim>
  void
  FieldMatrices<dim>::assemble_contact_end()
  {
    const FiniteElement<dim>       &fe = discretization.finite_element();
    FEFaceValues<dim>               face_values(discretization.mapping(),
                                  fe,
                                  QGauss<dim - 1>(fe.degree + 1),
                                  update_values | update_quadrature_points |
                                    update_JxW_values);
    const AffineConstraints<double> unconstrained = no_constraints();

    FullMatrix<double> cell_matrix(fe.dofs_per_cell, fe.dofs_per_cell);
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    const auto &theta = face_values[discretization.temperature_extractor()];
    for_each_contact_face<dim>(
      discretization.dof_handler(),
      [&](const auto &cell, const unsigned int f) {
        face_values.reinit(cell, f);
        cell_matrix = 0.;
        for (const unsigned int q : face_values.quadrature_point_indices())
          for (const unsigned int i : face_values.dof_indices())
            for (const unsigned int j : face_values.dof_indices())
              cell_matrix(i, j) +=
                scene.exchange_coefficient * theta.value(i, q) *
                theta.value(j, q) *
                discretization.geometry().weight(face_values, q);
        cell->get_dof_indices(dofs);
        unconstrained.distribute_local_to_global(cell_matrix, dofs, stiffness);
        if (rod_cells)
          rod_cells->add_exchange(cell->active_cell_index(), cell_matrix);
      });
    stiffness.compress(VectorOperation::add);
  }



  template <int dim>
  void
  FieldMatrices<dim>::assemble_lateral_exchange()
  {
    if (!(scene.lateral_exchange > 0.))
      return;
    const LateralExchange<dim> exchange(scene, discretization);
    AffineConstraints<double>  unconstrained;
    unconstrained.close();

    const unsigned int n = discretization.finite_element().dofs_per_cell;
    FullMatrix<double> cell_matrix(n, n);
    std::vector<types::global_dof_index> dofs(n);
    exchange.for_each_place(
      [&](const auto &cell, const FEValuesBase<dim> &values) {
        exchange.integrate(values, cell_matrix);
        cell->get_dof_indices(dofs);
        unconstrained.distribute_local_to_global(cell_matrix, dofs, stiffness);
        unconstrained.distribute_local_to_global(cell_matrix,
                                                 dofs,
                                                 lateral_exchange);
        if (rod_cells)
          rod_cells->add_exchange(cell->active_cell_index(), cell_matrix);
      });
    stiffness.compress(VectorOperation::add);
    lateral_exchange.compress(VectorOperation::add);
  }



  template void
  FieldMatrices<1>::assemble_lateral_exchange();
  template void
  FieldMatrices<2>::assemble_lateral_exchange();
  template void
  FieldMatrices<3>::assemble_lateral_exchange();



  template class FieldMatrices<1>;
  template class FieldMatrices<2>;
  template class FieldMatrices<3>;
} // namespace ThermoContact
