// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/rest_profile.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** $e^{-\mu}\sinh(y)/y$ for $0<y\le\mu$, without overflow. */
    double
    scaled_sinhc(const double y, const double mu)
    {
      return -0.5 * std::expm1(-2. * y) * std::exp(y - mu) / y;
    }
  } // namespace



  RestProfile::RestProfile(const RodSurroundings &rod, const double drop)
  {
    if (rod.lateral_exchange == 0.)
      {
        end_  = rod.fixed_end - drop * (rod.fixed_end - rod.obstacle);
        mean_ = rod.fixed_end - 0.5 * drop * (rod.fixed_end - rod.obstacle);
        return;
      }
    // all hyperbolic functions times exp(-mu)
    const double mu    = std::sqrt(rod.lateral_exchange);
    const double one   = std::exp(-mu);
    const double cosh  = 0.5 * (1. + one * one);
    const double sinhc = scaled_sinhc(mu, mu); // sinh(mu)/mu
    const double half  = scaled_sinhc(0.5 * mu, 0.5 * mu);
    const double coshc = 0.5 * half * half; // (cosh(mu)-1)/mu^2

    const double fixed    = rod.fixed_end - rod.ambient;
    const double obstacle = rod.obstacle - rod.ambient;
    const double open     = 1. - drop;
    const double divisor  = open * cosh + drop * sinhc;
    end_ =
      rod.ambient + (open * fixed * one + drop * obstacle * sinhc) / divisor;
    mean_ = rod.ambient +
            (fixed * (open * sinhc + drop * coshc) + drop * obstacle * coshc) /
              divisor;
  }
} // namespace ThermoContact
