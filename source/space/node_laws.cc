// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/node_laws.h>

namespace ThermoContact
{
  NodeLaw
  make_node_law(const SceneContact &contact,
                const unsigned int  node,
                const double        gap,
                double             &position)
  {
    const double u = position, rear_gap = contact.rear_gap_at(node);
    NodeLaw      law(contact.law_at(node));
    law.rear_law = contact.rear_law.get();
    law.play     = gap + rear_gap;
    position     = u - gap;
    if (law.penetration_slope(position) < 0)
      {
        law.side = -1;
        position = u + rear_gap;
      }
    return law;
  }



  void
  get_node_laws(const SceneContact        &contact,
                const std::vector<double> &gap,
                const std::vector<double> &displacement,
                std::vector<NodeLaw>      &laws,
                std::vector<double>       &position)
  {
    laws.resize(gap.size());
    position = displacement;
    for (unsigned int i = 0; i < gap.size(); ++i)
      laws[i] = make_node_law(contact, i, gap[i], position[i]);
  }



  template <int dim>
  void
  get_node_laws(const SceneContact    &contact,
                const ContactEnd<dim> &end,
                const State           &state,
                std::vector<NodeLaw>  &laws,
                std::vector<double>   &position)
  {
    std::vector<double> &displacement = position; // so far
    end.get_values(Field::displacement, state.displacement, displacement);
    get_node_laws(contact, state.gap, displacement, laws, position);
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
    const bool is_in_velocity = body.scene.contact.is_damped();
    get_node_laws(body, known, laws, start);
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        NodeLaw &law = laws[i];
        if (!held_at.empty())
          start[i] = law.face(held_at[i], start[i]);
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
  void
  get_held_at(const Body<dim> &body, const State &state, std::vector<int> &at)
  {
    at.clear();
    if (!body.scene.contact.is_two_sided())
      return;
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    for (const NodeLaw &law : laws)
      at.push_back(law.side);
  }



  bool
  follow_motion(const std::vector<int> &held_at)
  {
    return held_at.empty() || held_at.front() > 0;
  }



  template <int dim>
  void
  get_contact_values(const Body<dim> &body,
                     const State     &state,
                     ContactValues   &values)
  {
    const SceneContact    &contact = body.scene.contact;
    const ContactEnd<dim> &end     = body.contact_end();
    const unsigned int     n       = end.n_nodes();
    ContactValues::Side   &front = values.front, &rear = values.rear;
    values.time = state.time;
    end.get_values(Field::displacement,
                   state.displacement,
                   values.displacement);
    if (state.contact_velocity.empty())
      end.get_values(Field::displacement, state.velocity, front.velocity);
    else
      front.velocity = state.contact_velocity;
    front.penetration.resize(n);
    rear.penetration.resize(n);
    rear.velocity.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double u       = values.displacement[i];
        rear.velocity[i]     = -front.velocity[i]; // it rests
        rear.penetration[i]  = -u - contact.rear_gap_at(i);
        front.velocity[i]    = front.velocity[i] - state.gap_rate[i];
        front.penetration[i] = state.known_penetration.empty() ?
                                 u - state.gap[i] :
                                 state.known_penetration[i];
      }
    values.pressure = state.contact.pressure;
    if (!contact.is_damped())
      return;
    for (unsigned int i = 0; i < n; ++i)
      {
        double        position = values.displacement[i];
        const NodeLaw law = make_node_law(contact, i, state.gap[i], position);
        // it is left where the penetration ends
        if (law.local().can_be_silent())
          values.pressure[i] = law.continued_pressure(position);
      }
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
      if (body.contact_end().nodes()[node].has_partner(Field::displacement))
        body.contact_end().add_to_value(Field::displacement,
                                        node,
                                        0. - position[node],
                                        state.displacement);
      else
        state.displacement.begin()[entry] =
          body.scene.contact.place(laws[node].side, node, state.gap[node]);
  }



  template <int dim>
  double
  displacement_of_law(const Body<dim>   &body,
                      const State       &state,
                      const unsigned int node)
  {
    const SceneContact &contact = body.scene.contact;
    const double        p       = state.contact.pressure[node];
    return contact.place(p < 0. ? -1 : 1, node, state.gap[node]) +
           contact.law_under(p, node).penetration(p);
  }



  template <int dim>
  void
  set_pressures_of_law(const Body<dim> &body, State &state, const bool is_held)
  {
    std::vector<NodeLaw> laws;
    std::vector<double>  position, velocity;
    get_node_laws(body, state, laws, position);
    body.contact_end().get_values(Field::displacement,
                                  state.velocity,
                                  velocity);
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        laws[i].is_held = is_held;
        // waves change the velocity of an end at a dashpot in the next step
        state.contact.pressure[i] =
          body.scene.has_midpoint_mass && body.scene.contact.has_dashpot() ?
            laws[i].elastic_pressure(position[i]) :
            laws[i].pressure_at(position[i], velocity[i]);
      }
  }



#define INSTANTIATE(dim)                                       \
  template void   get_node_laws(const SceneContact &,          \
                                const ContactEnd<dim> &,       \
                                const State &,                 \
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
  template void   get_held_at(const Body<dim> &,               \
                              const State &,                   \
                              std::vector<int> &);             \
  template void   get_contact_values(const Body<dim> &,        \
                                     const State &,            \
                                     ContactValues &);         \
  template void   put_on_obstacle(const Body<dim> &, State &); \
  template double displacement_of_law(const Body<dim> &,       \
                                      const State &,           \
                                      const unsigned int);     \
  template void   set_pressures_of_law(const Body<dim> &, State &, const bool)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
