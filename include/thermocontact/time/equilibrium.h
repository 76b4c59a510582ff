// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_equilibrium_h
#define thermocontact_time_equilibrium_h

#include <thermocontact/contact/interface_law.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/linear_system.h>
#include <thermocontact/time/contact_port.h>
#include <thermocontact/time/stage_solver.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The effect of forces on a body at one instant: $Ky+Np=r$, with pressures of
   * contact nodes that their laws give at $x+c y_n$. With $K=bM_u$ y is an
   * acceleration, or a change of the velocity and p an impulse; with
   * $K=(\zeta+1)S$ of a body without inertia it is a displacement or, times
   * velocity_factor(), a velocity. The rows are all, or those of the contact
   * end, all other nodes being given. Factors and responses are made when they
   * are needed first, and kept. All of it is collective.
   */
  template <int dim>
  class Equilibrium
  {
  public:
    using Rows = typename LinearSystem<dim>::Rows;

    /**
     * @param body borrowed
     * @param coefficients K; with a heat block the body takes heat for the
     *   motion, (C4.4), if the motion heats it
     * @param counters of factors and solves; borrowed
     */
    Equilibrium(const Body<dim>          &body,
                const SystemCoefficients &coefficients,
                SolverCounters           &counters,
                const Rows                rows = Rows::all);

    /** Makes the parts that are kept and are not there yet. */
    void
    provide();

    /**
     * Where coefficients depend on the temperature: makes the parts that are
     * kept anew with the coefficients of this state.
     */
    void
    linearize(const State &state);

    bool
    is_provided() const
    {
      return system != nullptr;
    }

    /**
     * @param forces $r$, zero in rows that are constrained or not solved for
     * @param laws,position of the contact nodes, $x$; empty: no contact
     * @param factor $c$
     * @param y out; zero in such rows
     * @param pressure in: a guess; out: the solution
     * @throw ComputationError if K cannot be factorised or the pressures are
     *   not found
     */
    void
    solve(const Vector               &forces,
          const std::vector<NodeLaw> &laws,
          const std::vector<double>  &position,
          const double                factor,
          Vector                     &y,
          std::vector<double>        &pressure);

    /** ContactPort::solve_rates() of the last problem. */
    void
    solve_rates(const Vector                    &forces,
                const std::vector<double>       &rate,
                const std::vector<NodeLaw>      &laws,
                const std::vector<unsigned int> &closing,
                Vector                          &y);

    /**
     * Adds $-aM^{-1}D\,\delta u$, the temperature of a body that is deformed at
     * once, (C4.4); nothing where K takes no heat.
     */
    void
    add_heating(const Vector &change, Vector &temperature);

    /**
     * $X=K^{-1}\mathrm{diag}(w)$ of (C6.3), displacements of all nodes of the
     * end per unit pressure at those that have pressures, which come first.
     */
    FullMatrix<double>
    receptance();

  private:
    const Body<dim>                &body;
    const SystemCoefficients        coefficients;
    const Rows                      rows;
    SolverCounters                 &counters;
    std::unique_ptr<Preconditioner> preconditioner; ///< or null

    std::unique_ptr<LinearSystem<dim>> system;
    std::unique_ptr<ContactPort<dim>>  port;

    void
    keep(std::unique_ptr<LinearSystem<dim>> made);
  };



  /** A viscous body without inertia has $K=\zeta S_\zeta$: a rod, or one whose
   * viscosity is its own; others $(\zeta+1)S$. */
  template <int dim>
  bool
  moves_by_viscosity(const Body<dim> &body)
  {
    return body.scene.material.has_viscosity() &&
           (dim == 1 || body.scene.has_bodies());
  }

  /** K of a body without inertia. */
  template <int dim>
  const SystemCoefficients &
  motion_without_inertia(const Body<dim> &body)
  {
    return moves_by_viscosity(body) ? motion_by_viscosity : motion_by_stiffness;
  }

  /** Of a viscous body: its velocity over the solution y with that K. */
  template <int dim>
  double
  velocity_factor(const Body<dim> &body)
  {
    const double viscosity = body.scene.material.viscosity;
    return moves_by_viscosity(body) ? 1. : (viscosity + 1.) / viscosity;
  }
} // namespace ThermoContact

#endif
