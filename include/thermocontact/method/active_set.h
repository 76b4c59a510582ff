// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_active_set_h
#define thermocontact_method_active_set_h

#include <thermocontact/method/two_stops.h>

#include <vector>

namespace ThermoContact
{
  /**
   * The next set of the primal-dual active set method for (M.18) of
   * doc/model.md: nodes in contact that the obstacle would pull leave the set,
   * and nodes that would penetrate join it. A node that is pulled where it
   * penetrates, which equations that are solved to a tolerance let happen,
   * stays: it would join again. No communication: every rank has the values of
   * all nodes.
   *
   * @param pressure of the nodes, solved for the set; positive if it pushes
   * @param reach beyond the obstacle of the nodes, solved for the set; zero,
   *   not rounded, where a rigid obstacle holds them
   * @param may_change nodes that may leave and join
   * @param rounding part of the largest pressure and of the largest reach that
   *   says nothing of a sign: a node that touches without pressure must not
   *   flip for ever
   * @param only_the_first change one node (Murty's rule), which cannot cycle
   * @param is_active in: the set; out: the next one
   * @return false if the set stays as it is, which solves the problem
   */
  bool
  update_active_set(const std::vector<double> &pressure,
                    const std::vector<double> &reach,
                    const std::vector<bool>   &may_change,
                    const double               rounding,
                    const bool                 only_the_first,
                    std::vector<bool>         &is_active);



  /** The same for nodes between two stops. */
  struct SetsBetweenStops
  {
    std::vector<bool> is_active;
    std::vector<bool> is_rear; ///< nodes of the set that are at the rear stop
  };

  /**
   * The next set of nodes between two stops: a node that one of them would pull
   * leaves it, an open one joins that which it would penetrate.
   *
   * @param pressure positive at the front stop
   * @param rear_reach beyond the rear stop, likewise; empty: there is none
   */
  bool
  update_active_set(const std::vector<double> &pressure,
                    const std::vector<double> &reach,
                    const std::vector<double> &rear_reach,
                    const std::vector<bool>   &may_change,
                    const double               rounding,
                    const bool                 only_the_first,
                    SetsBetweenStops          &sets);

  /**
   * Pressures of nodes whose stop would pull, by rounding, become zero.
   *
   * @param may_pull nodes that keep theirs
   */
  void
  remove_pull(const SetsBetweenStops  &sets,
              const std::vector<bool> &may_pull,
              std::vector<double>     &pressure);
} // namespace ThermoContact

#endif
