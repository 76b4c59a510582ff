// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_obstacle_action_h
#define thermocontact_contact_obstacle_action_h

#include <vector>

namespace ThermoContact
{
  /** Action of the obstacle on the contact nodes; on all ranks. */
  struct ObstacleAction
  {
    /**
     * Pressure $p_i$; negative at an obstacle behind, and of either sign in a
     * step that holds them.
     */
    std::vector<double> pressure;

    /**
     * Heat exchange coefficient $k_i\ge0$: by the law, or, where the law jumps,
     * any between its limits there.
     */
    std::vector<double> exchange_coefficient;

    void
    swap(ObstacleAction &other)
    {
      pressure.swap(other.pressure);
      exchange_coefficient.swap(other.exchange_coefficient);
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &pressure &exchange_coefficient;
    }
  };
} // namespace ThermoContact

#endif
