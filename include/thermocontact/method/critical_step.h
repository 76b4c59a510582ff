// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_critical_step_h
#define thermocontact_method_critical_step_h

namespace ThermoContact
{
  /**
   * The step size (D7.3) above which the iteration of the paper fails while in
   * contact: the root of $\Delta t^3=b\varepsilon^2(\Delta t+\zeta)$. It is the
   * time in which a linear obstacle stops the end of a rod, too.
   *
   * @param inertia $b>0$
   * @param viscosity $\zeta\ge0$
   * @param compliance $\varepsilon>0$
   */
  double
  critical_step_size(const double inertia,
                     const double viscosity,
                     const double compliance);

  /**
   * Length over which viscosity spreads the pressure of the obstacle in a rod
   * in that time, $\sqrt{\zeta\,\Delta t/b}$.
   */
  double
  layer_of_impact(const double inertia,
                  const double viscosity,
                  const double compliance);
} // namespace ThermoContact

#endif
