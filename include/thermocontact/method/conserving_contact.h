// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_conserving_contact_h
#define thermocontact_method_conserving_contact_h

#include <thermocontact/method/contact_law.h>
#include <thermocontact/method/contact_solver.h>
#include <thermocontact/method/two_stops.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace ThermoContact
{
  /** Contact nodes before a stop and, if there is one, before a second one. */
  struct NodesBeforeStops
  {
    std::vector<double> front; ///< $s$
    std::vector<double> rear;  ///< $s_2$, which falls as $s$ grows; or empty

    /** Of these, or of where they go, at the stop that is nearer to these. */
    double
    at_nearer_stop(const NodesBeforeStops &seen, const unsigned int node) const
    {
      return is_nearer_to_rear(node) ? seen.rear[node] : seen.front[node];
    }

    bool
    is_nearer_to_rear(const unsigned int node) const
    {
      return !rear.empty() && nearer_stop(front[node], rear[node]) < 0;
    }

    /** Some way on to others. */
    NodesBeforeStops
    on_way_to(const NodesBeforeStops &end, const double part) const;
  };



  /**
   * Contact of massless nodes in steps that conserve energy, doc/model.md
   * section 13. At each time the nodes are in equilibrium: with $s$ their
   * penetrations without contact and $X$ their static receptance, the pressures
   * $p(s)$ solve (M.18) for $W=X$, $s^{free}=s$, between two stops (M.114).
   * They are the gradient of a convex potential $V(s)$. No mesh, no
   * communication.
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
    equilibrium(const NodesBeforeStops &s, std::vector<double> &pressure) const;

    /**
     * The pressures of a step that moves the nodes from $s^0$ to
     * $s^1=A-2B\bar p$ and does the work $V(s^1)-V(s^0)$ on them,
     * $\bar p=\int_0^1 p(s^0+\xi(s^1-s^0))\,d\xi$, (M.40). There is one
     * solution: for a node in closed form, each branch a quadratic; for several
     * by Newton's method.
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
    step_pressure(const NodesBeforeStops           &start,
                  const NodesBeforeStops           &free_end,
                  const dealii::FullMatrix<double> &receptance,
                  const double                      displacement_scale,
                  std::vector<double>              &pressure) const;

  private:
    const ContactLaw                &law;
    const dealii::FullMatrix<double> static_receptance;
    const ContactSolver              contact_solver;

    /** One node at one stop. */
    double
    step_pressure_of_node(const double start,
                          const double free_end,
                          const double receptance) const;

    /** One node at the nearer of its stops, or on its way to the other. */
    double
    step_pressure_of_node(const double near_start,
                          const double near_end,
                          const double receptance,
                          const double far_start,
                          const double far_end) const;

    double
    step_pressure_of_node(const NodesBeforeStops &start,
                          const NodesBeforeStops &free_end,
                          const double            receptance) const;

    /** Pressures $p$ on a part of the way where the set stays the same. */
    struct Stretch
    {
      std::vector<bool>      is_active;
      std::vector<bool>      is_rear; ///< of the set, at the second stop
      NodesBeforeStops       begin;
      dealii::Vector<double> slope; ///< of $s$
      dealii::Vector<double> p;     ///< at the beginning
      dealii::Vector<double> change;
    };

    /**
     * How far along the way the set of nodes in contact stays the same: to
     * where a pressure, or the margin $r$ of (M.18), vanishes.
     *
     * @param peep smallest distance
     */
    double
    distance_to_change(const Stretch &stretch, const double peep) const;

    /**
     * Mean of $p$ on the way from @p start to @p end, exact on each stretch
     * with the same nodes in contact.
     *
     * @param derivative out: with respect to @p end
     */
    void
    mean_pressure(const NodesBeforeStops     &start,
                  const NodesBeforeStops     &end,
                  std::vector<double>        &mean,
                  dealii::FullMatrix<double> &derivative) const;
  };
} // namespace ThermoContact

#endif
