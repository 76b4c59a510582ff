// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_impact_layer_h
#define thermocontact_method_impact_layer_h

namespace ThermoContact
{
  /**
   * The time in which a linear obstacle stops the end of a rod, (D7.3): the
   * root of $t^3=b\varepsilon^2(t+\zeta)$. The iteration of the paper fails in
   * longer steps while in contact.
   *
   * @param inertia $b>0$
   * @param viscosity $\zeta\ge0$
   * @param compliance $\varepsilon>0$
   */
  double
  time_of_impact(const double inertia,
                 const double viscosity,
                 const double compliance);

  /**
   * Length over which viscosity spreads the pressure of the obstacle in a rod
   * in that time, $\sqrt{\zeta t/b}$.
   */
  double
  layer_of_impact(const double inertia,
                  const double viscosity,
                  const double compliance);
} // namespace ThermoContact

#endif
