// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_reset_h
#define thermocontact_simulation_reset_h

#include <thermocontact/contact/event_locator.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>
#include <thermocontact/time/equilibrium.h>
#include <thermocontact/time/time_integrator.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /** What a reset costs, per unit cross-section. */
  struct ResetCost
  {
    double impulse               = 0.;
    double work                  = 0.; ///< of an obstacle that moves
    double numerical_dissipation = 0.;

    ResetCost &
    operator+=(const ResetCost &other)
    {
      impulse += other.impulse;
      work += other.work;
      numerical_dissipation += other.numerical_dissipation;
      return *this;
    }
  };



  /**
   * The reset map $x^+=R(x^-)$ of the hybrid system: what a state becomes where
   * contact begins or ends, where inputs have a discontinuity, and at the
   * start. Everywhere forces are in equilibrium, $Ky+Np=r$, with the laws of
   * the contact nodes; what y is follows from the order of the equation at the
   * nodes: an impulse changes the velocity of inertial ones, viscous ones get a
   * velocity, static ones a place.
   */
  template <int dim>
  class Reset
  {
  public:
    /** @param body borrowed */
    explicit Reset(Body<dim> &body);

    /**
     * Completes the state of a body without inertia, doc/model.md section 12:
     * with viscosity the velocity follows from the displacement, (M.34);
     * without, the displacement is in equilibrium with the temperature, (M.35),
     * and the velocity, which has no value yet, is left at zero.
     *
     * @param state in: temperature and, with viscosity, displacement and
     *   pressure of the compliance law
     * @param is_closed with viscosity, at a rigid obstacle: the nodes in
     *   contact; empty: those that do not lie before it
     * @throw ComputationError if the stiffness matrix cannot be factorised or
     *   the contact nodes do not settle
     */
    void
    complete(State &state, const std::vector<bool> &is_closed = {});

    /**
     * Impact of all contact nodes on a rigid obstacle: they are put on it, and
     * an impulse through the mass matrix takes their velocity into it away, so
     * that the velocity jumps to the nearest one, in the norm of the kinetic
     * energy, with which they stay there (M.33). Nodes without mass need no
     * impulse.
     *
     * @param energy out: of the new state
     * @param cost what the impact costs is added
     * @throw ComputationError if the mass matrix cannot be factorised
     */
    void
    impact(State &state, EnergyTerms &energy, ResetCost &cost);

    /**
     * Pressures and velocities at the end of a step within which nodes without
     * mass closed at a rigid obstacle: those of the stages stand for the jump
     * of the velocity there and have its impulse, (M.63).
     */
    void
    settle_closed_nodes(StepResult &result);

    /**
     * The pressures become those with which nodes with mass that a rigid
     * obstacle holds have its acceleration, (M.112): those of the last stage
     * are of first order only. The heat exchange becomes that of them.
     *
     * @throw ComputationError if the mass matrix cannot be factorised
     */
    void
    set_pressures_of_acceleration(State &state);

    /**
     * The pressures of a damped obstacle whose velocity has jumped, (M.82): a
     * body with inertia goes on as it was, one without it gets the velocity of
     * (M.34). Not of a body that is in equilibrium at all times: its pressures
     * do not jump, the velocity does by which it follows.
     */
    void
    set_pressures_of_velocity(State &state);

    /**
     * Pressures of a step that is accepted: none pulls, and where contact
     * begins they are those of the law, since no stage has seen them. So is the
     * heat exchange, where contact ends as well.
     *
     * @param mode of the step
     * @param finding at its end
     */
    void
    finish_pressure(const ContactMode            mode,
                    const EventLocator::Finding &finding,
                    StepResult                  &result);

    /** Factors and responses so far, and what an iterative solver made. */
    const SolverCounters &
    counters() const
    {
      return counters_;
    }

    /**
     * Makes again what was kept and goes on counting from there, for a run that
     * goes on, whose initial state has been made. Collective.
     */
    void
    restore(const SolverCounters &counters);

  private:
    Body<dim>         &body;
    SolverCounters     counters_;
    Equilibrium<dim>   inertia;
    Equilibrium<dim>   stiffness;
    FullMatrix<double> contact_stiffness_; ///< computed when needed

    /**
     * An IterativeSolver, without matrices; only its levels are kept, and
     * preconditioners made anew each time, so that a run that is resumed makes
     * the same.
     */
    std::unique_ptr<StageSolver> iterative;

    /** Forces on a body that rests, with constrained rows zero. */
    Vector
    forces_at_rest(const State &state) const;

    /** (M.34). */
    void
    set_quasi_static_velocity(const std::vector<bool> &is_closed, State &state);

    /**
     * No pressure pulls: of nodes that are held closed none at the obstacle
     * @p held_at, though they may have left it for the other one, of the others
     * none at the nearer one.
     *
     * @param held_at 1 or -1; 0: nodes are not held
     * @return true if one did
     */
    bool
    remove_pull(const int held_at, State &state) const;
  };
} // namespace ThermoContact

#endif
