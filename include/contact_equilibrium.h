// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_equilibrium_h
#define thermocontact_contact_equilibrium_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

#include "contact_law.h"
#include "contact_solver.h"
#include "discretization.h"
#include "loads.h"
#include "state.h"
#include "thermoviscoelastic_operator.h"

namespace ThermoContact
{
  /** $S_{NN}$, the stiffness between the contact nodes. */
  template <int dim>
  FullMatrix<double>
  contact_stiffness(const Discretization<dim>             &discretization,
                    const ThermoviscoelasticOperator<dim> &stage_operator);

  /**
   * $X=K^{-1}\mathrm{diag}(w)$ of (M.41), displacements of the contact nodes
   * per unit pressure, from a stiffness $K$ between them.
   */
  template <int dim>
  FullMatrix<double>
  contact_receptance(const Discretization<dim> &discretization,
                     const FullMatrix<double>  &stiffness);

  /**
   * Contact nodes without mass and viscosity, which at every time are in
   * equilibrium with the rest of the body and the obstacle, doc/model.md
   * (M.40).
   */
  template <int dim>
  class ContactEquilibrium
  {
  public:
    /** The references are borrowed. */
    ContactEquilibrium(const Discretization<dim>             &discretization,
                       const ThermoviscoelasticOperator<dim> &stage_operator,
                       const ContactLaw                      &law);

    /**
     * Puts the nodes of @p state into equilibrium at its temperature and gives
     * them the velocity with which they stay there.
     *
     * @param momentum_load at the time of @p state
     * @param mode unilateral: the contact law; open, closed: one of its
     *   branches, with pressures of either sign
     */
    void
    settle(const Vector     &momentum_load,
           const ContactMode mode,
           State            &state) const;

  private:
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &stage_operator;
    const ContactLaw                       law;
    const ContactSolver                    contact_solver;
    const FullMatrix<double>               receptance;

    /** @p values of the nodes plus the displacement by forces on them. */
    std::vector<double>
    moved_by(const Vector &force, const Vector &values) const;
  };


  /** Settles the nodes of a state with the loads at its time. */
  template <int dim>
  void
  settle_contact_nodes(const Discretization<dim>             &discretization,
                       const ThermoviscoelasticOperator<dim> &stage_operator,
                       const ContactLaw                      &law,
                       Loads<dim>                            &loads,
                       State                                 &state);
} // namespace ThermoContact

#endif
