// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_two_stops_h
#define thermocontact_method_two_stops_h

#include <thermocontact/method/contact_law.h>

namespace ThermoContact
{
  /** One node between two stops in a stage without contact. */
  struct StopReach
  {
    double tau;           ///< stage length
    double front;         ///< $\tilde u-g$, where the stage starts from
    double rear;          ///< $-\tilde u-g_2$, likewise
    double free_velocity; ///< without contact

    /** Reaches beyond a stop. */
    bool
    touches() const
    {
      return front + tau * free_velocity > 0. ||
             rear - tau * free_velocity > 0.;
    }
  };



  /**
   * The pressure of a node between two stops with the same law, doc/model.md
   * (M.107): positive at the front stop, negative at the rear one, for which
   * the problem is the mirrored one.
   *
   * @param receptance loss of displacement per unit pressure
   * @param is_held contact with the nearer stop that cannot open
   */
  double
  two_stops_pressure(const ContactLaw &law,
                     const StopReach  &reach,
                     const double      receptance,
                     const bool        is_held);
} // namespace ThermoContact

#endif
