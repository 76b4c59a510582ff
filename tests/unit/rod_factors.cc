// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Factors of the matrices of a rod, no mesh: of random rods (random_rod.h).
//
// 1. Systems of one and of two fields as those of a stage, [M + t K, a D;
//    -t^2 a D^T, M_u + t z S_z + t^2 S], with all, some or none of the fields
//    held at node 0: residual in the full matrix to 1e-12 of its terms, and
//    held fields vanish there. One field of degree 1 is symmetric and definite
//    without inner nodes: elimination takes less from a pivot than it has, so
//    that nothing grows, 1.
// 2. Blocks that grow, two cells of degree 1. By hand: cells
//    [e - 1, 1; 1, 1] make rows [e 1; 1 1] of the two vertices, e = 1e-8: the
//    first pivot takes 1/e = 1e8 times the second from it. A pivot of 0 has
//    infinite growth, also the only one of one cell, and so has a cell of
//    degree 2 whose inner node has the diagonal 0. Two fields: the vertices
//    have the blocks [2 1; 1 1] and B, with [3 0; 0 1] above the diagonal and
//    [1 0; 0 5] below it. The determinant of the first is 2 - 1, its terms 3
//    times that; it takes [3 -1; -15 10] from the second, whose rows have 2 if
//    B = [2 0; 1 1], 25/2 times, and leaves (9 + 16)/7; 8 and 40, and
//    165/135, if B = [8 0; 0 40]: then 3.

#include <thermocontact/rod/rod_factors.h>

#include <array>
#include <cmath>

#include "../tests.h"

#include "../random_rod.h"

using namespace ThermoContact;
using dealii::FullMatrix;

namespace
{
  /**
   * Largest error of the residual of a system in units of 1e-12 of its terms,
   * and its growth.
   */
  template <unsigned int n_fields>
  void
  add_error_of_system(const RodMatrices                           &rod,
                      const std::vector<FullMatrix<double>>       &full,
                      const typename RodFactors<n_fields>::Blocks &blocks,
                      double                                      &error,
                      double                                      &growth,
                      double            &value_at_fixed_end,
                      const unsigned int pattern = (1U << n_fields) - 1)
  {
    const unsigned int                  n = rod.layout().n_nodes();
    typename RodFactors<n_fields>::Held held;
    for (unsigned int k = 0; k < n_fields; ++k)
      held[k] = (pattern >> k) % 2 == 1;
    const RodFactors<n_fields>              factors(rod, blocks, held);
    std::array<Values, n_fields>            b, x;
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
    if (n_fields == 1 && rod.layout().degree == 1 && held[0])
      raise(growth, factors.growth());
    for (unsigned int k = 0; k < n_fields; ++k)
      {
        if (held[k])
          raise(value_at_fixed_end, std::abs(x[k][0]));
        for (unsigned int i = held[k]; i < n; ++i)
          {
            double sum = 0., size = std::abs(b[k][i]);
            for (unsigned int l = 0; l < n_fields; ++l)
              for (const auto &[factor, matrix] : blocks[k][l])
                add_row(full[matrix], factor, i, x[l], sum, size);
            raise(error, std::abs(b[k][i] - sum) / size / 1e-12);
          }
      }
    if (pattern > 0) // the same with fewer fields held at node 0
      add_error_of_system<n_fields>(
        rod, full, blocks, error, growth, value_at_fixed_end, pattern - 1);
  }


  void
  test_systems()
  {
    double one = 0., two = 0., growth = 0., fixed = 0.;
    for (unsigned int degree = 1; degree <= 8; ++degree)
      for (unsigned int n_cells = 1; n_cells <= 9; ++n_cells)
        for (const unsigned int group : {1, 2, 5})
          {
            const RodLayout            layout{n_cells, degree};
            const Rod                  random = random_rod(layout, group);
            const Matrices            &full   = random.full;
            const RodMatrices          rod    = make(layout, random);
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
    deallog << "one field: residual in its bound " << (one <= 1. ? "yes" : "no")
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
    return RodFactors<1>(rod, {{{{{{1., RodMatrices::stiffness}}}}}}, {{true}})
      .growth();
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
    for (const std::array<double, 4> &b :
         {std::array<double, 4>{{2., 0., 1., 1.}}, {{8., 0., 0., 40.}}})
      {
        const double first[] = {2., 1., 1., 1.}, upper[] = {3., 0., 0., 1.},
                     lower[] = {1., 0., 0., 5.};
        const RodMatrices rod({2, 1},
                              0.,
                              [&](const RodMatrices::Matrix m,
                                  const unsigned int,
                                  const unsigned int i,
                                  const unsigned int j) {
                                return m > 3  ? 0. :
                                       i < j  ? upper[m] :
                                       i > j  ? lower[m] :
                                       i == 1 ? b[m] :
                                                first[m] - b[m];
                              });
        const auto        block = [](const unsigned int m) {
          return RodFactors<2>::Block{
            {1., static_cast<RodMatrices::Matrix>(m)}};
        };
        deallog << "two fields: growth "
                << RodFactors<2>(rod,
                                 {{{{block(0), block(1)}},
                                   {{block(2), block(3)}}}},
                                 {{true, true}})
                     .growth()
                << std::endl;
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
} // namespace



void
main_rod_factors()
{
  initlog();
  test_systems();
  test_growth();
}
