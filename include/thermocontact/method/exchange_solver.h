// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_exchange_solver_h
#define thermocontact_method_exchange_solver_h

#include <thermocontact/method/contact_law.h>
#include <thermocontact/method/exchange_stage.h>
#include <thermocontact/method/heat_exchange.h>

#include <vector>

namespace ThermoContact
{
  /** Pressure, heat flux into the obstacle and $k$ of each contact node. */
  struct EndExchange
  {
    std::vector<double> pressure;
    std::vector<double> flux;
    std::vector<double> coefficient;
  };



  /**
   * Contact and a heat exchange that depends on gap and pressure, at once:
   * pressures by the contact law and fluxes $q_i=k_i(\theta_i-\theta_{obs})$
   * with $k_i=k(\mathrm{gap}_i,p_i)$, doc/model.md (M.57). For given $k$ the
   * fluxes are linear in the pressures and what is left is ContactSolver's
   * problem; so the unknowns are the $k_i$. Where $k$ jumps it takes all values
   * between its limits, and there is always a solution for one node.
   *
   * One node: from the given $k$ in the direction of the law to the first
   * change of sign, which is bracketed. Several: Newton's method with damping;
   * where it fails, as at jumps, bisection of all nodes at once, and, of up to
   * 32, node by node.
   */
  class ExchangeSolver
  {
  public:
    /** Both laws are borrowed. */
    ExchangeSolver(const ContactLaw &law, const HeatExchange &exchange);

    /**
     * @param response matrices $W$ and $H$ positive definite, but for positive
     *   scalings of their columns
     * @param mode the contact law or one of its branches; a node that is held
     *   closed has no gap
     * @param end in: pressures and coefficients nearby, from which the search
     *   starts; out: the solution
     * @param is_held nodes that stay closed, as for ContactSolver::solve()
     * @param motion without contact and fluxes, with all nodes held in mode
     *   closed; with a damped obstacle
     * @return number of linear problems that ContactSolver solved on active
     *   sets for the coefficients of the solution; 0 if no node is pushed back,
     *   and in modes open and closed
     * @throw ComputationError if there is none, or if $k$ is negative or not
     *   finite
     */
    unsigned int
    solve(const EndResponse       &response,
          const ContactMode        mode,
          EndExchange             &end,
          const std::vector<bool> &is_held = {},
          const NodesInMotion     &motion  = {}) const;

  private:
    const ContactLaw   &law;
    const HeatExchange &exchange;
  };
} // namespace ThermoContact

#endif
