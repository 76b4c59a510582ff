// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Products and factors of the matrices of a rod, no mesh.
//
// Rods of 1 to 9 cells and degrees 1 to 8, whose matrices are sums of random
// cell matrices A^T A + I/2, of two kinds in turn by groups of cells, or one
// for each cell; D is such a matrix with the half below its diagonal times
// -1/2, and the thermal stress its transpose. Stiffnesses are A^T A and D, with
// the first columns of A and D such that rows add up to 0; conduction has the
// heat exchange besides, and 1/2 of that at the end of the last cell, if it is
// a run of its own.
//
// 1. Products, combinations and forms, against sums over full matrices: to
//    rounding, 1e-12 of the sum of the absolute values of their terms. Of cells
//    of degree 2 and more the products of stiffnesses and D with a constant,
//    and the forms of stiffnesses, are 0, not rounding: all differences are.
// 2. Systems of one and of two fields as those of a stage, [M + t K, a D;
//    -t^2 a D^T, M_u + t z S_z + t^2 S], against the solution that was chosen:
//    residual in the full matrix to 1e-12 of its terms, and solutions vanish
//    at node 0. One field of degree 1 is symmetric and definite without inner
//    nodes: elimination takes less from a pivot than it has, so that nothing
//    grows, 1.
// 3. Blocks that grow, two cells of degree 1. By hand: cells [e - 1, 1; 1, 1]
// make
//    rows [e 1; 1 1] of the two vertices, e = 1e-8: the first pivot takes 1/e =
//    1e8 times the second from it. A pivot of 0 has infinite growth, also the
//    only one of one cell, and so has a cell of degree 2 whose inner node has
//    the diagonal 0.
// 4. 5 cells are one run if their entries are the same, or differ by rounding
//    and 1e-14 is allowed; 5 if nothing is allowed, or if the entries grow by
//    1.1 from cell to cell.
// 5. Conduction of 1e5 times a stiffness and a heat exchange of 2^-7 in all
//    pairs of nodes and of 1 at the last one: the product with the constant 0.7
//    is the exchange alone to 1e-15, and so is the form, of 4 cells of degree 3
//    0.49 (1 + 64/2^7). Where entries were added up it would be 1e-11.

#include <thermocontact/rod/rod_factors.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "../tests.h"

using namespace ThermoContact;
using dealii::FullMatrix;

namespace
{
  using Vector = std::vector<double>;

  constexpr unsigned int n_matrices = RodMatrices::n_matrices;

  std::mt19937 generator(20);

  double
  random()
  {
    return std::uniform_real_distribution<double>(-1., 1.)(generator);
  }



  Vector
  random_vector(const unsigned int n)
  {
    Vector v(n);
    for (double &x : v)
      x = random();
    return v;
  }



  using Matrices = std::vector<FullMatrix<double>>;

  /** The matrices of a rod, and those of its cells. */
  struct Rod
  {
    Matrices              full;
    std::vector<Matrices> cells;
  };



  /** Whether the product of a matrix with a constant is 0. */
  bool
  has_rows_of_zero_sum(const unsigned int matrix)
  {
    return matrix == RodMatrices::conduction ||
           matrix == RodMatrices::divergence ||
           matrix == RodMatrices::stiffness ||
           matrix == RodMatrices::viscous_stiffness;
  }



  void
  make_rows_of_zero_sum(FullMatrix<double> &a)
  {
    for (unsigned int i = 0; i < a.m(); ++i)
      {
        a(i, 0) = 0.;
        for (unsigned int j = 1; j < a.n(); ++j)
          a(i, 0) -= a(i, j);
      }
  }



  /** A random matrix of a cell, symmetric but for D. */
  FullMatrix<double>
  random_cell(const unsigned int n, const unsigned int matrix)
  {
    FullMatrix<double> a(n, n), result(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        a(i, j) = random();
    if (has_rows_of_zero_sum(matrix))
      make_rows_of_zero_sum(a);
    a.Tmmult(result, a);
    for (unsigned int i = 0; i < n; ++i)
      {
        if (!has_rows_of_zero_sum(matrix))
          result(i, i) += 0.5;
        for (unsigned int j = 0; matrix == RodMatrices::divergence && j < i;
             ++j)
          result(i, j) *= -0.5;
      }
    if (matrix == RodMatrices::divergence)
      make_rows_of_zero_sum(result);
    return result;
  }



  /** Cells i with the same i / group are alike. */
  Rod
  random_rod(const RodLayout &layout, const unsigned int group)
  {
    const unsigned int n = layout.nodes_per_cell();
    Rod                rod;
    rod.full.assign(n_matrices,
                    FullMatrix<double>(layout.n_nodes(), layout.n_nodes()));
    Matrices cell(n_matrices, FullMatrix<double>(n, n));
    for (unsigned int c = 0; c < layout.n_cells; ++c)
      {
        if (c % group == 0)
          {
            for (unsigned int m = 0; m < n_matrices; ++m)
              cell[m] = random_cell(n, m);
            cell[RodMatrices::conduction].add(1.,
                                              cell[RodMatrices::heat_exchange]);
          }
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            cell[RodMatrices::thermal_stress](j, i) =
              cell[RodMatrices::divergence](i, j);
        if (c + 1 == layout.n_cells && c % group == 0)
          {
            cell[RodMatrices::conduction](1, 1) += 0.5;
            cell[RodMatrices::heat_exchange](1, 1) += 0.5;
          }
        rod.cells.push_back(cell);
        for (unsigned int m = 0; m < n_matrices; ++m)
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              rod.full[m](layout.node(c, i), layout.node(c, j)) +=
                cell[m](i, j);
      }
    return rod;
  }



  RodMatrices
  make(const RodLayout &layout, const Rod &rod)
  {
    return RodMatrices(layout,
                       0.,
                       [&](const RodMatrices::Matrix m,
                           const unsigned int        cell,
                           const unsigned int        i,
                           const unsigned int        j) {
                         return rod.cells[cell][m](i, j);
                       });
  }



  /** Row @p i of @p matrix times @p x, and the sum of absolute values. */
  void
  add_row(const FullMatrix<double> &matrix,
          const double              factor,
          const unsigned int        i,
          const Vector             &x,
          double                   &sum,
          double                   &size)
  {
    for (unsigned int j = 0; j < x.size(); ++j)
      {
        sum += factor * matrix(i, j) * x[j];
        size += std::abs(factor * matrix(i, j) * x[j]);
      }
  }



  /** Largest error of products and forms in units of 1e-12 of their terms. */
  double
  error_of_products(const RodMatrices                     &rod,
                    const std::vector<FullMatrix<double>> &full)
  {
    const unsigned int n     = rod.layout().n_nodes();
    double             error = 0.;
    const Vector       x = random_vector(n), y = random_vector(n),
                 z = random_vector(n), base = random_vector(n);
    Vector     one(n), more(n), two(n), three(n);
    const auto term =
      [](const double factor, const unsigned int m, const Vector &v) {
        return RodMatrices::Term{factor,
                                 static_cast<RodMatrices::Matrix>(m),
                                 v.data()};
      };
    for (unsigned int m = 0; m < n_matrices; ++m)
      {
        const unsigned int next = (m + 1) % n_matrices;
        rod.combine<1>({{term(-0.3, m, x)}}, 0., nullptr, one.data());
        rod.combine<1>({{term(-0.3, m, x)}}, 1.5, base.data(), more.data());
        rod.combine<2>({{term(-0.3, m, x), term(0.7, next, y)}},
                       1.5,
                       base.data(),
                       two.data());
        rod.combine<3>({{term(-0.3, m, x), term(0.7, next, y), term(2., m, z)}},
                       1.5,
                       base.data(),
                       three.data());
        double form = 0., form_size = 0., difference = 0., difference_size = 0.;
        Vector x_y(x);
        for (unsigned int i = 0; i < n; ++i)
          x_y[i] -= y[i];
        for (unsigned int i = 0; i < n; ++i)
          {
            double sum = 0., size = 0.;
            add_row(full[m], -0.3, i, x, sum, size);
            raise(error, std::abs(one[i] - sum) / size / 1e-12);
            sum += 1.5 * base[i];
            size += std::abs(1.5 * base[i]);
            raise(error, std::abs(more[i] - sum) / size / 1e-12);
            add_row(full[next], 0.7, i, y, sum, size);
            raise(error, std::abs(two[i] - sum) / size / 1e-12);
            add_row(full[m], 2., i, z, sum, size);
            raise(error, std::abs(three[i] - sum) / size / 1e-12);

            double row = 0., row_size = 0.;
            add_row(full[m], 1., i, x, row, row_size);
            form += x[i] * row;
            form_size += std::abs(x[i]) * row_size;
            row = row_size = 0.;
            add_row(full[m], 1., i, x_y, row, row_size);
            difference += x_y[i] * row;
            difference_size += std::abs(x_y[i]) * row_size;
          }
        if (m == RodMatrices::divergence || m == RodMatrices::thermal_stress)
          continue;
        const auto matrix = static_cast<RodMatrices::Matrix>(m);
        raise(error,
              std::abs(rod.form(matrix, x.data()) - form) / form_size / 1e-12);
        raise(error,
              std::abs(rod.form_of_difference(matrix, x.data(), y.data()) -
                       difference) /
                difference_size / 1e-12);
      }
    return error;
  }



  /** Largest entry of products with a constant, and form, that must be 0. */
  double
  product_with_constant(const RodMatrices &rod)
  {
    const unsigned int n = rod.layout().n_nodes();
    const Vector       constant(n, 0.7);
    Vector             product(n);
    double             largest = 0.;
    for (const auto matrix : {RodMatrices::divergence,
                              RodMatrices::stiffness,
                              RodMatrices::viscous_stiffness})
      {
        rod.combine<1>({{{1., matrix, constant.data()}}},
                       0.,
                       nullptr,
                       product.data());
        for (const double value : product)
          raise(largest, std::abs(value));
        raise(largest, std::abs(rod.form(matrix, constant.data())));
      }
    return largest;
  }



  /** The same of the residual of a system, and its growth. */
  template <unsigned int n_fields>
  void
  add_error_of_system(const RodMatrices                           &rod,
                      const std::vector<FullMatrix<double>>       &full,
                      const typename RodFactors<n_fields>::Blocks &blocks,
                      double                                      &error,
                      double                                      &growth,
                      double &value_at_fixed_end)
  {
    const unsigned int                      n = rod.layout().n_nodes();
    const RodFactors<n_fields>              factors(rod, blocks);
    std::array<Vector, n_fields>            b, x;
    typename RodFactors<n_fields>::Right    right;
    typename RodFactors<n_fields>::Solution solution;
    for (unsigned int k = 0; k < n_fields; ++k)
      {
        b[k]        = random_vector(n);
        x[k]        = random_vector(n);
        right[k]    = b[k].data();
        solution[k] = x[k].data();
      }
    factors.solve(right, solution);
    if (n_fields == 1 && rod.layout().degree == 1)
      raise(growth, factors.growth());
    for (unsigned int k = 0; k < n_fields; ++k)
      {
        raise(value_at_fixed_end, std::abs(x[k][0]));
        for (unsigned int i = 1; i < n; ++i)
          {
            double sum = 0., size = std::abs(b[k][i]);
            for (unsigned int l = 0; l < n_fields; ++l)
              for (const auto &[factor, matrix] : blocks[k][l])
                add_row(full[matrix], factor, i, x[l], sum, size);
            raise(error, std::abs(b[k][i] - sum) / size / 1e-12);
          }
      }
  }



  void
  test_random()
  {
    double products = 0., one = 0., two = 0., growth = 0., fixed = 0.,
           of_constant = 0.;
    for (unsigned int degree = 1; degree <= 8; ++degree)
      for (unsigned int n_cells = 1; n_cells <= 9; ++n_cells)
        for (const unsigned int group : {1, 2, 5})
          {
            const RodLayout   layout{n_cells, degree};
            const Rod         random = random_rod(layout, group);
            const Matrices   &full   = random.full;
            const RodMatrices rod    = make(layout, random);
            raise(products, error_of_products(rod, full));
            if (degree > 1)
              raise(of_constant, product_with_constant(rod));

            const double               t = 0.4, a = 0.3, z = 0.2;
            const RodFactors<1>::Block heat{{1., RodMatrices::heat_mass},
                                            {t, RodMatrices::conduction}};
            const RodFactors<1>::Block momentum{
              {1., RodMatrices::momentum_mass},
              {t * z, RodMatrices::viscous_stiffness},
              {t * t, RodMatrices::stiffness}};
            add_error_of_system<1>(
              rod, full, {{{{momentum}}}}, one, growth, fixed);
            add_error_of_system<2>(
              rod,
              full,
              {{{{heat, {{a, RodMatrices::divergence}}}},
                {{{{-t * t * a, RodMatrices::thermal_stress}}, momentum}}}},
              two,
              growth,
              fixed);
          }
    deallog << "products: error in its bound "
            << (products <= 1. ? "yes" : "no") << std::endl
            << "products with a constant: nothing but 0 "
            << (of_constant == 0. ? "yes" : "no") << std::endl
            << "one field: residual in its bound " << (one <= 1. ? "yes" : "no")
            << std::endl
            << "two fields: residual in its bound "
            << (two <= 1. ? "yes" : "no") << std::endl
            << "one field of degree 1: growth " << growth << std::endl
            << "at the fixed end " << fixed << std::endl;
  }



  /** Of a rod whose cells have this matrix. */
  double
  growth_of(const RodLayout &layout, const FullMatrix<double> &cell_matrix)
  {
    const RodMatrices rod(layout,
                          0.,
                          [&](const RodMatrices::Matrix,
                              const unsigned int,
                              const unsigned int i,
                              const unsigned int j) {
                            return cell_matrix(i, j);
                          });
    return RodFactors<1>(rod, {{{{{{1., RodMatrices::stiffness}}}}}}).growth();
  }



  void
  test_growth()
  {
    for (const double pivot : {1e-8, 0.})
      {
        // the first vertex: right vertex of a cell and left one of the next
        FullMatrix<double> linear(2, 2);
        linear(0, 0) = pivot - 1.;
        linear(0, 1) = linear(1, 0) = linear(1, 1) = 1.;
        deallog << "first pivot " << pivot << ": growth "
                << growth_of({2, 1}, linear) << std::endl;
      }
    FullMatrix<double> single(2, 2);
    single(0, 0) = single(0, 1) = single(1, 0) = 1.;
    deallog << "the only pivot 0: growth " << growth_of({1, 1}, single)
            << std::endl;
    FullMatrix<double> quadratic(3, 3);
    quadratic(0, 0) = quadratic(1, 1) = quadratic(0, 2) = quadratic(2, 0) =
      quadratic(1, 2) = quadratic(2, 1) = 1.;
    deallog << "inner node without diagonal: growth "
            << growth_of({1, 2}, quadratic) << std::endl;
  }



  /** Of 5 cells whose entries grow by a factor from each to the next. */
  unsigned int
  n_runs(const double tolerance, const double factor)
  {
    return RodMatrices({5, 2},
                       tolerance,
                       [&](const RodMatrices::Matrix,
                           const unsigned int cell,
                           const unsigned int i,
                           const unsigned int j) {
                         return (1. + i + j) * std::pow(factor, cell);
                       })
      .runs()
      .size();
  }



  void
  test_runs()
  {
    const double rounding = 1. + std::numeric_limits<double>::epsilon();
    deallog << "runs: uniform but for rounding " << n_runs(1e-14, rounding)
            << ", exactly " << n_runs(0., 1.) << ", nothing allowed "
            << n_runs(0., rounding) << ", graded " << n_runs(1e-14, 1.1)
            << std::endl;
  }


  /** Case 5. */
  void
  test_exchange()
  {
    const RodLayout    layout{4, 3};
    const unsigned int n          = layout.nodes_per_cell();
    FullMatrix<double> conduction = random_cell(n, RodMatrices::stiffness);
    const double       each       = std::pow(2., -7.);
    const RodMatrices  rod(layout,
                          0.,
                          [&](const RodMatrices::Matrix m,
                              const unsigned int        cell,
                              const unsigned int        i,
                              const unsigned int        j) {
                            const double exchange =
                              each + (cell == 3 && i == 1 && j == 1 ? 1. : 0.);
                            return m == RodMatrices::heat_exchange ?
                                      exchange :
                                    m == RodMatrices::conduction ?
                                      1e5 * conduction(i, j) + exchange :
                                      0.;
                          });
    const Vector       constant(layout.n_nodes(), 0.7);
    Vector             product(layout.n_nodes());
    rod.combine<1>({{{1., RodMatrices::conduction, constant.data()}}},
                   0.,
                   nullptr,
                   product.data());
    double error = 0.;
    for (unsigned int i = 0; i < product.size(); ++i)
      {
        const bool   is_inner_vertex = i == 1 || i == 4 || i == 7;
        const double lost            = 4. * each * (is_inner_vertex ? 2. : 1.) +
                            (i == layout.node(3, 1) ? 1. : 0.);
        raise(error, std::abs(product[i] - 0.7 * lost));
      }
    const double form = rod.form(RodMatrices::conduction, constant.data());
    raise(error, std::abs(form - 0.49 * (4. * 16. * each + 1.)));
    deallog << "heat exchange: conduction of a constant in its bound "
            << (error <= 1e-15 ? "yes" : "no") << std::endl;
  }
} // namespace



int
main()
{
  initlog();
  test_random();
  test_growth();
  test_runs();
  test_exchange();
}
