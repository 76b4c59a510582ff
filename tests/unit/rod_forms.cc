// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Forms of a rod of 100 linear cells whose terms cancel. [1, -1; -1, 1] of
// u_i = 1e8 + i is the sum of 100 squares of 1, 100. [1, 1; 1, 1] / 4 of v_i =
// (-1)^i 1e8 + i is the sum of (2 i + 1)^2 / 4 for i < 100,
// 100 (4 * 100^2 - 1) / 12 = 333325. Row by row both lose all digits.

#include <thermocontact/rod/rod_matrices.h>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  /** @param sign of the entries off the diagonal */
  void
  check(const double sign)
  {
    const double        size = sign < 0. ? 1. : 0.25;
    const RodMatrices   rod({100, 1},
                          0.,
                          [&](const RodMatrices::Matrix,
                              const unsigned int,
                              const unsigned int i,
                              const unsigned int j) {
                            return i == j ? size : sign * size;
                          });
    std::vector<double> x;
    for (unsigned int i = 0; i <= 100; ++i)
      x.push_back((sign > 0. && i % 2 == 1 ? -1e8 : 1e8) + i);
    deallog << (sign < 0. ? "differences of a large displacement " :
                            "sums of an alternating velocity ")
            << rod.form(RodMatrices::stiffness, x.data()) << std::endl;
  }
} // namespace



void
main_rod_forms()
{
  initlog();
  check(-1.);
  check(1.);
}
