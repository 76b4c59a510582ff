// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/step_contact.h>
#include <thermocontact/method/two_stops.h>

#include <cmath>

namespace ThermoContact
{
  StepContact::StepContact(const ContactLaw &law, const double node_spacing)
    : law(law)
    , compliance(law.is_rigid() ? 0. : law.tangent(1.))
    , conserves_energy_(compliance >= 0.5 * node_spacing)
  {}



  double
  StepContact::pressure(const double old_penetration,
                        const double free_penetration,
                        const double receptance) const
  {
    return conserves_energy_ ?
             discrete_gradient(old_penetration, free_penetration, receptance) :
             law.local_pressure(free_penetration, receptance);
  }



  double
  StepContact::pressure(const double old_penetration,
                        const double free_penetration,
                        const double receptance,
                        const double far_old_penetration,
                        const double far_free_penetration) const
  {
    const double p = pressure(old_penetration, free_penetration, receptance);
    if (!conserves_energy_)
      return p > 0. ? p :
                      0. - pressure(far_old_penetration,
                                    far_free_penetration,
                                    receptance);
    if (far_old_penetration <= 0. &&
        far_free_penetration + receptance * p <= 0.)
      return p;
    const double far_p =
      pressure(far_old_penetration, far_free_penetration, receptance);
    if (old_penetration <= 0. && free_penetration + receptance * far_p <= 0.)
      return 0. - far_p;
    return crossing_pressure(compliance,
                             old_penetration,
                             free_penetration,
                             receptance,
                             -old_penetration - far_old_penetration);
  }



  double
  StepContact::discrete_gradient(const double s_0,
                                 const double s_free,
                                 const double receptance) const
  {
    const double r = receptance / (2. * compliance);
    if (s_0 <= 0. && s_free <= 0.)
      return 0.; // open
    if (s_0 <= 0.)
      {
        // closes: p = s^2 / (2 eps (s - s_0)), s the positive root of
        // (1 + r) s^2 - (s_free + s_0) s + s_free s_0 = 0
        const double sum  = s_free + s_0;
        const double root = std::sqrt(sum * sum - 4. * (1. + r) * s_free * s_0);
        const double s    = sum >= 0. ? (sum + root) / (2. * (1. + r)) :
                                        2. * s_free * s_0 / (sum - root);
        return s > 0. ? s * (s / (s - s_0)) / (2. * compliance) : 0.;
      }
    const double s = (s_free - r * s_0) / (1. + r);
    if (s >= 0.)
      return (s_0 + s) / (2. * compliance); // closed
    // opens: p = s_0^2 / (2 eps (s_0 - s)), s the negative root of
    // s^2 - (s_0 + s_free) s + s_0 s_free - r s_0^2 = 0
    const double difference = s_0 - s_free;
    const double fall       = // s_0 - s
      0.5 *
      (difference + std::sqrt(difference * difference + 4. * r * s_0 * s_0));
    return s_0 * (s_0 / fall) / (2. * compliance);
  }
} // namespace ThermoContact
