// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Conjugate gradients and what they say if they fail. The matrix 2 on the
// diagonal and -1 beside it, of size n, b = 1: x_i = i (n + 1 - i)/2. Exact
// after n/2 = 5 steps by symmetry, to rounding 1e-13; in 3 steps they fail,
// with an error that names what was to be found, the numbers and the remedy.
//
// FlexibleGmres with b in two blocks: A b is 1 at the ends and 0 between, and k
// steps reach k entries from each end: the residual is sqrt(10 - 2 k). Begun
// anew after each step, the second one has r = (0, 1, 1, 1, 1 ...), A r = (-1,
// 1, 0 ...) and the residual (1/2, 1/2, 1, 1, 1 ...), sqrt(7). Directions are
// kept in single precision: 5 steps end at 1e-6, more, or 4 at a time, at
// 1e-12; the same if every other one is doubled by the preconditioner.

#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/flexible_gmres.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/vector.h>

#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  struct SecondDifference
  {
    template <class V>
    void
    vmult(V &y, const V &x) const
    {
      const unsigned int n = x.size();
      for (unsigned int i = 0; i < n; ++i)
        y(i) =
          2. * x(i) - (i > 0 ? x(i - 1) : 0.) - (i + 1 < n ? x(i + 1) : 0.);
    }
  };



  template <class V>
  double
  error_of(const V &x)
  {
    double largest = 0.;
    for (unsigned int i = 0; i < x.size(); ++i)
      raise(largest, std::abs(x(i) - 0.5 * (i + 1.) * (x.size() - i)));
    return largest;
  }



  double
  largest_error(const unsigned int max_iterations)
  {
    const unsigned int     n = 10;
    dealii::Vector<double> x(n), b(n), ones(n);
    b    = 1.;
    ones = 1.;
    conjugate_gradients("the shape of a string",
                        SecondDifference(),
                        x,
                        b,
                        dealii::DiagonalMatrix<dealii::Vector<double>>(ones),
                        1e-12,
                        max_iterations);
    return error_of(x);
  }

  using Blocks = ThermoContact::BlockVector;

  /** The identity, times 2 in every other step if it is to differ. */
  struct Preconditioner
  {
    const bool           differs;
    mutable unsigned int n = 0;

    void
    vmult(Blocks &y, const Blocks &x) const
    {
      y = x;
      if (differs && n++ % 2 == 0)
        y *= 2.;
    }
  };



  void
  test_gmres(const unsigned int at_a_time,
             const unsigned int max_iterations,
             const bool         differs)
  {
    Blocks        b(2, 5), x(b), r(b);
    FlexibleGmres gmres(at_a_time);
    b = 1.;
    FlexibleGmres::Result result{};
    for (unsigned int run = 0; run < 2; ++run) // nothing is left of the first
      result = gmres.solve(SecondDifference(),
                           Preconditioner{differs},
                           1e-12,
                           max_iterations,
                           b,
                           x);
    SecondDifference().vmult(r, x);
    r -= b;
    deallog << "GMRES, " << at_a_time << " at a time: ";
    if (max_iterations <= 5)
      deallog << result.n_iterations << " steps, residual " << result.residual;
    else
      deallog << "residual " << within(result.residual, 1e-12) << ", solution "
              << within(error_of(x), 1e-10);
    deallog << ", as estimated "
            << within(std::abs(r.l2_norm() - result.residual), 1e-11)
            << std::endl;
  }
} // namespace



void
main_conjugate_gradients()
{
  initlog();
  for (unsigned int k = 1; k <= 5; ++k)
    test_gmres(20, k, false);
  test_gmres(1, 2, false);
  for (const bool differs : {false, true})
    for (const unsigned int at_a_time : {20, 4})
      test_gmres(at_a_time, 1000, differs);
  deallog << "5 steps: exact " << within(largest_error(5), 1e-12) << std::endl;
  try
    {
      const double error = largest_error(3);
      deallog << "3 steps: error " << error << std::endl;
    }
  catch (const ComputationError &error)
    {
      const std::string message = error.what();
      const auto        says    = [&](const std::string &words) {
        return message.find(words) != std::string::npos;
      };
      deallog << "3 steps: says of what "
              << (message.find("the shape of a string: ") == 0)
              << ", which tolerance " << says("instead of 1e-12")
              << ", how many steps " << says("in 3 iterations") << ", remedy "
              << says("remedy:  Solver/Linear solver = direct") << std::endl;
    }
}
