// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/node_laws.h>

namespace ThermoContact
{
  template <int dim>
  void
  get_node_laws(const Body<dim>      &body,
                const State          &state,
                std::vector<NodeLaw> &laws,
                std::vector<double>  &position)
  {
    const std::optional<double> &rear_gap = body.scene.contact.rear_gap;
    body.contact_end().get_penetrations(state, position);
    laws.assign(position.size(), NodeLaw(body.law()));
    if (!rear_gap)
      return;
    std::vector<double> rear;
    body.contact_end().get_rear_penetrations(state.displacement,
                                             *rear_gap,
                                             rear);
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        laws[i].play = state.gap[i] + *rear_gap;
        if (rear[i] > position[i])
          {
            laws[i].side = -1;
            position[i]  = -rear[i];
          }
      }
  }



  template <int dim>
  void
  get_node_laws(const Body<dim>           &body,
                const std::vector<double> &gap,
                const std::vector<double> &displacement,
                std::vector<NodeLaw>      &laws,
                std::vector<double>       &position)
  {
    const std::optional<double> &rear_gap = body.scene.contact.rear_gap;
    laws.assign(gap.size(), NodeLaw(body.law()));
    position.resize(gap.size());
    for (unsigned int i = 0; i < gap.size(); ++i)
      {
        position[i] = displacement[i] - gap[i];
        if (!rear_gap)
          continue;
        laws[i].play = gap[i] + *rear_gap;
        if (laws[i].nearer_side(position[i]) > 0)
          continue;
        laws[i].side = -1;
        position[i]  = displacement[i] + *rear_gap;
      }
  }



  template <int dim>
  void
  get_velocity_laws(const Body<dim>         &body,
                    const State             &state,
                    const std::vector<bool> &is_closed,
                    std::vector<NodeLaw>    &laws)
  {
    std::vector<double> position;
    get_node_laws(body, state, laws, position);
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        laws[i].play = NodeLaw().play;
        if (!is_closed[i])
          laws[i].law = nullptr;
      }
  }



  template <int dim>
  double
  displacement_of_law(const Body<dim>   &body,
                      const State       &state,
                      const unsigned int node)
  {
    const double p = state.contact_pressure[node];
    return (p < 0. && body.scene.contact.rear_gap ?
              -*body.scene.contact.rear_gap :
              state.gap[node]) +
           body.law().penetration(p);
  }



#define INSTANTIATE(dim)                                       \
  template void   get_node_laws(const Body<dim> &,             \
                                const State &,                 \
                                std::vector<NodeLaw> &,        \
                                std::vector<double> &);        \
  template void   get_node_laws(const Body<dim> &,             \
                                const std::vector<double> &,   \
                                const std::vector<double> &,   \
                                std::vector<NodeLaw> &,        \
                                std::vector<double> &);        \
  template void   get_velocity_laws(const Body<dim> &,         \
                                    const State &,             \
                                    const std::vector<bool> &, \
                                    std::vector<NodeLaw> &);   \
  template double displacement_of_law(const Body<dim> &,       \
                                      const State &,           \
                                      const unsigned int)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
