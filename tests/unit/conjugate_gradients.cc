// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Conjugate gradients and what they say if they fail. The matrix 2 on the
// diagonal and -1 beside it, of size n, b = 1: x_i = i (n + 1 - i)/2. Exact
// after n/2 = 5 steps by symmetry, to rounding 1e-13; in 3 steps they fail,
// with an error that names what was to be found, the numbers and the remedy.

#include <thermocontact/space/conjugate_gradients.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/vector.h>

#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  struct SecondDifference
  {
    void
    vmult(dealii::Vector<double> &y, const dealii::Vector<double> &x) const
    {
      const unsigned int n = x.size();
      for (unsigned int i = 0; i < n; ++i)
        y(i) =
          2. * x(i) - (i > 0 ? x(i - 1) : 0.) - (i + 1 < n ? x(i + 1) : 0.);
    }
  };



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
                        ones,
                        1e-12,
                        max_iterations);
    double largest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      raise(largest, std::abs(x(i) - 0.5 * (i + 1.) * (n - i)));
    return largest;
  }
} // namespace



void
main_conjugate_gradients()
{
  initlog();
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
