// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/expression_function.h>
#include <thermocontact/space/h1_projection.h>
#include <thermocontact/space/lanes.h>
#include <thermocontact/space/linear_map.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <algorithm>
#include <array>

namespace ThermoContact
{
  namespace
  {
    /**
     * What basis functions are at the points of a rule along a cell of unit
     * length. The rule has points at both ends, so that it takes the boundary
     * terms of an integration by parts with the integral.
     */
    struct CellLine
    {
      explicit CellLine(const unsigned int degree)
        : nodes(QGaussLobatto<1>(degree + 1).get_points())
        // The data are no polynomials: more points than the products need.
        , rule(degree + 4)
        , values(rule.size(), nodes.size())
        , mass(nodes.size(), rule.size())
        , stiffness(nodes.size(), rule.size())
      {
        const auto basis = Polynomials::generate_complete_Lagrange_basis(nodes);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          for (unsigned int q = 0; q < rule.size(); ++q)
            {
              std::array<double, 3> derivatives;
              basis[i].value(rule.point(q)[0], 2, derivatives.data());
              values(q, i)    = derivatives[0];
              mass(i, q)      = rule.weight(q) * derivatives[0];
              stiffness(i, q) = -rule.weight(q) * derivatives[2];
              if (q == 0)
                stiffness(i, q) -= derivatives[1];
              if (q + 1 == rule.size())
                stiffness(i, q) += derivatives[1];
            }
      }

      const std::vector<Point<1>> nodes;
      const QGaussLobatto<1>      rule;
      FullMatrix<double>          values;    ///< $\phi_i(x_q)$ by q and i
      FullMatrix<double>          mass;      ///< $(\phi_i,f)$ from values of f
      FullMatrix<double>          stiffness; ///< $(\phi_i',f')$ from these
    };



    /** Multiplies all lines along each direction of an array by a matrix. */
    template <int dim>
    void
    multiply_lines(const std::array<const FullMatrix<double> *, dim> &matrices,
                   std::vector<double>                               &array,
                   std::vector<double>                               &scratch)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          const FullMatrix<double> &matrix = *matrices[d];
          const unsigned int        m = matrix.m(), n = matrix.n();
          const unsigned int        stride  = power_of(m, d);
          const unsigned int        n_lines = array.size() / n;
          scratch.resize(n_lines * m);
          for (unsigned int line = 0; line < n_lines; ++line)
            {
              const unsigned int block = line / stride, inner = line % stride;
              for (unsigned int i = 0; i < m; ++i)
                {
                  double sum = 0.;
                  for (unsigned int j = 0; j < n; ++j)
                    sum +=
                      matrix(i, j) * array[(block * n + j) * stride + inner];
                  scratch[(block * m + i) * stride + inner] = sum;
                }
            }
          array.swap(scratch);
        }
    }



    /**
     * Values of a component at the points of a tensor product in a cell.
     *
     * @param varies along a direction; else it is evaluated once there
     */
    template <int dim>
    void
    evaluate(const Function<dim>         &function,
             const unsigned int           component,
             const std::array<bool, dim> &varies,
             const Point<dim>            &lower,
             const Point<dim>            &upper,
             const std::vector<Point<1>> &points,
             std::vector<double>         &values)
    {
      values.resize(power_of(points.size(), dim));
      for (unsigned int q = 0; q < values.size(); ++q)
        {
          Point<dim>   place;
          unsigned int same = q; // the first point with this value
          for (unsigned int d = 0, rest = q, stride = 1; d < dim; ++d)
            {
              const unsigned int i    = rest % points.size();
              const double       part = points[i][0];
              place[d] = (1. - part) * lower[d] + part * upper[d];
              same -= varies[d] ? 0 : i * stride;
              rest /= points.size();
              stride *= points.size();
            }
          values[q] =
            same < q ? values[same] : function.value(place, component);
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
  void
  H1Projection<dim>::interpolate(const Function<dim> &function,
                                 SystemVector        &interpolant,
                                 SystemVector        &rhs) const
  {
    const FiniteElement<dim>       &fe = discretization.finite_element();
    const CellLine                  line(fe.degree);
    const std::vector<unsigned int> lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim>(fe.degree);
    Table<2, unsigned int> rows(fe.n_components(), lexicographic.size());
    for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
      {
        const auto [component, k]         = fe.system_to_component_index(i);
        rows(component, lexicographic[k]) = i;
      }
    const auto *const expressions =
      dynamic_cast<const ExpressionFunction<dim> *>(&function);
    std::vector<std::array<bool, dim>> varies(fe.n_components());
    for (unsigned int c = 0; c < fe.n_components(); ++c)
      for (unsigned int d = 0; d < dim; ++d)
        varies[c][d] = expressions == nullptr ||
                       expressions->components()[c].depends_on({"xyz"[d]});
    dealii::Vector<double>               cell_rhs(fe.dofs_per_cell);
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    std::vector<double>                  nodal, differences, part, scratch;
    std::array<const FullMatrix<double> *, dim> along;
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const Point<dim> &lower = cell->vertex(0);
          const Point<dim> &upper =
            cell->vertex(GeometryInfo<dim>::vertices_per_cell - 1);
          const Tensor<1, dim> size = upper - lower;
          cell->get_dof_indices(dofs);
          cell_rhs = 0.;
          for (unsigned int c = 0; c < fe.n_components(); ++c)
            {
              evaluate<dim>(
                function, c, varies[c], lower, upper, line.nodes, nodal);
              for (unsigned int i = 0; i < nodal.size(); ++i)
                {
                  const types::global_dof_index dof = dofs[rows(c, i)];
                  if (discretization.owned().is_element(dof))
                    interpolant(dof) = nodal[i];
                }
              if (expressions != nullptr &&
                  expressions->components()[c].is_constant())
                continue; // it is its interpolant, as most displacements
              evaluate<dim>(function,
                            c,
                            varies[c],
                            lower,
                            upper,
                            line.rule.get_points(),
                            differences);
              along.fill(&line.values);
              multiply_lines<dim>(along, nodal, scratch);
              for (unsigned int q = 0; q < differences.size(); ++q)
                differences[q] -= nodal[q];
              for (unsigned int e = 0; e < dim; ++e)
                {
                  part = differences;
                  along.fill(&line.mass);
                  along[e] = &line.stiffness;
                  multiply_lines<dim>(along, part, scratch);
                  double factor = 1. / (size[e] * size[e]);
                  for (unsigned int d = 0; d < dim; ++d)
                    factor *= size[d];
                  for (unsigned int i = 0; i < part.size(); ++i)
                    cell_rhs(rows(c, i)) += factor * part[i];
                }
            }
          constraints.distribute_local_to_global(cell_rhs, dofs, rhs);
        }
    interpolant.compress(VectorOperation::insert);
    rhs.compress(VectorOperation::add);
  }



  template <int dim>
  void
  H1Projection<dim>::project(const Function<dim> &function,
                             Vector              &temperature,
                             Vector              &displacement)
  {
    SystemVector projection = discretization.make_system_vector();
    SystemVector rhs        = discretization.make_system_vector();
    interpolate(function, projection, rhs);
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
