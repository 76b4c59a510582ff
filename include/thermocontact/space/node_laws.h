// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_node_laws_h
#define thermocontact_space_node_laws_h

#include <thermocontact/contact/event_locator.h>
#include <thermocontact/contact/interface_law.h>
#include <thermocontact/space/body.h>

#include <vector>

namespace ThermoContact
{
  /**
   * The law of a contact node whose gap in front is @p gap.
   *
   * @param position in: its displacement; out: as below
   */
  NodeLaw
  make_node_law(const SceneContact &contact,
                const unsigned int  node,
                const double        gap,
                double             &position);

  /**
   * The laws of the contact nodes of a state, and their places: which of two
   * obstacles is local to each, the nearer one. Collective.
   *
   * @param laws out: one for each node; none is held or in velocity
   * @param position out: $u_n-g$ of a node whose local obstacle is in front,
   *   $u_n+g_2$ else, with the digits that the state has of it
   */
  template <int dim>
  void
  get_node_laws(const SceneContact    &contact,
                const ContactEnd<dim> &end,
                const State           &state,
                std::vector<NodeLaw>  &laws,
                std::vector<double>   &position);

  template <int dim>
  void
  get_node_laws(const Body<dim>      &body,
                const State          &state,
                std::vector<NodeLaw> &laws,
                std::vector<double>  &position)
  {
    get_node_laws(
      body.scene.contact, body.contact_end(), state, laws, position);
  }

  /** The same for nodes with these displacements before obstacles at @p gap. */
  void
  get_node_laws(const SceneContact        &contact,
                const std::vector<double> &gap,
                const std::vector<double> &displacement,
                std::vector<NodeLaw>      &laws,
                std::vector<double>       &position);

  /**
   * The same at the end of a stage of length @p tau that begins at @p known: x
   * is a position or, if any law has damping, a velocity relative to the local
   * obstacle, (C2.7).
   *
   * @param mode open: the nodes meet nothing; closed: they are held
   * @param held_at StageRates::held_at
   * @param start out: x if the velocity of the node is zero
   * @return growth of x per velocity of the node
   */
  template <int dim>
  double
  get_stage_laws(const Body<dim>        &body,
                 const State            &known,
                 const double            tau,
                 const ContactMode       mode,
                 const std::vector<int> &held_at,
                 std::vector<NodeLaw>   &laws,
                 std::vector<double>    &start);

  /**
   * The same for laws whose x is the velocity at one instant, of nodes on rigid
   * obstacles: nodes of @p is_closed cannot move into their local obstacle, and the others meet nothing.
   */
  template <int dim>
  void
  get_velocity_laws(const Body<dim>         &body,
                    const State             &state,
                    const std::vector<bool> &is_closed,
                    std::vector<NodeLaw>    &laws);

  /** Which obstacle holds each node: the one that is local at the start of a
   * step; empty if there is one alone. */
  template <int dim>
  void
  get_held_at(const Body<dim> &body, const State &state, std::vector<int> &at);

  /** False if the nodes are held by the obstacle behind them, which rests. */
  bool
  follow_motion(const std::vector<int> &held_at);

  /** The contact nodes of a state as events are found with. Collective. */
  template <int dim>
  void
  get_contact_values(const Body<dim> &body,
                     const State     &state,
                     ContactValues   &values);

  /** All contact nodes touch the obstacle that is local to them. Collective. */
  template <int dim>
  void
  put_on_obstacle(const Body<dim> &body, State &state);

  /** The displacement of a node whose pressure is that of its law at rest. */
  template <int dim>
  double
  displacement_of_law(const Body<dim>   &body,
                      const State       &state,
                      const unsigned int node);

  /**
   * The pressures become those of displacements and velocities, as the law
   * says; 0 where it says nothing, as for a rigid obstacle. Collective.
   *
   * @param is_held the nodes are as good as in contact
   */
  template <int dim>
  void
  set_pressures_of_law(const Body<dim> &body,
                       State           &state,
                       const bool       is_held = false);
} // namespace ThermoContact

#endif
