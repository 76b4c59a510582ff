// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_contact_equilibrium_h
#define thermocontact_time_contact_equilibrium_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <deal.II/lac/full_matrix.h>

namespace ThermoContact
{
  /** $S_{NN}$, the stiffness between all nodes of the contact end. */
  template <int dim>
  FullMatrix<double>
  contact_stiffness(const Body<dim> &body);

  /**
   * $X=K^{-1}\mathrm{diag}(w)$ of (M.39), displacements of all nodes of the
   * contact end per unit pressure at those that have pressures.
   *
   * @param flexibility $K^{-1}$, the inverse of a stiffness between all nodes
   */
  template <int dim>
  FullMatrix<double>
  contact_receptance(const ContactEnd<dim>    &end,
                     const FullMatrix<double> &flexibility);

  /** The rows of a receptance of the nodes that have pressures. */
  FullMatrix<double>
  between_pressures(const FullMatrix<double> &receptance);

  /**
   * Puts contact nodes without mass and viscosity into equilibrium with the
   * rest of the body, its temperature, the loads and the obstacle, doc/model.md
   * (M.38), and gives them velocities that keep them there, (M.64): all nodes
   * together, with those of the other nodes, temperature and loads as they are.
   */
  template <int dim>
  void
  settle_contact_nodes(Body<dim> &body, State &state);

  /**
   * The same where loads have jumped: the nodes move at once, all else stays,
   * and the body takes heat for it, (M.67).
   *
   * @param body that has no matrices
   * @return the way of the nodes; zero at all others
   * @throw ComputationError if the equilibrium is not found
   */
  template <int dim>
  Vector
  move_contact_nodes(Body<dim> &body, State &state);

  /**
   * Velocities and pressures of contact nodes without mass, with viscosity, at
   * a rigid obstacle, that go with displacements, temperatures and the
   * velocities of all other nodes, doc/model.md (M.63): no node in contact
   * moves into the obstacle, and those with pressure rest.
   *
   * @param stiffness of contact_stiffness(); not used by a body without matrices
   * @param is_closed nodes in contact; others have no pressure
   */
  template <int dim>
  void
  settle_contact_velocities(Body<dim>                &body,
                            const FullMatrix<double> &stiffness,
                            const std::vector<bool>  &is_closed,
                            State                    &state);
} // namespace ThermoContact

#endif
