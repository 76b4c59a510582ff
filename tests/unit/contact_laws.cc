// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Each contact law of the program, no mesh, at p between 0.1 and 3: d energy =
// p ds and ds = tangent dp (central differences of step 1e-4 p, so to 1e-7),
// pressure(s(p)) = p and penetration_of_energy(energy(p)) = s(p) unless it is
// rigid, the resolvent solves z - chi p = s(p), odd where it is held, odd
// penetrations; the mean pressure between two penetrations times their
// difference is the difference of the energies, and p between equal ones.

#include <thermocontact/contact/contact_law.h>

#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

void
main_contact_laws()
{
  initlog();
  for (const ContactLawKind &kind : contact_laws())
    {
      const auto law = kind.make(default_law_parameters());
      double     chi = 0.3, worst = 0.;
      for (const double p : {0.1, 1., 3.})
        {
          const double h  = 1e-4 * p;
          const double ds = law->penetration(p + h) - law->penetration(p - h);
          const double dE = law->energy(p + h) - law->energy(p - h);
          const double s  = law->penetration(p);
          raise(worst, std::abs(dE - p * ds) / (2. * h));
          raise(worst, std::abs(ds / (2. * h) - law->tangent(p)));
          raise(worst, std::abs(s + law->penetration(-p)));
          raise(worst, std::abs(law->pressure(-1.)));
          raise(worst, law->resolve(-1., chi).pressure);
          if (!law->is_active())
            continue;
          NodeLaw held(*law);
          held.is_held = true;
          raise(worst, std::abs(law->resolve(s + chi * p, chi).pressure - p));
          raise(worst, std::abs(held.resolve(-s - chi * p, chi).pressure + p));
          if (law->is_rigid())
            continue;
          raise(worst, std::abs(law->pressure(s) - p));
          raise(worst, std::abs(law->mean_pressure(s, s) - p));
          raise(worst,
                std::abs(law->penetration_of_energy(law->energy(p)) - s));
          for (const double other : {-0.7 * s, 0.3 * s, 2. * s})
            raise(worst,
                  std::abs(law->mean_pressure(s, other) * (other - s) -
                           law->energy(law->pressure(other)) + law->energy(p)));
        }
      deallog << kind.name << ": consistent " << within(worst, 1e-7)
              << ", linear " << law->is_linear() << std::endl;
    }
}
