// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/h1_projection.h>
#include <thermocontact/space/linear_map.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_cartesian.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /**
     * Adds $(w-w_h,\text{test})$ over a cell or a face.
     *
     * @param fe of all components
     * @param values of the element of one component, of which all are
     */
    template <int dim, typename Test>
    void
    add_difference(const Function<dim>                        &function,
                   const SystemVector                         &interpolant,
                   const FiniteElement<dim>                   &fe,
                   const std::vector<types::global_dof_index> &dofs,
                   const FEValuesBase<dim>                    &values,
                   const Test                                 &test,
                   dealii::Vector<double>                     &cell_rhs)
    {
      std::vector<double> differences(values.n_quadrature_points);
      std::vector<types::global_dof_index> own(values.dofs_per_cell);
      std::vector<unsigned int>            rows(values.dofs_per_cell);
      for (unsigned int c = 0; c < fe.n_components(); ++c)
        {
          for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
            if (const auto [component, k] = fe.system_to_component_index(i);
                component == c)
              {
                rows[k] = i;
                own[k]  = dofs[i];
              }
          values.get_function_values(interpolant,
                                     dealii::make_array_view(own),
                                     differences);
          for (const unsigned int q : values.quadrature_point_indices())
            differences[q] =
              values.JxW(q) *
              (function.value(values.quadrature_point(q), c) - differences[q]);
          for (const unsigned int i : values.dof_indices())
            for (const unsigned int q : values.quadrature_point_indices())
              cell_rhs(rows[i]) += differences[q] * test(i, q);
        }
    }



    /** A product with rows and columns of the identity for fixed entries. */
    struct FixedProduct
    {
      const LinearMap                 &product;
      const std::vector<unsigned int> &fixed;

      void
      vmult(Vector &y, const Vector &x) const
      {
        product.vmult(y, x);
        for (const unsigned int entry : fixed)
          y.local_element(entry) = x.local_element(entry);
      }
    };



    /**
     * Adds to @p values the solution for @p rhs, which is zero where entries are
     * fixed, by conjugate gradients with the diagonal: once a run.
     */
    void
    add_solution(const LinearMap                 &product,
                 Vector                           diagonal,
                 const std::vector<unsigned int> &fixed,
                 const Vector                    &rhs,
                 Vector                          &values)
    {
      if (rhs.linfty_norm() == 0.)
        return;
      // interpolation may be exact but for rounding
      Vector terms(diagonal);
      terms.scale(values);
      const double allowed =
        std::max(Tolerances::projection_residual * rhs.l2_norm(),
                 Tolerances::rounding * terms.l2_norm());
      for (double &value : diagonal)
        value = 1. / value;
      for (const unsigned int entry : fixed)
        diagonal.local_element(entry) = 1.;
      Vector correction(rhs);
      conjugate_gradients("the projection of the initial values",
                          FixedProduct{product, fixed},
                          correction,
                          rhs,
                          diagonal,
                          allowed / rhs.l2_norm(),
                          20000);
      values += correction;
    }
  } // namespace



  template <int dim>
  H1Projection<dim>::H1Projection(const Discretization<dim> &discretization,
                                  const CellProducts<dim, double> *products)
    : discretization(discretization)
    , constraints(discretization.clamped_constraints())
    , products(products)
  {
    if (products == nullptr)
      assemble_laplace_matrix();
  }



  template <int dim>
  SparseMatrix
  H1Projection<dim>::make_matrix() const
  {
    const unsigned int n_components = discretization.n_components();
    dealii::Table<2, DoFTools::Coupling> coupling(n_components, n_components);
    coupling.fill(DoFTools::none);
    for (unsigned int c = 0; c < n_components; ++c)
      coupling(c, c) = DoFTools::always;
    TrilinosWrappers::SparsityPattern pattern(discretization.owned(),
                                              discretization.owned(),
                                              discretization.relevant(),
                                              discretization.communicator());
    DoFTools::make_sparsity_pattern(discretization.dof_handler(),
                                    coupling,
                                    pattern,
                                    constraints,
                                    false,
                                    Utilities::MPI::this_mpi_process(
                                      discretization.communicator()));
    pattern.compress();
    SparseMatrix matrix;
    matrix.reinit(pattern);
    return matrix;
  }



  template <int dim>
  void
  H1Projection<dim>::assemble_laplace_matrix()
  {
    const FiniteElement<dim> &fe     = discretization.finite_element();
    SparseMatrix              matrix = make_matrix();

    FEValues<dim>      fe_values(discretization.mapping(),
                            fe,
                            QGauss<dim>(fe.degree + 1),
                            update_gradients | update_JxW_values);
    FullMatrix<double> cell_matrix(fe.dofs_per_cell, fe.dofs_per_cell);
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          cell_matrix = 0.;
          for (const unsigned int i : fe_values.dof_indices())
            for (const unsigned int j : fe_values.dof_indices())
              if (fe.system_to_component_index(i).first ==
                  fe.system_to_component_index(j).first)
                for (const unsigned int q :
                     fe_values.quadrature_point_indices())
                  cell_matrix(i, j) += fe_values.shape_grad(i, q) *
                                       fe_values.shape_grad(j, q) *
                                       fe_values.JxW(q);
          cell->get_dof_indices(dofs);
          constraints.distribute_local_to_global(cell_matrix, dofs, matrix);
        }
    matrix.compress(VectorOperation::add);
    laplace_solver = std::make_unique<DirectSolver>(std::move(matrix));
  }



  template <int dim>
  SystemVector
  H1Projection<dim>::correction_rhs(const Function<dim> &function,
                                    const SystemVector  &interpolant) const
  {
    const FiniteElement<dim> &fe = discretization.finite_element();
    // The data are no polynomials: more points than the products need.
    const unsigned int n_points = fe.degree + 3;
    // all cells are boxes, of which bodies have many
    const MappingCartesian<dim> boxes;
    const Mapping<dim> &mapping = dim == 1 ? discretization.mapping() : boxes;
    // tables of all components would be larger than the body
    const FiniteElement<dim> &of_component = fe.base_element(0);
    FEValues<dim>             fe_values(mapping,
                            of_component,
                            QGauss<dim>(n_points),
                            update_values | update_hessians |
                              update_quadrature_points | update_JxW_values);
    FEFaceValues<dim>         face_values(mapping,
                                  of_component,
                                  QGauss<dim - 1>(n_points),
                                  update_values | update_gradients |
                                    update_normal_vectors |
                                    update_quadrature_points |
                                    update_JxW_values);

    SystemVector ghosted(discretization.owned(),
                         discretization.relevant(),
                         discretization.communicator());
    ghosted          = interpolant;
    SystemVector rhs = discretization.make_system_vector();

    dealii::Vector<double>               cell_rhs(fe.dofs_per_cell);
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const typename dealii::Triangulation<dim>::cell_iterator place = cell;
          cell->get_dof_indices(dofs);
          cell_rhs = 0.;
          fe_values.reinit(place);
          add_difference(
            function,
            ghosted,
            fe,
            dofs,
            fe_values,
            [&](const unsigned int i, const unsigned int q) {
              return -trace(fe_values.shape_hessian(i, q));
            },
            cell_rhs);
          for (const unsigned int f : cell->face_indices())
            {
              face_values.reinit(place, f);
              add_difference(
                function,
                ghosted,
                fe,
                dofs,
                face_values,
                [&](const unsigned int i, const unsigned int q) {
                  return face_values.shape_grad(i, q) *
                         face_values.normal_vector(q);
                },
                cell_rhs);
            }
          constraints.distribute_local_to_global(cell_rhs, dofs, rhs);
        }
    rhs.compress(VectorOperation::add);
    return rhs;
  }



  template <int dim>
  void
  H1Projection<dim>::project(const Function<dim> &function,
                             Vector              &temperature,
                             Vector              &displacement)
  {
    SystemVector projection = discretization.make_system_vector();
    VectorTools::interpolate(discretization.mapping(),
                             discretization.dof_handler(),
                             function,
                             projection);
    const SystemVector rhs = correction_rhs(function, projection);
    if (products != nullptr)
      {
        discretization.split(projection, temperature, displacement);
        if constexpr (dim > 1)
          add_iteratively(rhs, temperature, displacement);
        return;
      }
    SystemVector correction(rhs);
    laplace_solver->solve(correction, rhs);
    projection += correction;
    discretization.split(projection, temperature, displacement);
  }



  template <int dim>
  std::vector<unsigned int>
  H1Projection<dim>::kept_entries(const Field::Block field) const
  {
    std::vector<unsigned int> entries;
    const IndexSet           &owned = discretization.owned_by_block()[field];
    for (const types::global_dof_index dof : owned)
      if (constraints.is_constrained(dof + discretization.first_dof(field)))
        entries.push_back(owned.index_within_set(dof));
    return entries;
  }



  template <int dim>
  void
  H1Projection<dim>::add_iteratively(const SystemVector &rhs,
                                     Vector             &temperature,
                                     Vector             &displacement) const
  {
    if constexpr (dim > 1)
      {
        Vector heat     = discretization.make_vector(Field::temperature);
        Vector momentum = discretization.make_vector(Field::displacement);
        discretization.split(rhs, heat, momentum);
        for (const Field::Block field : all_fields)
          if (discretization.has_field(field))
            {
              const bool is_heat = field == Field::temperature;
              add_solution({[&](Vector &y, const Vector &x) {
                             products->laplacian(field, y, x);
                           }},
                           products->laplacian_diagonal(field),
                           kept_entries(field),
                           is_heat ? heat : momentum,
                           is_heat ? temperature : displacement);
            }
      }
  }



  template class H1Projection<1>;
  template class H1Projection<2>;
  template class H1Projection<3>;
} // namespace ThermoContact
