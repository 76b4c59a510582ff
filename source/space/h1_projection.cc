// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/cell_shape.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/h1_projection.h>
#include <thermocontact/space/linear_map.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_tools.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <array>

namespace ThermoContact
{
  namespace
  {
    /**
     * Basis functions at the points of a rule along a cell of unit length. The
     * rule has points at both ends, so that it takes the boundary terms of an
     * integration by parts with the integral.
     */
    struct CellLine
    {
      /** @param varies the integrand; else one point has all of it */
      CellLine(const unsigned int degree, const bool varies)
        // The data are no polynomials: more points than the products need.
        : rule(degree + 4)
        , nodes(QGaussLobatto<1>(degree + 1).get_points())
        , points(rule.get_points())
        , mass(degree + 1, varies ? rule.size() : 1)
        , stiffness(mass.m(), mass.n())
      {
        const auto basis = Polynomials::generate_complete_Lagrange_basis(nodes);
        if (!varies)
          nodes = points = {Point<1>()};
        values.reinit(points.size(), nodes.size());
        for (unsigned int i = 0; i < basis.size(); ++i)
          for (unsigned int q = 0; q < rule.size(); ++q)
            {
              const unsigned int    k = varies ? q : 0;
              std::array<double, 3> derivatives;
              basis[i].value(rule.point(q)[0], 2, derivatives.data());
              values(k, varies ? i : 0) = varies ? derivatives[0] : 1.;
              mass(i, k) += rule.weight(q) * derivatives[0];
              stiffness(i, k) -= rule.weight(q) * derivatives[2];
              if (q == 0)
                stiffness(i, k) -= derivatives[1];
              if (q + 1 == rule.size())
                stiffness(i, k) += derivatives[1];
            }
      }

      const QGaussLobatto<1> rule;
      std::vector<Point<1>>  nodes, points;
      FullMatrix<double>     values;    ///< $\phi_i(x_q)$ by q and i
      FullMatrix<double>     mass;      ///< $(\phi_i,f)$ from values of f
      FullMatrix<double>     stiffness; ///< $(\phi_i',f')$ from these
    };



    /** Along the directions of a cell. */
    template <int dim>
    using CellLines = std::array<const CellLine *, dim>;



    /** Multiplies all lines along each direction of an array by a matrix. */
    template <int dim>
    void
    multiply_lines(const std::array<const FullMatrix<double> *, dim> &matrices,
                   std::vector<double>                               &array,
                   std::vector<double>                               &scratch)
    {
      unsigned int stride = 1;
      for (const FullMatrix<double> *const matrix : matrices)
        {
          const unsigned int m = matrix->m(), n = matrix->n();
          const unsigned int n_lines = array.size() / n;
          scratch.resize(n_lines * m);
          for (unsigned int line = 0; line < n_lines; ++line)
            {
              const unsigned int block = line / stride, inner = line % stride;
              for (unsigned int i = 0; i < m; ++i)
                {
                  double sum = 0.;
                  for (unsigned int j = 0; j < n; ++j)
                    sum +=
                      (*matrix)(i, j) * array[(block * n + j) * stride + inner];
                  scratch[(block * m + i) * stride + inner] = sum;
                }
            }
          array.swap(scratch);
          stride *= m;
        }
    }



    /** Values of a component at the points of a tensor product in a cell. */
    template <int dim>
    void
    evaluate(const Function<dim>  &function,
             const unsigned int    component,
             const CellShape<dim> &shape,
             const CellLines<dim> &lines,
             std::vector<Point<1>> CellLine::*const points,
             std::vector<double>                   &values)
    {
      unsigned int n_values = 1;
      for (const CellLine *const line : lines)
        n_values *= (line->*points).size();
      values.resize(n_values);
      for (unsigned int q = 0; q < n_values; ++q)
        {
          Point<dim> unit_point;
          for (unsigned int d = 0, rest = q; d < dim; ++d)
            {
              const std::vector<Point<1>> &along = lines[d]->*points;
              unit_point[d] = along[rest % along.size()][0];
              rest /= along.size();
            }
          values[q] = function.value(shape.point(unit_point), component);
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
     * fixed but not everywhere, by conjugate gradients with the diagonal: once
     * a run.
     */
    void
    add_solution(const LinearMap                 &product,
                 Vector                           diagonal,
                 const std::vector<unsigned int> &fixed,
                 const Vector                    &rhs,
                 Vector                          &values)
    {
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
      Vector correction(values);
      conjugate_gradients("the projection of the initial values",
                          FixedProduct{product, fixed},
                          correction,
                          rhs,
                          DiagonalMatrix<Vector>(diagonal),
                          allowed / rhs.l2_norm());
      values += correction;
    }
  } // namespace



  template <int dim>
  H1Projection<dim>::H1Projection(const Scene               &scene,
                                  const Discretization<dim> &discretization,
                                  const CellProducts<dim, double> *known)
    : discretization(discretization)
    , constraints(discretization.clamped_constraints())
    , own_products(
        known == nullptr ? make_cell_products(scene, discretization) : nullptr)
    , products(known == nullptr ? own_products.get() : known)
  {
    for (const Field::Block field : all_fields)
      {
        const IndexSet &owned = discretization.owned_by_block()[field];
        for (const types::global_dof_index dof : owned)
          if (constraints.is_constrained(dof + discretization.first_dof(field)))
            kept_entries[field].push_back(owned.index_within_set(dof));
      }
  }



  template <int dim>
  H1Projection<dim>::~H1Projection() = default;



  template <int dim>
  Vector
  H1Projection<dim>::rest_of_interpolant(const EnclosedFunction<dim> &function,
                                         const Field::Block field) const
  {
    const unsigned int        first = discretization.first_component(field);
    const FiniteElement<dim> &fe    = discretization.finite_element();
    const CellLine            constant(fe.degree, false);
    const CellLine            varying(fe.degree, true);
    const std::vector<unsigned int> lexicographic =
      FETools::hierarchic_to_lexicographic_numbering<dim>(fe.degree);
    std::vector<unsigned int>            rows(lexicographic.size());
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    std::vector<double>                  nodal, differences, part, scratch;

    Vector rhs(discretization.owned_by_block()[field],
               discretization.relevant_by_block()[field],
               discretization.communicator());
    for (unsigned int c = first; c < first + n_components<dim>(field); ++c)
      {
        CellLines<dim> lines;
        for (unsigned int d = 0; d < dim; ++d)
          lines[d] = function.varies_along(d, c) ? &varying : &constant;
        if (std::count(lines.begin(), lines.end(), &varying) == 0)
          continue; // it is its interpolant, as most displacements
        for (unsigned int i = 0; i < rows.size(); ++i)
          rows[lexicographic[i]] = fe.component_to_system_index(c, i);
        for (const auto &cell :
             discretization.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned() && !discretization.is_gap(cell))
            {
              const CellShape<dim> shape(cell);
              const Tensor<1, dim> sides = shape.sides();
              evaluate<dim>(function, c, shape, lines, &CellLine::nodes, nodal);
              evaluate<dim>(
                function, c, shape, lines, &CellLine::points, differences);
              std::array<const FullMatrix<double> *, dim> along;
              for (unsigned int d = 0; d < dim; ++d)
                along[d] = &lines[d]->values;
              multiply_lines<dim>(along, nodal, scratch);
              for (unsigned int q = 0; q < differences.size(); ++q)
                differences[q] -= nodal[q];
              cell->get_dof_indices(dofs);
              for (unsigned int e = 0; e < dim; ++e)
                if (lines[e] == &varying)
                  {
                    part          = differences;
                    double factor = 1.;
                    for (unsigned int d = 0; d < dim; ++d)
                      {
                        along[d] =
                          d == e ? &varying.stiffness : &lines[d]->mass;
                        factor *= d == e ? 1. / sides[d] : sides[d];
                      }
                    multiply_lines<dim>(along, part, scratch);
                    for (unsigned int i = 0; i < part.size(); ++i)
                      rhs(dofs[rows[i]] - discretization.first_dof(field)) +=
                        factor * part[i];
                  }
            }
      }
    rhs.compress(VectorOperation::add);
    for (const unsigned int entry : kept_entries[field])
      rhs.local_element(entry) = 0.;
    return rhs;
  }



  template <>
  Vector
  H1Projection<1>::rest_of_interpolant(const EnclosedFunction<1> &function,
                                       const Field::Block         field) const
  {
    const unsigned int      component = discretization.first_component(field);
    const FiniteElement<1> &fe        = discretization.finite_element();
    const PiecewiseRule<1>  rule(function,
                                {{Point<1>(),
                                   discretization.geometry().corner()}},
                                fe.degree + 4);
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    Vector rhs = discretization.make_vector(field);
    if (fe.degree == 1 || !function.varies_along(0, component))
      return rhs;
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      {
        if (discretization.is_gap(cell))
          continue;
        const CellShape<1>  shape(cell);
        const Quadrature<1> points = rule(shape.bounding_box(), component);
        std::vector<double> nodal;
        for (const Point<1> &node :
             fe.base_element(0).get_unit_support_points())
          nodal.push_back(function.value(shape.point(node), component));
        cell->get_dof_indices(dofs);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            const Point<1> unit = shape.unit_point(points.point(q));
            double         rest = function.value(points.point(q), component);
            for (unsigned int i = 0; i < nodal.size(); ++i)
              rest -= nodal[i] * fe.base_element(0).shape_value(i, unit);
            for (unsigned int i = 0; i < nodal.size(); ++i)
              rhs(dofs[fe.component_to_system_index(component, i)] -
                  discretization.first_dof(field)) -=
                rest * points.weight(q) *
                fe.base_element(0).shape_grad_grad(i, unit)[0][0] /
                (shape.sides()[0] * shape.sides()[0]);
          }
      }
    return rhs;
  }



  template <int dim>
  void
  H1Projection<dim>::add_in_cells(const Field::Block field,
                                  const Vector      &rhs,
                                  Vector            &values) const
  {
    const FiniteElement<dim> &fe    = discretization.finite_element();
    const unsigned int        first = 2, n = fe.degree - 1; // inner nodes
    const QGauss<dim>         rule(fe.degree);
    FullMatrix<double>        inverse(n, n); // of a cell of unit length
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int q = 0; q < rule.size(); ++q)
          inverse(i, j) +=
            rule.weight(q) *
            (fe.base_element(0).shape_grad(first + i, rule.point(q)) *
             fe.base_element(0).shape_grad(first + j, rule.point(q)));
    inverse.gauss_jordan();
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        const auto dof = [&](const unsigned int i) {
          return dofs[fe.component_to_system_index(
                   discretization.first_component(field), first + i)] -
                 discretization.first_dof(field);
        };
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            values(dof(i)) += cell->measure() * inverse(i, j) * rhs(dof(j));
      }
  }



  template <int dim>
  void
  H1Projection<dim>::project(const EnclosedFunction<dim> &function,
                             Vector                      &temperature,
                             Vector                      &displacement) const
  {
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        {
          Vector &values =
            field == Field::temperature ? temperature : displacement;
          const unsigned int first = discretization.first_component(field);
          const auto        &nodal_values = discretization.nodal_values(field);
          for (unsigned int i = 0; i < nodal_values.size(); ++i)
            values.local_element(i) =
              function.value(nodal_values[i].node,
                             first + nodal_values[i].component);
          if (dim == 1 && discretization.degree() == 1)
            continue; // vertices alone
          const Vector rhs = rest_of_interpolant(function, field);
          if (rhs.linfty_norm() == 0.)
            continue;
          if constexpr (dim == 1)
            add_in_cells(field, rhs, values);
          else
            add_solution({[&](Vector &y, const Vector &x) {
                           products->laplacian(field, y, x);
                         }},
                         products->laplacian_diagonal(field),
                         kept_entries[field],
                         rhs,
                         values);
        }
  }



  template class H1Projection<1>;
  template class H1Projection<2>;
  template class H1Projection<3>;
} // namespace ThermoContact
