// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_contact_solver_h
#define thermocontact_method_contact_solver_h

#include <thermocontact/method/contact_law.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Exact contact of several nodes that influence each other: the linear
   * complementarity problem doc/model.md (M.18)
   * @f[
   *   p \ge 0, \quad s = g - u^{free} + (W + \varepsilon I) p \ge 0, \quad
   *   p_i s_i = 0 .
   * @f]
   * The primal-dual active set method (= semismooth Newton) solves it in a few
   * iterations. It may cycle in theory; past a limit the least-index rule of
   * Murty changes one node at a time, which ends for every P-matrix, and
   * $W+\varepsilon I$ is one. No mesh, no communication.
   */
  class ContactSolver
  {
  public:
    explicit ContactSolver(const ContactLaw &law);

    /**
     * Computes the pressures.
     *
     * @param response $W_{ij}$, loss of displacement of node i per unit
     *   pressure at node j; symmetric up to a positive scaling of its columns,
     *   positive definite
     * @param free_displacement normal displacement of the nodes without contact
     * @param pressure in: of a nearby problem, which starts the search; out:
     *   the solution, one value per node
     * @return number of linear problems solved on active sets
     * @throw ComputationError if no active set solves the problem
     */
    unsigned int
    solve(const dealii::FullMatrix<double> &response,
          const std::vector<double>        &free_displacement,
          std::vector<double>              &pressure) const;

    /**
     * Contact that cannot open: pressures of either sign with $s=0$ at all
     * nodes, $(W+\varepsilon I)p=u^{free}-g$.
     *
     * @param response,free_displacement as for solve()
     * @param pressure out: one value per node
     */
    void
    solve_closed(const dealii::FullMatrix<double> &response,
                 const std::vector<double>        &free_displacement,
                 std::vector<double>              &pressure) const;

  private:
    const ContactLaw law;

    void
    solve_on_active_set(const dealii::FullMatrix<double> &response,
                        const std::vector<double>        &free_displacement,
                        const std::vector<bool>          &is_active,
                        std::vector<double>              &pressure) const;
  };
} // namespace ThermoContact

#endif
