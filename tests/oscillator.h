// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_oscillator_h
#define thermocontact_tests_oscillator_h

#include <cmath>

namespace ThermoContact
{
  /** Position and velocity. */
  struct Motion
  {
    double u, v;
  };



  /** The mass 1/2 on a spring k that rests at @p rest, with a dashpot d. */
  inline Motion
  oscillation(const double  d,
              const double  k,
              const double  rest,
              const Motion &start,
              const double  t)
  {
    const double mass = 0.5, decay = 0.5 * d / mass,
                 w = std::sqrt(k / mass - decay * decay), x = start.u - rest,
                 q = (start.v + decay * x) / w;
    const double c = std::cos(w * t), s = std::sin(w * t);
    const double f = std::exp(-decay * t);
    return {rest + f * (x * c + q * s),
            f * ((q * w - decay * x) * c - (x * w + decay * q) * s)};
  }
} // namespace ThermoContact

#endif
