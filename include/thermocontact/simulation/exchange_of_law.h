// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_exchange_of_law_h
#define thermocontact_simulation_exchange_of_law_h

#include <thermocontact/space/node_laws.h>
#include <thermocontact/space/state.h>

#include <algorithm>
#include <vector>

namespace ThermoContact
{
  /**
   * The heat exchange $k$(gap, pressure) of a state at each contact node,
   * (M5.1): of two obstacles, that at which the gap is smaller. A pull counts
   * as no pressure: a step that ends with one is not the last attempt at it.
   */
  template <int dim>
  void
  set_exchange_coefficients(const Body<dim> &body, State &state)
  {
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    for (unsigned int i = 0; i < laws.size(); ++i)
      state.exchange_coefficient[i] = body.scene.heat.exchange->coefficient(
        laws[i].penetration(position[i]),
        std::max(laws[i].side * state.contact_pressure[i], 0.));
  }



  /**
   * Sets the heat exchange $k$(gap, pressure) at each contact node, (M5.1), of
   * a state whose gaps and pressures are not those of a stage: after an impact,
   * an event, a jump. Nothing to do where it is constant or without heat.
   */
  template <int dim>
  void
  set_exchange_of_law(const Body<dim> &body, State &state)
  {
    const HeatExchange &exchange = *body.scene.heat.exchange;
    if (exchange.is_constant() || !body.scene.fields.has_temperature)
      return;
    set_exchange_coefficients(body, state);
  }
} // namespace ThermoContact

#endif
