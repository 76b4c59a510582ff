// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_contact_law_h
#define thermocontact_method_contact_law_h

namespace ThermoContact
{
  /** What a stage supposes of the contact nodes. */
  enum class ContactMode
  {
    unilateral, ///< the contact law itself, (M.18)
    open,       ///< $p=0$ whatever the gap
    closed      ///< $\varepsilon p=u_n-g$ for all nodes, of either sign
  };



  /** How contact nodes move. */
  enum class ContactNodes
  {
    with_mass,
    massless,      ///< they follow the pressure at once
    of_static_body ///< so does the whole body, and velocities say nothing
  };



  /**
   * Contact condition at one node of the contact boundary; no mesh, no matrix.
   *
   * Normal displacement $u$ and pressure $p$ satisfy the complementarity
   * @f[
   *   p \ge 0, \quad g - u + \varepsilon p \ge 0, \quad
   *   p\,(g - u + \varepsilon p) = 0
   * @f]
   * of doc/model.md (M.4), (M.5): normal compliance for $\varepsilon>0$,
   * Signorini for $\varepsilon=0$. Nondimensional.
   */
  struct ContactLaw
  {
    bool   is_active  = true; ///< false: no obstacle, $p=0$
    double compliance = 0.01; ///< $\varepsilon\ge0$; 0 is a rigid obstacle
    double gap        = 0.1;  ///< $g$, of the undeformed body

    /**
     * Exact pressure of one node that responds to its own pressure alone,
     * doc/model.md (M.17).
     *
     * @param free_displacement normal displacement without contact
     * @param receptance $\chi\ge0$, loss of displacement per unit pressure;
     *   $\varepsilon+\chi>0$
     */
    double
    pressure(const double free_displacement, const double receptance) const
    {
      const double penetration = free_displacement - gap;
      return is_active && penetration > 0. ?
               penetration / (compliance + receptance) :
               0.;
    }
  };
} // namespace ThermoContact

#endif
