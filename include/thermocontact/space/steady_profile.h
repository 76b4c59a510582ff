// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_steady_profile_h
#define thermocontact_space_steady_profile_h

#include <thermocontact/space/loads.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

namespace ThermoContact
{
  /**
   * The temperature $\theta_s$ relative to which heat has energy: at rest,
   * without sources, with the heat exchange $k_s$ of the undeformed body. The
   * interpolant of (M2.1), or, with a lateral heat exchange, the solution of
   * the semidiscrete equation (M5.7). Collective.
   *
   * @param profile out, of the layout of the temperature
   * @throw ComputationError if the matrix of (M5.7) cannot be factorised
   */
  template <int dim>
  void
  set_steady_profile(const Scene                           &scene,
                     const Discretization<dim>             &discretization,
                     const ThermoviscoelasticOperator<dim> &stage_operator,
                     const Loads<dim>                      &loads,
                     Vector                                &profile);
} // namespace ThermoContact

#endif
