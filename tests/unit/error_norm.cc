// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Scales of errors, ErrorNorm with b = 1, without heat, displacements to 1e-12.
// A body whose end has moved it by 1 with the energy 1e-30 has moved as a
// whole: up to 1e-14 of the square of the displacement are rounding, and so are
// errors of strains up to 1/2 (100 1e-12)^2 = 5e-21 in the displacement. Then
// the error 1e-30 counts as none, and the velocity with the error 2.5e-31 is
// that over 1e-30, the root of 1/4. A first attempt with the energy 1 is a
// scale for those that follow, 2.5e-31 / 1 is 2.5e-31 = (5e-16)^2; once a step
// is accepted it says nothing: as without it.

#include <thermocontact/simulation/error_norm.h>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  EnergyTerms
  terms(const double elastic, const double kinetic)
  {
    EnergyTerms result;
    result.elastic = elastic;
    result.kinetic = kinetic;
    return result;
  }
} // namespace



void
main_error_norm()
{
  initlog();
  const EnergyTerms body = terms(1e-30, 0.);
  for (const bool has_wild_attempt : {false, true})
    {
      ErrorNorm norm(0., 0., 1., 1e-12);
      if (has_wild_attempt)
        {
          norm.note_attempt(terms(1., 0.), 1.);
          deallog << "first attempt 1: velocity, 1e16 times "
                  << 1e16 * norm(terms(0., 2.5e-31), body, 1.) << std::endl;
        }
      norm.add(body);
      deallog << "accepted: strain " << norm(terms(1e-30, 0.), body, 1.)
              << ", velocity " << norm(terms(0., 2.5e-31), body, 1.)
              << ", at rest " << norm(terms(2.5e-31, 0.), body, 0.)
              << std::endl;
    }
}
