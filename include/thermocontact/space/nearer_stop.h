// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_nearer_stop_h
#define thermocontact_space_nearer_stop_h

#include <thermocontact/method/two_stops.h>
#include <thermocontact/space/body.h>

#include <vector>

namespace ThermoContact
{
  /** Looks where the contact nodes of a state are. Collective. */
  template <int dim>
  void
  look_at_stops(const Body<dim> &body, const State &state, NearerStops &stops);

  /**
   * Contact pressures between two stops as the nearer one sees them: positive
   * if it pushes, negative if it would pull. Collective.
   */
  template <int dim>
  std::vector<double>
  pressures_of_nearer_stop(const Body<dim> &body, const State &state);
} // namespace ThermoContact

#endif
