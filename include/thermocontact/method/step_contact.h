// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_step_contact_h
#define thermocontact_method_step_contact_h

#include <thermocontact/method/contact_law.h>

namespace ThermoContact
{
  /**
   * Contact of one node with mass over a step of the midpoint rule,
   * doc/model.md (M.81): the mean pressure of the step. The penetration
   * at its end is s = s_free - chi p.
   */
  class StepContact
  {
  public:
    /**
     * @param law linear
     * @param node_spacing the mesh resolves an obstacle whose compliance is
     *   not far below it
     */
    StepContact(const ContactLaw &law, const double node_spacing);

    /**
     * True if the pressure is the discrete gradient of the potential
     * $[s]_+^2/2\varepsilon$, which conserves energy: $\varepsilon\ge h/2$,
     * from where on the mesh follows the obstacle without overshooting. Else
     * the pressure is that of the law at the end of the step, which takes
     * energy.
     */
    bool
    conserves_energy() const
    {
      return conserves_energy_;
    }

    /**
     * @param old_penetration $s_0$ at the start of the step
     * @param free_penetration $s_{free}$, at its end without pressure
     * @param receptance $\chi>0$
     */
    double
    pressure(const double old_penetration,
             const double free_penetration,
             const double receptance) const;

    /**
     * The same between two stops: negative at the second one.
     *
     * @param far_old_penetration,far_free_penetration there
     */
    double
    pressure(const double old_penetration,
             const double free_penetration,
             const double receptance,
             const double far_old_penetration,
             const double far_free_penetration) const;

  private:
    const ContactLaw &law;
    const double      compliance; ///< 0: rigid
    const bool        conserves_energy_;

    double
    discrete_gradient(const double old_penetration,
                      const double free_penetration,
                      const double receptance) const;
  };
} // namespace ThermoContact

#endif
