// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The next set of nodes in contact, by hand. Nodes 0 to 7 have the pressures 2,
// -1, -1, -1e-13, 0, 0, 0, 0 and reach 0, 0, 1, 0, 1, -1, 1e-13, 1 beyond the
// obstacle, the first four being active, the last one being fixed. 1 is pulled
// and leaves, 4 penetrates and joins; 2 is pulled where it penetrates and
// stays; 3 and 6 are below the rounding 1e-12 of the largest pressure and
// reach; 5 is away; 7 may not change. One at a time: 1 alone. The next sets
// have nothing left to change but 4, and then nothing.

#include <thermocontact/method/active_set.h>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const std::vector<double> pressure{2., -1., -1., -1e-13, 0., 0., 0., 0.};
  const std::vector<double> reach{0., 0., 1., 0., 1., -1., 1e-13, 1.};
  const std::vector<bool>   may_change{1, 1, 1, 1, 1, 1, 1, 0};

  void
  print_next(const bool only_the_first, std::vector<bool> &is_active)
  {
    const bool changed = update_active_set(
      pressure, reach, may_change, 1e-12, only_the_first, is_active);
    for (const bool active : is_active)
      deallog << active << ' ';
    deallog << "changed " << changed << std::endl;
  }
} // namespace



int
main()
{
  initlog();
  std::vector<bool> many{1, 1, 1, 1, 0, 0, 0, 0}, one(many);
  print_next(false, many);
  print_next(false, many);
  print_next(true, one);
  print_next(true, one);
  print_next(true, one);
}
