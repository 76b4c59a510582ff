// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/nearer_stop.h>

namespace ThermoContact
{
  template <int dim>
  std::vector<double>
  pressures_of_nearer_stop(const Body<dim> &body, const State &state)
  {
    std::vector<double> front, rear;
    body.contact_end().get_penetrations(state, front);
    body.contact_end().get_rear_penetrations(state.displacement,
                                             *body.scene.contact.rear_gap,
                                             rear);
    std::vector<double> pressures(state.contact_pressure);
    for (unsigned int i = 0; i < pressures.size(); ++i)
      if (rear[i] > front[i])
        pressures[i] = -pressures[i];
    return pressures;
  }



  template std::vector<double>
  pressures_of_nearer_stop(const Body<1> &, const State &);
  template std::vector<double>
  pressures_of_nearer_stop(const Body<2> &, const State &);
  template std::vector<double>
  pressures_of_nearer_stop(const Body<3> &, const State &);
} // namespace ThermoContact
