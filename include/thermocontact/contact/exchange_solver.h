// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_exchange_solver_h
#define thermocontact_contact_exchange_solver_h

#include <thermocontact/contact/exchange_stage.h>
#include <thermocontact/contact/heat_exchange.h>
#include <thermocontact/contact/obstacle_action.h>
#include <thermocontact/method/bracketed_root.h>

#include <algorithm>
#include <vector>

namespace ThermoContact
{
  /**
   * Contact and a heat exchange that depends on gap and pressure, at once:
   * pressures by the contact law and fluxes $q_i=k_i(\theta_i-\theta_{obs})$
   * with $k_i=k(\mathrm{gap}_i,p_i)$, doc/contact-in-time.md (C5.2). For given
   * $k$ the fluxes are linear in the pressures and what is left is an
   * InterfaceProblem; so the unknowns are the $k_i$. Where $k$ jumps it takes
   * all values between its limits, and there is always a solution for one node.
   *
   * One node: from the given $k$ in the direction of the law to the first
   * change of sign, which is bracketed. Several: Newton's method, its steps
   * halved while the largest relative difference to the law does not fall;
   * where it stalls one sweep in which each node meets its law alone, and
   * again.
   *
   * @param response matrices $W$ and $H$ positive definite, but for positive
   *   scalings of their columns
   * @param laws of the nodes
   * @param contact in: values nearby, from which the search starts; out: the
   *   solution
   * @param flux out: of heat into the obstacle
   * @return number of linear systems of contact for the coefficients of the
   *   solution; 0 if all nodes are open
   * @throw ComputationError if no solution is found, or if $k$ is negative or
   *   not finite
   */
  unsigned int
  solve_contact_and_exchange(const HeatExchange         &exchange,
                             const EndResponse          &response,
                             const std::vector<NodeLaw> &laws,
                             ObstacleAction             &contact,
                             std::vector<double>        &flux);



  /** Says that the search of the coefficients of so many contact nodes has
   * failed, and what to try. @throw ComputationError always */
  [[noreturn]] void
  give_up_exchange(const unsigned int n_nodes);



  /**
   * The root of the excess of a coefficient over the law at its contact, from
   * @p k in the direction of the law to the first change of sign, which is
   * bracketed.
   *
   * @param excess not positive at 0, positive for large coefficients
   * @param n_nodes of the contact, for the message
   * @throw ComputationError if no change of sign is found
   */
  template <typename Excess>
  double
  coefficient_next_to(const double       k,
                      const Excess      &excess,
                      const unsigned int n_nodes)
  {
    double a = k, excess_a = excess(a);
    if (excess_a == 0.)
      return a;
    double stride = -excess_a;
    for (unsigned int n = 0; n < 200; ++n, stride *= 2.)
      {
        const double b        = std::max(0., a + stride);
        const double excess_b = excess(b);
        if (excess_b == 0.)
          return b;
        if ((excess_a < 0.) != (excess_b < 0.))
          return a < b ?
                   bracketed_root(excess, a, b, excess_a, excess_b).first :
                   bracketed_root(excess, b, a, excess_b, excess_a).first;
        a        = b;
        excess_a = excess_b;
      }
    give_up_exchange(n_nodes);
  }



  /**
   * The stage of a body so large that the responses of its nodes are not known,
   * for given coefficients.
   */
  class ExchangeOperator
  {
  public:
    virtual ~ExchangeOperator() = default;

    /** As ExchangeStage::law_at(). */
    virtual std::vector<double>
    law_at(const std::vector<double> &coefficient) = 0;
  };



  /**
   * solve_contact_and_exchange() for such a body: Newton's method with the
   * secants of the last steps in place of derivatives (Anderson 1965), halved
   * alike.
   *
   * @param tolerance of the coefficients, relative
   * @param coefficient in: nearby; out: of the last law_at()
   * @throw ComputationError if no solution is found
   */
  void
  solve_by_secants(ExchangeOperator    &stage,
                   const double         tolerance,
                   std::vector<double> &coefficient);
} // namespace ThermoContact

#endif
