// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_interface_problem_h
#define thermocontact_contact_interface_problem_h

#include <thermocontact/contact/interface_law.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Contact of nodes that influence each other, whatever their laws,
   * doc/contact-in-time.md (C2.4): $x=x^{free}-Wp$ with $p_i\in G_i(x_i)$. With
   * $r_i=W_{ii}$, $R=\mathrm{diag}(r)$ and Minty's $z=x+Rp$ it is one equation,
   * @f[
   *   z + (W-R)\,P(z) = x^{free},
   * @f]
   * well conditioned from rigid obstacles to none at all, which
   * solve_by_tangents() solves; for obstacles that are linear that is the
   * primal-dual active set method. One node: $p=P(x^{free})$, at once. No mesh,
   * no communication.
   */
  class InterfaceProblem
  {
  public:
    /**
     * @param receptance $W_{ij}$, loss of x of node i per unit pressure at node
     *   j; symmetric up to a positive scaling of its columns, positive definite
     * @param laws one for each node
     * @param free $x^{free}$, without pressure
     * @param pressure in: of a nearby problem, from which the search starts;
     *   out: the solution
     * @return number of linear systems; 1 for one node
     * @throw ComputationError if there is no solution to rounding. A NaN in
     *   @p free makes all pressures NaN
     */
    unsigned int
    solve(const dealii::FullMatrix<double> &receptance,
          const std::vector<NodeLaw>       &laws,
          const std::vector<double>        &free,
          std::vector<double>              &pressure);

    /** $P'$ of the nodes at the solution; 0 where they are open. */
    const std::vector<double> &
    slopes() const
    {
      return slopes_;
    }

    /** Of the laws there. */
    const std::vector<AffineLaw> &
    tangents() const
    {
      return tangents_;
    }

  private:
    std::vector<double>    z; ///< scratch
    std::vector<double>    slopes_;
    std::vector<AffineLaw> tangents_;
  };



  /**
   * How $z$ answers a small change of $x^{free}$ about a solution:
   * $(I+(W-R)D)\,\delta z=\delta x^{free}$ with the slopes $D$ of the laws; the
   * change of the pressures is $D\,\delta z$.
   *
   * @param change in: $\delta x^{free}$, a column for each of several; out:
   *   $\delta z$
   */
  void
  respond_to_change(const dealii::FullMatrix<double> &receptance,
                    const std::vector<double>        &slope,
                    dealii::FullMatrix<double>       &change);

  /** @p matrix times @p x. */
  std::vector<double>
  product(const dealii::FullMatrix<double> &matrix,
          const std::vector<double>        &x);

  /** The changes of the pressures for one change of $x^{free}$. */
  std::vector<double>
  change_of_pressure(const dealii::FullMatrix<double> &receptance,
                     const std::vector<double>        &slope,
                     const std::vector<double>        &free_change);



  /** A body as linear systems for nodes whose laws are straight lines. */
  class InterfaceOperator
  {
  public:
    virtual ~InterfaceOperator() = default;

    /**
     * @param laws of each node
     * @param is_last solve to the tolerance, not loosely
     * @param position,pressure out: of the nodes
     */
    virtual void
    solve(const std::vector<AffineLaw> &laws,
          const bool                    is_last,
          std::vector<double>          &position,
          std::vector<double>          &pressure) = 0;

    /**
     * W is known: systems are solved to rounding at once, and there is sweep().
     */
    virtual bool
    is_dense() const
    {
      return false;
    }

    /**
     * One node after the other meets its law beside the pressures of all
     * others, from @p pressure on.
     */
    virtual void
    sweep(const std::vector<NodeLaw> & /*laws*/,
          std::vector<double> & /*position*/,
          std::vector<double> & /*pressure*/)
    {}
  };



  /**
   * Contact of the nodes of a body, (C2.4): Newton's method (semismooth), in
   * whose step every law is its tangent at $z=x+rp$, doc/contact-in-time.md
   * (C2.9). Steps are halved while the pressures $P(z)$ do not come closer to
   * those of the body; a node whose tangent is its law to rounding keeps it.
   * Where W is known and the method stalls, one sweep in which each node meets
   * its law alone, which always lowers the convex energy
   * $\frac12p^TWp-p^Tx^{free}+\sum\Phi_i^*(p_i)$. Else after many steps one
   * node at a time changes (Murty 1974), which cannot cycle where laws are
   * piecewise linear.
   *
   * @param receptance $r$ of the nodes; where W is not known an estimate, which
   *   does not change the solution
   * @param rounding of $z$, as a part of the largest
   * @param position in: of laws in velocity, and where W is known, from which
   *   the search starts; out: the solution
   * @param pressure in: of a nearby problem; out: the solution. No obstacle
   *   pulls but for nodes that are held
   * @return number of linear systems with different laws
   * @throw ComputationError if they do not settle
   */
  unsigned int
  solve_by_tangents(InterfaceOperator          &body,
                    const std::vector<NodeLaw> &laws,
                    const std::vector<double>  &receptance,
                    const double                rounding,
                    std::vector<double>        &position,
                    std::vector<double>        &pressure);
} // namespace ThermoContact

#endif
