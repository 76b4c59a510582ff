// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact of a node with mass over a step of the midpoint rule, no mesh.
//
// 1. By hand, eps = 1, chi = 2, so that r = chi/(2 eps) = 1:
//      open, -1 to -0.5:      p = 0
//      closed from 1, free 3: s = (3 - 1)/2 = 1, p = (1 + 1)/2 = 1
//      closes from 0, free 4: s = 4/2 = 2, p = s/2 = 1
//      closes from -1, free 3.5: 2 s^2 - 2.5 s - 3.5 = 0, s = (2.5 +
//      sqrt(34.25))
//        /4 = 2.0880875, p = (3.5 - s)/2 = 0.70595625
//      opens from 1, free -2: s^2 + s - 3 = 0, s = -(1 + sqrt(13))/2 =
//        -2.3027756, p = (-2 - s)/2 = 0.15138782
//    The law at the end: eps = 1e-3, chi = 2, h = 1, free 2.001: p = 1;
//    rigid, free 3: 1.5; free -1: 0.
// 2. 10^4 random steps, compliances from 1e-3 to 10, chi from 1e-3 to 10: s =
//    s_free - chi p, and p (s - s_0) = [s]_+^2/2eps - [s_0]_+^2/2eps to 1e-12
//    of the largest of these terms; p >= 0.
// 3. Which: the discrete gradient for eps >= h/2.

#include <thermocontact/method/step_contact.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  void
  test_by_hand()
  {
    const auto        law = make_law(1.);
    const StepContact gradient(*law, 1.);
    for (const auto &[old_penetration, free_penetration] :
         {std::pair(-1., -0.5),
          std::pair(1., 3.),
          std::pair(0., 4.),
          std::pair(-1., 3.5),
          std::pair(1., -2.)})
      deallog << "from " << old_penetration << ", free " << free_penetration
              << ": p "
              << gradient.pressure(old_penetration, free_penetration, 2.)
              << std::endl;
    const auto stiff = make_law(1e-3), rigid = make_law(0.);
    deallog << "at the end: p "
            << StepContact(*stiff, 1.).pressure(-1., 2.001, 2.) << ", rigid "
            << StepContact(*rigid, 1.).pressure(0., 3., 2.) << ", "
            << StepContact(*rigid, 1.).pressure(0., -1., 2.) << std::endl;
    for (const double spacing : {1.9, 2.1})
      deallog << "eps = 1, h = " << spacing << ": conserves "
              << StepContact(*law, spacing).conserves_energy() << std::endl;
  }



  void
  test_random()
  {
    std::mt19937                           generator(7);
    std::uniform_real_distribution<double> exponent(-3., 1.), value(-1., 1.);
    double                                 error = 0., smallest = 0.;
    for (unsigned int i = 0; i < 10000; ++i)
      {
        const double      eps = std::pow(10., exponent(generator));
        const double      chi = std::pow(10., exponent(generator));
        const double      s_0 = value(generator), s_free = value(generator);
        const auto        law = make_law(eps);
        const StepContact contact(*law, eps);
        const double      p      = contact.pressure(s_0, s_free, chi);
        const double      s      = s_free - chi * p;
        const auto        energy = [&](const double x) {
          return 0.5 * std::max(x, 0.) * std::max(x, 0.) / eps;
        };
        smallest = std::min(smallest, p);
        raise(error,
              std::abs(p * (s - s_0) - energy(s) + energy(s_0)) /
                (std::abs(p) *
                   (std::abs(s_free) + chi * std::abs(p) + std::abs(s_0)) +
                 energy(s) + energy(s_0) + 1e-300));
      }
    deallog << "gradient " << within(error, 1e-12) << ", p at least "
            << smallest << std::endl;
  }
} // namespace



int
main()
{
  initlog();
  test_by_hand();
  test_random();
}
