// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_exchange_of_law_h
#define thermocontact_simulation_exchange_of_law_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Sets the heat exchange $k$(gap, pressure) at each contact node, (M.3), of
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
    std::vector<double> penetration;
    body.contact_end().get_penetrations(state, penetration);
    for (unsigned int i = 0; i < penetration.size(); ++i)
      state.exchange_coefficient[i] =
        exchange.coefficient(penetration[i], state.contact_pressure[i]);
  }
} // namespace ThermoContact

#endif
