// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/impact_layer.h>

#include <cmath>

namespace ThermoContact
{
  double
  time_of_impact(const double inertia,
                 const double viscosity,
                 const double compliance)
  {
    // The only positive root of a convex-concave cubic: the iteration
    // dt <- (b eps^2 (dt + zeta))^(1/3) is a monotone contraction from above.
    const double factor = inertia * compliance * compliance;
    double       dt     = std::cbrt(factor * viscosity) + std::sqrt(factor);
    for (unsigned int i = 0; i < 200; ++i)
      dt = std::cbrt(factor * (dt + viscosity));
    return dt;
  }



  double
  layer_of_impact(const double inertia,
                  const double viscosity,
                  const double compliance)
  {
    return std::sqrt(viscosity *
                     time_of_impact(inertia, viscosity, compliance) / inertia);
  }
} // namespace ThermoContact
