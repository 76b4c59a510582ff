// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/node_laws.h>

namespace ThermoContact
{
  template <int dim>
  void
  get_node_laws(const Body<dim>           &body,
                const std::vector<double> &gap,
                const std::vector<double> &displacement,
                std::vector<NodeLaw>      &laws,
                std::vector<double>       &position)
  {
    const double rear_gap = body.scene.contact.rear_gap;
    laws.assign(gap.size(), NodeLaw(body.law()));
    position.resize(gap.size());
    for (unsigned int i = 0; i < gap.size(); ++i)
      {
        const double u = displacement[i]; // may be position[i]
        position[i]    = u - gap[i];
        laws[i].play   = gap[i] + rear_gap;
        if (laws[i].nearer_side(position[i]) > 0)
          continue;
        laws[i].side = -1;
        position[i]  = u + rear_gap;
      }
  }



  template <int dim>
  void
  get_node_laws(const Body<dim>      &body,
                const State          &state,
                std::vector<NodeLaw> &laws,
                std::vector<double>  &position)
  {
    std::vector<double> &displacement = position; // so far
    body.contact_end().get_values(Field::displacement,
                                  state.displacement,
                                  displacement);
    get_node_laws(body, state.gap, displacement, laws, position);
    for (unsigned int i = 0; i < state.gap_rate.size(); ++i)
      laws[i].front_rate = state.gap_rate[i];
    for (unsigned int i = 0; i < state.known_penetration.size(); ++i)
      if (laws[i].side > 0)
        position[i] = state.known_penetration[i];
  }



  template <int dim>
  double
  get_stage_laws(const Body<dim>        &body,
                 const State            &known,
                 const double            tau,
                 const ContactMode       mode,
                 const std::vector<int> &held_at,
                 std::vector<NodeLaw>   &laws,
                 std::vector<double>    &start)
  {
    const bool is_in_velocity = body.law().damping() > 0.;
    get_node_laws(body, known, laws, start);
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        NodeLaw &law = laws[i];
        if (!held_at.empty() && held_at[i] != law.side)
          start[i] = law.change_side(start[i]);
        law.is_held = mode == ContactMode::closed;
        if (mode == ContactMode::open)
          law.law = nullptr;
        if (!is_in_velocity)
          continue;
        // as the obstacle sees it, which has moved to the end of the stage
        law.is_in_velocity = true;
        law.start          = start[i] + tau * law.local_rate();
        law.tau            = tau;
        start[i]           = 0. - law.local_rate();
      }
    return is_in_velocity ? 1. : tau;
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
  obstacle_at(const Body<dim>           &body,
              const std::vector<double> &gap,
              const unsigned int         node,
              const int                  side)
  {
    return side > 0 ? gap[node] : -body.scene.contact.rear_gap;
  }



  template <int dim>
  void
  put_on_obstacle(const Body<dim> &body, State &state)
  {
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::displacement))
      state.displacement.begin()[entry] =
        obstacle_at(body, state.gap, node, laws[node].side);
  }



  template <int dim>
  double
  displacement_of_law(const Body<dim>   &body,
                      const State       &state,
                      const unsigned int node)
  {
    const double p = state.contact_pressure[node];
    return obstacle_at(body, state.gap, node, p < 0. ? -1 : 1) +
           body.law().penetration(p);
  }



  template <int dim>
  void
  set_pressures_of_law(const Body<dim> &body, State &state)
  {
    std::vector<NodeLaw> laws;
    std::vector<double>  position, velocity;
    get_node_laws(body, state, laws, position);
    body.contact_end().get_values(Field::displacement,
                                  state.velocity,
                                  velocity);
    for (unsigned int i = 0; i < laws.size(); ++i)
      state.contact_pressure[i] = laws[i].pressure_at(position[i], velocity[i]);
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
  template double get_stage_laws(const Body<dim> &,            \
                                 const State &,                \
                                 const double,                 \
                                 const ContactMode,            \
                                 const std::vector<int> &,     \
                                 std::vector<NodeLaw> &,       \
                                 std::vector<double> &);       \
  template void   get_velocity_laws(const Body<dim> &,         \
                                    const State &,             \
                                    const std::vector<bool> &, \
                                    std::vector<NodeLaw> &);   \
  template double obstacle_at(const Body<dim> &,               \
                              const std::vector<double> &,     \
                              const unsigned int,              \
                              const int);                      \
  template void   put_on_obstacle(const Body<dim> &, State &); \
  template double displacement_of_law(const Body<dim> &,       \
                                      const State &,           \
                                      const unsigned int);     \
  template void   set_pressures_of_law(const Body<dim> &, State &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
