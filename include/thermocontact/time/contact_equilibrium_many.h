// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_contact_equilibrium_many_h
#define thermocontact_time_contact_equilibrium_many_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>
#include <thermocontact/time/contact_node_problem.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Penetrations of all nodes of the end, or their rates; where there is no
   * pressure, displacements.
   */
  std::vector<double>
  before_obstacle(const std::vector<double> &gap,
                  const std::vector<double> &displacement);

  /**
   * As settle_contact_nodes(), for as many nodes as there may be.
   *
   * @param load forces on the nodes
   * @param rate_load likewise, of the velocity
   */
  template <int dim>
  void
  settle_many_nodes(const Body<dim>           &body,
                    const std::vector<double> &load,
                    const std::vector<double> &rate_load,
                    State                     &state);

  /**
   * As settle_contact_velocities(), for as many nodes as there may be.
   *
   * @param load forces on the nodes, with those of the velocity
   */
  template <int dim>
  void
  settle_many_velocities(const Body<dim>           &body,
                         const std::vector<double> &load,
                         const std::vector<bool>   &is_closed,
                         State                     &state);
} // namespace ThermoContact

#endif
