// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_contact_solver_h
#define thermocontact_method_contact_solver_h

#include <thermocontact/method/contact_law.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Exact contact of several nodes that influence each other: the
   * complementarity problem doc/model.md (M.18)
   * @f[
   *   p_i \ge 0, \quad r_i = s(p_i) + (Wp)_i - s^{free}_i \ge 0, \quad
   *   p_i r_i = 0
   * @f]
   * with the law $s(p)$ of each node. The primal-dual active set method
   * (= semismooth Newton) solves it in a few iterations. With a linear law it
   * may cycle in theory; past a limit the least-index rule of Murty changes one
   * node at a time, which ends for every P-matrix, and $W+s'$ is one. Laws
   * whose contact begins without stiffness are solved for the penetrations
   * instead, (M.70), since their $s'(0)$ is infinite. Between two stops the
   * margin $r$ of a node has an upper bound as well, where the other stop pulls
   * the pressure below zero, (M.114): nodes are open or at one of both. No
   * mesh, no communication.
   */
  class ContactSolver
  {
  public:
    /** The law is borrowed. */
    explicit ContactSolver(const ContactLaw &law);

    /**
     * Computes the pressures.
     *
     * @param response $W_{ij}$, loss of displacement of node i per unit
     *   pressure at node j; symmetric up to a positive scaling of its columns,
     *   positive definite
     * @param free_penetration $s^{free}$ of the nodes, without contact
     * @param pressure in: of a nearby problem, which starts the search; out:
     *   the solution, one value per node
     * @param is_held nodes that stay closed, with pressures of either sign;
     *   empty: none
     * @param far_penetration those at a second stop on the other side, without
     *   contact; the pressures there are negative. Empty: there is none
     * @return number of linear problems solved on active sets
     * @throw ComputationError if no active set solves the problem
     */
    unsigned int
    solve(const dealii::FullMatrix<double> &response,
          const std::vector<double>        &free_penetration,
          std::vector<double>              &pressure,
          const std::vector<bool>          &is_held         = {},
          const std::vector<double>        &far_penetration = {}) const;

    /**
     * Contact that cannot open: pressures of either sign with $r=0$ at all
     * nodes.
     *
     * @param response,free_penetration,pressure as for solve()
     * @return,@throw as solve()
     */
    unsigned int
    solve_closed(const dealii::FullMatrix<double> &response,
                 const std::vector<double>        &free_penetration,
                 std::vector<double>              &pressure) const;

    /**
     * A small change about a solution, with the set of nodes in contact held:
     * $(W+s'(p))\,\delta p=\delta s^{free}$ there, $\delta p=0$ elsewhere.
     *
     * @param response as for solve()
     * @param pressure of the solution
     * @param is_active the set
     * @param free_change $\delta s^{free}$
     * @return $\delta p$
     */
    std::vector<double>
    solve_linearized(const dealii::FullMatrix<double> &response,
                     const std::vector<double>        &pressure,
                     const std::vector<bool>          &is_active,
                     const std::vector<double>        &free_change) const;

  private:
    const ContactLaw &law;

    /** The problem of solve(). */
    struct Problem
    {
      const dealii::FullMatrix<double> &response;
      const std::vector<double>        &free_penetration;
      const std::vector<double>        &far_penetration; ///< may be empty
      const std::vector<bool>          &is_held;
    };

    /** True if the tangent is infinite without pressure. */
    bool
    begins_without_stiffness() const;

    /** The pressure of one node alone. */
    double
    pressure_of_node(const Problem &problem) const;

    /** As solve(), by solve_nodal_contact() for the penetrations. */
    unsigned int
    solve_for_penetrations(const Problem       &problem,
                           std::vector<double> &pressure) const;

    /**
     * Newton's step for $r=0$ at the nodes of a set; $p=0$ elsewhere.
     *
     * @param free_penetration at the stop that a node of the set is at, seen
     *   from the front one
     */
    void
    solve_on_active_set(const dealii::FullMatrix<double> &response,
                        const std::vector<double>        &free_penetration,
                        const std::vector<bool>          &is_active,
                        std::vector<double>              &pressure) const;

    /** The penetrations without contact that nodes at a stop start from. */
    std::vector<double>
    free_of_set(const Problem &problem, const std::vector<bool> &is_far) const;

    /**
     * Moves nodes between the sets where their pressure or penetration has the
     * wrong sign.
     *
     * @param only_the_first change one node
     * @param is_far nodes of the set that are at the second stop
     * @return true if @p pressure is not a solution yet
     */
    bool
    update_active_set(const Problem             &problem,
                      const std::vector<double> &pressure,
                      const bool                 only_the_first,
                      std::vector<bool>         &is_active,
                      std::vector<bool>         &is_far) const;
  };
} // namespace ThermoContact

#endif
