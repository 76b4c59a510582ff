// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_reset_h
#define thermocontact_simulation_reset_h

#include <thermocontact/contact/event_locator.h>
#include <thermocontact/method/load_history.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/linear_system.h>
#include <thermocontact/space/state.h>
#include <thermocontact/time/equilibrium.h>
#include <thermocontact/time/time_integrator.h>

#include <memory>
#include <optional>
#include <vector>

namespace ThermoContact
{
  /**
   * The reset map $x^+=R(x^-)$ of the hybrid system: the change of a state
   * where contact begins or ends, where inputs have a discontinuity, and at the
   * start, doc/contact-in-time.md section 4. Everywhere forces are in
   * equilibrium, $Ky+Np=r$, with the laws of the contact nodes; the order of
   * the equation at the nodes decides on the unknown y: an impulse changes the
   * velocity of inertial ones, viscous ones get a velocity, static ones a
   * place.
   */
  template <int dim>
  class Reset
  {
  public:
    /** @param body borrowed */
    explicit Reset(Body<dim> &body);

    /**
     * Completes an initial state, doc/discretisation.md section 5 and
     * doc/contact-in-time.md section 6: unknowns without inertia follow from
     * the given values. A body without inertia gets with viscosity its
     * velocity, (D5.2), and without its displacement, (D5.3), and no velocity;
     * contact nodes without mass and viscosity go to their equilibrium, (C6.2),
     * with velocities that keep them there, (C4.3).
     *
     * @param state in: temperature and, with inertia or viscosity, displacement
     *   and pressure of the compliance law
     * @throw ComputationError if the stiffness matrix cannot be factorised or
     *   the pressures of contact are not found
     */
    void
    complete(State &state);

    /**
     * The state behind a discontinuity of the loads at the end of a step,
     * doc/contact-in-time.md section 4: a static body, or static nodes, go to
     * equilibrium with the new loads, with the contact law, and takes heat for
     * it, (C4.4); a body with viscosity and without inertia stays and gets the
     * velocity, and at a rigid obstacle the pressures, of (D5.2); all else
     * stays. The loads do the work of the displacement that they cause, and
     * what is too much for the new energy is numerical dissipation. Collective.
     *
     * @param is_closed nodes that are in contact before it: only they may have
     *   a pressure in (D5.2), where all nodes stay where they are; not used for
     *   (C4.4), which finds its contact
     * @param at the end of the step, with the times of the old and new loads
     * @param result in: a step that is accepted, whose state has the time of
     *   the new loads; out: with the state behind the discontinuity at that
     *   time and its energy; work and numerical dissipation are added to, and
     *   all else, closed_nodes too, is still that of the step
     * @return true if the body or its contact nodes have answered by motion.
     *   Nothing is changed if loads of the momentum equation are continuous
     *   there, as at a time that is only listed, or move nothing
     * @throw ComputationError if the new equilibrium is not found
     */
    bool
    pass_discontinuity(const std::vector<bool> &is_closed,
                       const LoadBreak         &at,
                       StepResult              &result);

    /**
     * The state from which a step starts where the temperature of the fixed end
     * has a discontinuity: the end takes its new temperature, with the heat for
     * that, (C4.5), and what is static or has no inertia answers as to loads.
     * At the start of a run that is the difference of $\theta_A(0)$ to the
     * initial temperature, too, whose heat is no work. All arguments are those
     * of pass_discontinuity(); the result is that of no step.
     *
     * @param at nullptr: inputs are continuous there
     * @return true if there is a discontinuity; nothing is changed if not
     */
    bool
    heat_fixed_end(const std::vector<bool> &is_closed,
                   const LoadBreak *const   at,
                   StepResult              &result);

    /**
     * Impact of all contact nodes on a rigid obstacle: they are put on it, and
     * an impulse through the mass matrix changes the velocity to the nearest
     * one, in the norm of the kinetic energy, with which all of them stay there
     * (C4.1), also nodes that moved away, since contact changes at all
     * together. Nodes without mass need no impulse; a body without inertia has
     * the velocity and pressures of (D5.2).
     *
     * @param result state and energy become those behind it; impulse, work of
     *   an obstacle that moves and numerical dissipation are added to
     * @throw ComputationError if the mass matrix cannot be factorised
     */
    void
    impact(StepResult &result);

    /**
     * Velocities and pressures of viscous nodes where nothing else has jumped:
     * at a rigid obstacle, (C4.2) or without inertia (D5.2); at a damped one
     * whose velocity has jumped those of (M4.2). Else nothing changes: the
     * pressures of an elastic obstacle follow from displacements, and a body
     * that is in equilibrium at all times follows by its velocity.
     *
     * @param is_closed nodes in contact
     */
    void
    settle_velocities(const std::vector<bool> &is_closed, State &state);

    /**
     * A step that was computed is complete: nodes with mass that an obstacle
     * has moved have its place and velocity, and the pressures of its
     * acceleration.
     *
     * @throw ComputationError if the mass matrix cannot be factorised
     */
    void
    complete_step(const ContactMode mode, StepResult &result);

    /**
     * Pressures of a step that is accepted: none pulls, and where contact
     * begins they are those of the law, since no stage has seen them. Static
     * nodes and bodies go to the equilibrium of the law at an event, to the
     * accuracy of which they are there. So does the heat exchange, where
     * contact ends as well.
     *
     * @param mode of the step
     * @param finding at its end
     */
    void
    finish_pressure(const ContactMode            mode,
                    const EventLocator::Finding &finding,
                    StepResult                  &result);

    /**
     * True if a body or its contact nodes answer a discontinuity of the loads
     * by motion: without inertia and viscosity they go to another place, a body
     * without inertia gets another velocity.
     */
    bool
    moves_at_once() const;

    /** Factors, responses and iterations so far. */
    const SolverCounters &
    counters() const
    {
      return counters_;
    }

    /** Which of the systems that are kept have been made. */
    std::vector<bool>
    retained() const;

    /**
     * Makes that again and goes on counting from there, for a run that goes on,
     * whose initial state has been made. Collective.
     */
    void
    restore(const std::vector<bool> &retained, const SolverCounters &counters);

  private:
    using Rows = typename Equilibrium<dim>::Rows;

    Body<dim>       &body;
    SolverCounters   counters_;
    Equilibrium<dim> inertia;   ///< $bM_u$; laws are rigid and hold their nodes
    Equilibrium<dim> stiffness; ///< of a body without inertia
    Equilibrium<dim> at_once;   ///< $S+a^2D^TM^{-1}D$ of a static body, (C4.4)

    // of contact nodes without mass
    Equilibrium<dim> static_nodes;    ///< $S_{NN}$
    Equilibrium<dim> adiabatic_nodes; ///< the same for a body moved at once
    Equilibrium<dim> viscous_nodes;   ///< $\zeta S_{NN}$

    std::unique_ptr<LinearSystem<dim>> heat_mass; ///< if it is needed

    // of the contact nodes, scratch
    mutable std::vector<NodeLaw> node_laws;
    mutable std::vector<double>  node_positions;

    /** $M$, made when it is needed. */
    LinearSystem<dim> &
    provide_heat_mass();

    /** The loads at a time. */
    Vector
    momentum_load(const double time) const;

    /**
     * Energy::work_of_motion() of the change that @p move, without arguments,
     * makes in the displacement of the state; books what goes through the
     * boundary.
     */
    template <class Motion>
    double
    work_of(StepResult &result, const Motion &move) const;

    /** Books BoundaryFlows::jump() from these values to the state. */
    void
    book_boundaries(const Vector &old_temperature,
                    const Vector &old_displacement,
                    StepResult   &result) const;

    /** Velocities of the contact nodes less those of their local obstacles. */
    std::vector<double>
    relative_velocities(const State                &state,
                        const std::vector<NodeLaw> &laws) const;

    /** $-R_u$ of (M10.8), 0 of other bodies; @p velocity null: without viscous
     * stress. */
    Vector
    nonlinear_forces(const State &state, const Vector *velocity) const;

    /** Forces on a body by these loads, with constrained rows zero. */
    Vector
    forces(const State  &state,
           const Vector &momentum_load,
           const Vector *velocity = nullptr) const;

    /** The rows of the contact end; zero in all others. */
    Vector
    rows_of_end(const Vector &rows) const;

    /** Forces on the nodes of the contact end. */
    Vector
    node_forces(const State &state, const Vector *velocity = nullptr) const;

    /**
     * (D5.2).
     *
     * @param is_closed at a rigid obstacle: nodes in contact; empty: all nodes
     *   that do not lie before it
     * @param touches at a damped one: nodes that lie before it, as events are
     *   located to a tolerance, begin at it
     */
    void
    set_velocity_of_viscous_body(const std::vector<bool> &is_closed,
                                 State                   &state,
                                 const bool               touches = false);

    /**
     * The pressures become those with which nodes with mass that a rigid
     * obstacle holds have its acceleration, (C8.3): pressures of the last stage
     * are of first order only. The heat exchange follows them.
     *
     * @throw ComputationError if the mass matrix cannot be factorised
     */
    void
    set_pressures_of_acceleration(State &state);

    /** (D5.3), or (C4.4) without its heat. */
    void
    set_static_displacement(Equilibrium<dim> &matrix, State &state);

    /**
     * How fast the forces on a body change that moves with its velocities,
     * without those of contact: the right-hand side of (C4.3), by stiffness,
     * loads and the heat that flows. No heat at the start and behind a jump.
     */
    Vector
    rate_of_forces(const State &state);

    /**
     * (C6.2), (C4.3).
     *
     * @param closing nodes at which contact begins
     */
    void
    settle_static_nodes(State                           &state,
                        const std::vector<unsigned int> &closing = {});

    /** set_static_displacement() or settle_static_nodes(). */
    void
    set_static_equilibrium(State                           &state,
                           const std::vector<unsigned int> &closing = {});

    /**
     * Velocities and pressures of contact nodes without mass, with viscosity,
     * at a rigid obstacle, that go with displacements, temperatures and the
     * velocities of all other nodes, (C4.2): no node in contact moves into the
     * obstacle, and those with pressure rest.
     */
    void
    settle_viscous_nodes(const std::vector<bool> &is_closed, State &state);

    /** (C4.5), to @p temperature; returns the work of the heat there. */
    double
    set_temperature_of_fixed_end(const double temperature, State &state);

    /**
     * Static bodies and nodes move at once, bodies without inertia get another
     * velocity; the energy of the change is booked.
     *
     * @param work done so far
     */
    void
    move_at_once(const std::vector<bool> &is_closed,
                 double                   work,
                 StepResult              &result);

    /** (C4.4) of static nodes alone. */
    void
    move_static_nodes(State &state);

    /**
     * The energy (M2.2) of the state anew; @p work, per unit cross-section, is
     * added to, and what it does and the energy does not have is numerical
     * dissipation.
     */
    void
    book(const double work, StepResult &result) const;

    /** (C4.4) of a static body. */
    void
    move_static_body(State &state);

    /**
     * No pressure pulls: of nodes that are held closed none at the obstacle
     * @p held_at, though they may have left it for the other one, of the others
     * none at the nearer one.
     *
     * @param held_at nothing: nodes are not held
     * @return true if one did
     */
    bool
    remove_pull(const std::optional<int> held_at, State &state) const;
  };
} // namespace ThermoContact

#endif
