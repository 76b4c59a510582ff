// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_equilibrium_h
#define thermocontact_time_equilibrium_h

#include <thermocontact/contact/interface_law.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_solver.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * What forces do to a body at one instant: $Ky+Np=r$ for all rows of the
   * displacement, with pressures of contact nodes that their laws give at $x+c
   * y_n$. With $K=bM_u$ y is an acceleration, or a change of the velocity and p
   * an impulse; with $K=(\zeta+1)S$ of a body without inertia it is a
   * displacement or, times $(\zeta+1)/\zeta$, a velocity. Factors and responses
   * are made when they are needed first, and kept.
   */
  template <int dim>
  class Equilibrium
  {
  public:
    enum class Matrix
    {
      inertia,  ///< $bM_u$; laws are rigid and hold their nodes
      stiffness ///< $(\zeta+1)S$, of a body without inertia
    };

    virtual ~Equilibrium() = default;

    /** Makes what is kept and is not there yet. Collective. */
    virtual void
    provide() = 0;

    virtual bool
    is_provided() const = 0;

    /**
     * @param forces $r$, constrained rows are zero; null: there are none
     * @param laws,position of the contact nodes, $x$; empty: no contact
     * @param factor $c$
     * @param y out; constrained entries are zero
     * @param pressure in: a guess; out: the solution
     * @throw ComputationError if K cannot be factorised or the pressures are
     *   not found
     */
    virtual void
    solve(const Vector               *forces,
          const std::vector<NodeLaw> &laws,
          const std::vector<double>  &position,
          const double                factor,
          Vector                     &y,
          std::vector<double>        &pressure) = 0;

    /** What the user is to know since the last call. */
    virtual std::vector<std::string>
    take_warnings()
    {
      return {};
    }
  };



  /**
   * @param body borrowed
   * @param counters of what is made; borrowed
   */
  template <int dim>
  std::unique_ptr<Equilibrium<dim>>
  make_equilibrium(const Body<dim>                        &body,
                   const typename Equilibrium<dim>::Matrix matrix,
                   SolverCounters                         &counters);
} // namespace ThermoContact

#endif
