// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/nearer_stop.h>

namespace ThermoContact
{
  template <int dim>
  void
  look_at_stops(const Body<dim> &body, const State &state, NearerStops &stops)
  {
    body.contact_end().get_penetrations(state, stops.near);
    stops.far.clear();
    if (body.scene.contact.rear_gap)
      body.contact_end().get_rear_penetrations(state.displacement,
                                               *body.scene.contact.rear_gap,
                                               stops.far);
    stops.choose();
  }



  template <int dim>
  std::vector<double>
  pressures_of_nearer_stop(const Body<dim> &body, const State &state)
  {
    NearerStops stops;
    look_at_stops(body, state, stops);
    std::vector<double> pressures(state.contact_pressure);
    stops.turn(pressures);
    return pressures;
  }



#define INSTANTIATE(dim)                                                   \
  template void                look_at_stops(const Body<dim> &,            \
                                             const State &,                \
                                             NearerStops &);               \
  template std::vector<double> pressures_of_nearer_stop(const Body<dim> &, \
                                                        const State &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
