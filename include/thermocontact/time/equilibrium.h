// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_equilibrium_h
#define thermocontact_time_equilibrium_h

#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/time/stage_solver.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * What forces do to a body at one instant: $Ky+Np=r$ for all rows of the
   * displacement, with pressures p of contact nodes that meet laws of $y_n$.
   * With $K=bM_u$ y is an acceleration, or a change of the velocity and p an
   * impulse; with $K=(\zeta+1)S$ of a body without inertia it is a displacement
   * or, times $(\zeta+1)/\zeta$, a velocity. Factors and responses are made
   * when they are needed first, and kept.
   */
  template <int dim>
  class Equilibrium
  {
  public:
    enum class Matrix
    {
      inertia,  ///< $bM_u$
      stiffness ///< $(\zeta+1)S$, of a body without inertia
    };

    /**
     * @param body borrowed; it has matrices
     * @param counters of what is made; borrowed
     */
    Equilibrium(const Body<dim> &body,
                const Matrix     matrix,
                SolverCounters  &counters);

    /** Makes what is not there yet. Collective. */
    void
    provide();

    /** $y=K^{-1}r$ without pressures; constrained entries are zero. */
    void
    solve(const Vector &forces, Vector &y);

    /**
     * Adds to y what the pressures do that it leads to.
     *
     * @param laws of the nodes, of some $x=$ @p factor $y_n$ + constant
     * @param free x without pressures
     * @param y in, out; null: not wanted
     * @param pressure in: a guess; out: the solution
     */
    void
    add_contact(const std::vector<NodeLaw> &laws,
                const std::vector<double>  &free,
                const double                factor,
                Vector                     *y,
                std::vector<double>        &pressure);

  private:
    const Body<dim>              &body;
    const Matrix                  kind;
    SolverCounters               &counters;
    std::unique_ptr<DirectSolver> factors;
    std::vector<Vector>           unit_responses; ///< to pressures
    FullMatrix<double>            receptance;     ///< of the contact nodes
  };
} // namespace ThermoContact

#endif
