// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_equilibrium_h
#define thermocontact_time_equilibrium_h

#include <thermocontact/contact/interface_law.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/contact_port.h>
#include <thermocontact/time/stage_solver.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The effect of forces on a body at one instant: $Ky+Np=r$ for all rows of
   * the displacement, with pressures of contact nodes that their laws give at
   * $x+c y_n$. With $K=bM_u$ y is an acceleration, or a change of the velocity
   * and p an impulse; with $K=(\zeta+1)S$ of a body without inertia it is a
   * displacement or, times velocity_factor(), a velocity. Factors and responses
   * are made when they are needed first, and kept.
   */
  template <int dim>
  class Equilibrium
  {
  public:
    enum class Matrix
    {
      inertia,   ///< $bM_u$; laws are rigid and hold their nodes
      stiffness, ///< of a body without inertia $(\zeta+1)S$, of a viscous
                 ///< rod, whose parts may differ, $\zeta S_\zeta$
      at_once ///< $S+a^2D^TM^{-1}D$ of a static body, which takes heat, (C4.4)
    };

    /**
     * @param body borrowed
     * @param counters of factors and solves; borrowed
     */
    Equilibrium(const Body<dim> &body,
                const Matrix     matrix,
                SolverCounters  &counters);

    /** Makes the parts that are kept and are not there yet. Collective. */
    void
    provide();

    /**
     * Where coefficients depend on the temperature: drops the parts that are
     * kept, and makes the next ones with the coefficients of this state.
     */
    void
    linearize(const State &state);

    /** Those of the body, or at the last state of linearize(). */
    const ThermoviscoelasticOperator<dim> &
    equations() const
    {
      return own_equations ? *own_equations : body.equations;
    }

    /** Of a viscous body: its velocity over the solution y of the stiffness. */
    double
    velocity_factor() const
    {
      const double viscosity = body.scene.material.viscosity;
      return dim == 1 ? 1. : (viscosity + 1.) / viscosity;
    }

    bool
    is_provided() const
    {
      return system != nullptr;
    }

    /**
     * @param forces $r$, constrained rows are zero; null: there are none
     * @param laws,position of the contact nodes, $x$; empty: no contact
     * @param factor $c$
     * @param y out; constrained entries are zero
     * @param pressure in: a guess; out: the solution
     * @throw ComputationError if K cannot be factorised or the pressures are
     *   not found
     */
    void
    solve(const Vector               *forces,
          const std::vector<NodeLaw> &laws,
          const std::vector<double>  &position,
          const double                factor,
          Vector                     &y,
          std::vector<double>        &pressure);

  private:
    const Body<dim> &body;
    const Matrix     matrix;

    const SystemCoefficients &
    coefficients() const;

    SolverCounters                 &counters;
    std::unique_ptr<Preconditioner> preconditioner; ///< or null

    /** Equations in the place of the body's; null: the body's are used. */
    std::unique_ptr<const ThermoviscoelasticOperator<dim>> own_equations;

    std::unique_ptr<LinearSystem<dim>> system;
    std::unique_ptr<ContactPort<dim>>  port;
  };
} // namespace ThermoContact

#endif
