// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_conserving_contact_h
#define thermocontact_contact_conserving_contact_h

#include <thermocontact/contact/contact_law.h>
#include <thermocontact/contact/interface_problem.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * Contact of massless nodes in steps that conserve energy,
   * doc/contact-in-time.md section 6. At each time the nodes are in
   * equilibrium: with $s$ their local positions without contact and $X$ their
   * static receptance, the pressures $p(s)$ solve (C2.4) for $W=X$,
   * $x^{free}=s$. They are the gradient of a convex potential $V(s)$. No mesh,
   * no communication.
   */
  class ConservingContact
  {
  public:
    /**
     * @param law with a linear $s(p)$; borrowed
     * @param receptance $X_{ij}$, loss of displacement of node i per unit
     *   pressure at node j; symmetric up to a positive scaling of its columns,
     *   positive definite
     */
    ConservingContact(const ContactLaw                 &law,
                      const dealii::FullMatrix<double> &receptance);

    /**
     * Pressures at one time.
     *
     * @param pressure in: a guess; out: $p(s)$
     */
    void
    equilibrium(const std::vector<NodeLaw> &laws,
                const std::vector<double>  &s,
                std::vector<double>        &pressure);

    /**
     * The pressures of a step that moves the nodes from $s^0$ to
     * $s^1=A-2B\bar p$ and does the work $V(s^1)-V(s^0)$ on them,
     * $\bar p=\int_0^1 p(s^0+\xi(s^1-s^0))\,d\xi$, (C6.4). There is one
     * solution: for a node that of its law alone (Mean); for several by
     * Newton's method.
     *
     * @param start $s^0$
     * @param free_end $A$, the end for zero pressure
     * @param receptance $B$, positive semidefinite in the product of $X^{-1}$
     * @param displacement_scale size of the displacements and gaps whose
     *   differences the positions are, below the rounding of which Newton's
     *   method cannot go
     * @param pressure in: a guess; out: $\bar p$
     * @return number of iterations
     * @throw ComputationError if Newton's method does not converge
     */
    unsigned int
    step_pressure(const std::vector<NodeLaw>       &laws,
                  const std::vector<double>        &start,
                  const std::vector<double>        &free_end,
                  const dealii::FullMatrix<double> &receptance,
                  const double                      displacement_scale,
                  std::vector<double>              &pressure);

  private:
    const dealii::FullMatrix<double> static_receptance;
    InterfaceProblem                 problem;

    /** Of one node, with what the body yields under it. */
    const std::unique_ptr<const ContactLaw> law_of_node;

    /**
     * Mean of $p$ on the way from @p start to @p end, exact on each stretch on
     * which no node changes its branch.
     *
     * @param derivative out: with respect to @p end
     */
    void
    mean_pressure(const std::vector<NodeLaw> &laws,
                  const std::vector<double>  &start,
                  const std::vector<double>  &end,
                  std::vector<double>        &mean,
                  dealii::FullMatrix<double> &derivative);
  };
} // namespace ThermoContact

#endif
