// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_random_rod_h
#define thermocontact_tests_random_rod_h

#include <thermocontact/rod/rod_matrices.h>

#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests.h"

namespace ThermoContact
{
  using Values = std::vector<double>;

  constexpr unsigned int n_matrices = RodMatrices::n_matrices;

  inline std::mt19937 generator(20);

  inline double
  random()
  {
    return std::uniform_real_distribution<double>(-1., 1.)(generator);
  }



  inline Values
  random_vector(const unsigned int n)
  {
    Values v(n);
    for (double &x : v)
      x = random();
    return v;
  }



  using Matrices = std::vector<dealii::FullMatrix<double>>;

  /**
   * The matrices of a rod, and those of its cells: sums of random
   * cell matrices A^T A + I/2, of two kinds in turn by groups of cells, or one
   * for each cell; D is such a matrix with the half below its diagonal times
   * -1/2, and the thermal stress its transpose. Stiffnesses are A^T A and D,
   * with the first columns of A and D such that rows add up to 0; conduction
   * has the heat exchange besides, and 1/2 of that at the end of the last cell,
   * if it is a run of its own.
   */
  struct Rod
  {
    Matrices              full;
    std::vector<Matrices> cells;
  };



  /** Whether the product of a matrix with a constant is 0. */
  inline bool
  has_rows_of_zero_sum(const unsigned int matrix)
  {
    return matrix == RodMatrices::conduction ||
           matrix == RodMatrices::divergence ||
           matrix == RodMatrices::stiffness ||
           matrix == RodMatrices::viscous_stiffness;
  }



  inline void
  make_rows_of_zero_sum(dealii::FullMatrix<double> &a)
  {
    for (unsigned int i = 0; i < a.m(); ++i)
      {
        a(i, 0) = 0.;
        for (unsigned int j = 1; j < a.n(); ++j)
          a(i, 0) -= a(i, j);
      }
  }



  /** A random matrix of a cell, symmetric but for D. */
  inline dealii::FullMatrix<double>
  random_cell(const unsigned int n, const unsigned int matrix)
  {
    dealii::FullMatrix<double> a(n, n), result(n, n);
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
  inline Rod
  random_rod(const RodLayout &layout, const unsigned int group)
  {
    const unsigned int n = layout.nodes_per_cell();
    Rod                rod;
    rod.full.assign(n_matrices,
                    dealii::FullMatrix<double>(layout.n_nodes(),
                                               layout.n_nodes()));
    Matrices cell(n_matrices, dealii::FullMatrix<double>(n, n));
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



  inline RodMatrices
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
  inline void
  add_row(const dealii::FullMatrix<double> &matrix,
          const double                      factor,
          const unsigned int                i,
          const Values                     &x,
          double                           &sum,
          double                           &size)
  {
    for (unsigned int j = 0; j < x.size(); ++j)
      {
        sum += factor * matrix(i, j) * x[j];
        size += std::abs(factor * matrix(i, j) * x[j]);
      }
  }
} // namespace ThermoContact

#endif
