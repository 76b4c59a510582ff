// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_exchange_of_law_h
#define thermocontact_simulation_exchange_of_law_h

#include <thermocontact/contact/exchange_stage.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/space/state.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Sets the heat exchange $k$ at each contact node, (M5.1), of
   * a state whose gaps and pressures are not those of a stage: at the start,
   * after an impact, an event, a jump. Of two obstacles it is that at which the
   * gap is smaller. A pull counts as no pressure: a step that ends with one is
   * not the last attempt at it.
   */
  template <int dim>
  void
  set_exchange_of_law(const Body<dim> &body, State &state)
  {
    if (!body.scene.fields.has_temperature)
      return;
    std::vector<NodeLaw> laws;
    std::vector<double>  position, temperature;
    get_node_laws(body, state, laws, position);
    body.contact_end().get_values(Field::temperature,
                                  state.temperature,
                                  temperature);
    for (unsigned int i = 0; i < laws.size(); ++i)
      state.contact.exchange_coefficient[i] = coefficient_of_node(
        *body.scene.heat.exchange,
        laws[i],
        position[i],
        laws[i].without_pull(state.contact.pressure[i]),
        body.surroundings.conditions(i, temperature[i], state.load_time));
  }
} // namespace ThermoContact

#endif
