// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Products of the matrices of a rod, no mesh: of random rods (random_rod.h).
//
// 1. Products, combinations and forms, against sums over full matrices: to
//    rounding, 1e-12 of the sum of the absolute values of their terms. Of cells
//    of degree 2 and more the products of stiffnesses and D with a constant,
//    and the forms of stiffnesses, are 0, not rounding: all differences are.
// 2. 5 cells are one run if their entries are the same, or differ by rounding
//    and 1e-14 is allowed; 5 if nothing is allowed, or if the entries grow by
//    1.1 from cell to cell. If the inner three of those are said to repeat, 2:
//    they are not read.
// 3. Conduction of 1e5 times a stiffness and a heat exchange of 2^-7 in all
//    pairs of nodes and of 1 at the last one: the product with the constant 0.7
//    is the exchange alone to 1e-15, and so is the form, of 4 cells of degree 3
//    0.49 (1 + 64/2^7). Where entries were added up it would be 1e-11.
// 4. Forms of 100 linear cells whose terms cancel. [1, -1; -1, 1] of u_i = 1e8
// +
//    i is the sum of 100 squares of 1, 100. [1, 1; 1, 1] / 4 of v_i = (-1)^i
//    1e8 + i is the sum of (2 i + 1)^2 / 4 for i < 100, 100 (4 * 100^2 - 1) /
//    12 = 333325. Row by row both lose all digits.

#include <cmath>
#include <limits>

#include "../tests.h"

#include "../random_rod.h"

using namespace ThermoContact;
using dealii::FullMatrix;

namespace
{
  /** Largest error of products and forms in units of 1e-12 of their terms. */
  double
  error_of_products(const RodMatrices                     &rod,
                    const std::vector<FullMatrix<double>> &full)
  {
    const unsigned int n     = rod.layout().n_nodes();
    double             error = 0.;
    const Values       x = random_vector(n), y = random_vector(n),
                 z = random_vector(n), base = random_vector(n);
    Values     one(n), more(n), two(n), three(n);
    const auto term =
      [](const double factor, const unsigned int m, const Values &v) {
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
        Values x_y(x);
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
    const Values       constant(n, 0.7);
    Values             product(n);
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


  void
  test_products()
  {
    double products = 0., of_constant = 0.;
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
          }
    deallog << "products: error in its bound "
            << (products <= 1. ? "yes" : "no") << std::endl
            << "products with a constant: nothing but 0 "
            << (of_constant == 0. ? "yes" : "no") << std::endl;
  }


  /** Of 5 cells whose entries grow by a factor from each to the next. */
  unsigned int
  n_runs(const double tolerance,
         const double factor,
         const bool   inner_cells_repeat = false)
  {
    return RodMatrices(
             {5, 2},
             tolerance,
             [&](const RodMatrices::Matrix,
                 const unsigned int cell,
                 const unsigned int i,
                 const unsigned int j) {
               return (1. + i + j) * std::pow(factor, cell);
             },
             {},
             [&](const unsigned int cell) {
               return inner_cells_repeat && cell > 0 && cell < 4;
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
            << ", said to repeat " << n_runs(1e-14, 1.1, true) << std::endl;
  }


  /** Case 3. */
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
    const Values       constant(layout.n_nodes(), 0.7);
    Values             product(layout.n_nodes());
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


  /** Case 4. @param sign of the entries off the diagonal */
  void
  test_cancellation(const double sign)
  {
    const double      size = sign < 0. ? 1. : 0.25;
    const RodMatrices rod({100, 1},
                          0.,
                          [&](const RodMatrices::Matrix,
                              const unsigned int,
                              const unsigned int i,
                              const unsigned int j) {
                            return i == j ? size : sign * size;
                          });
    Values            x;
    for (unsigned int i = 0; i <= 100; ++i)
      x.push_back((sign > 0. && i % 2 == 1 ? -1e8 : 1e8) + i);
    deallog << (sign < 0. ? "differences of a large displacement " :
                            "sums of an alternating velocity ")
            << rod.form(RodMatrices::stiffness, x.data()) << std::endl;
  }
} // namespace



void
main_rod()
{
  initlog();
  test_products();
  test_runs();
  test_exchange();
  test_cancellation(-1.);
  test_cancellation(1.);
}
