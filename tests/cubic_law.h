// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_cubic_law_h
#define thermocontact_tests_cubic_law_h

#include <thermocontact/method/contact_law.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  /** s = p^3 between nodes; what one node alone needs is not asked for. */
  class CubicLaw : public ContactLaw
  {
  public:
    std::string
    description() const override
    {
      return "cubic";
    }

    double
    pressure(const double penetration) const override
    {
      return std::cbrt(std::max(penetration, 0.));
    }

    double
    penetration(const double pressure) const override
    {
      return pressure * pressure * pressure;
    }

    double
    tangent(const double pressure) const override
    {
      return 3. * pressure * pressure;
    }

    bool
    is_linear() const override
    {
      return false;
    }

    double
    energy(const double pressure) const override
    {
      return 0.75 * std::pow(pressure, 4);
    }

    double
    penetration_of_energy(const double energy) const override
    {
      return std::pow(energy / 0.75, 0.75);
    }

    double
    local_closed_pressure(const double, const double) const override
    {
      return 0.;
    }
  };
} // namespace ThermoContact

#endif
