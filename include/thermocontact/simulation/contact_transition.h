// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_contact_transition_h
#define thermocontact_simulation_contact_transition_h

#include <thermocontact/method/event_locator.h>
#include <thermocontact/simulation/quasi_static_start.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/time/stage_solver.h>
#include <thermocontact/time/time_integrator.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /** What impacts cost, per unit cross-section. */
  struct ImpactCost
  {
    double impulse               = 0.;
    double work                  = 0.; ///< of an obstacle that moves
    double numerical_dissipation = 0.;

    ImpactCost &
    operator+=(const ImpactCost &other)
    {
      impulse += other.impulse;
      work += other.work;
      numerical_dissipation += other.numerical_dissipation;
      return *this;
    }
  };



  /**
   * What happens to a state where contact begins or ends: the velocity that a
   * rigid obstacle takes away, and pressures that no stage has seen.
   */
  template <int dim>
  class ContactTransition
  {
  public:
    /** Both are borrowed. */
    ContactTransition(Body<dim> &body, QuasiStaticStart<dim> &quasi_static);

    /**
     * Pressures and velocities at the end of a step within which nodes without
     * mass closed at a rigid obstacle: those of the stages stand for the jump
     * of the velocity there and have its impulse, (M.63).
     */
    void
    settle_closed_nodes(StepResult &result);

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
    impact(State &state, EnergyTerms &energy, ImpactCost &cost);

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
    follow_turn(State &state);

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

    const SolverCounters &
    counters() const
    {
      return counters_;
    }

    /**
     * Makes again what was kept and goes on counting from there, for a run that
     * goes on. Collective.
     */
    void
    restore(const SolverCounters &counters);

  private:
    /**
     * No pressure pulls: of nodes that are held closed none at the stop
     * @p held_at, though they may have left it for the other one, of the others
     * none at the nearer one.
     *
     * @param held_at 1 or -1; 0: nodes are not held
     * @return true if one did
     */
    bool
    remove_pull(const int held_at, State &state) const;

    Body<dim>                    &body;
    QuasiStaticStart<dim>        &quasi_static;
    SolverCounters                counters_;
    std::unique_ptr<DirectSolver> mass_solver;
    std::vector<Vector>           impulse_responses;
    FullMatrix<double>            inverse_receptance;
    FullMatrix<double>            contact_stiffness_; ///< computed when needed

    /** Velocities, and those of the contact nodes, per unit impulse. */
    void
    compute_impulse_responses();

    /** Takes the velocity into the obstacle away; adds impulse and work. */
    void
    stop_contact_nodes(State &state, ImpactCost &cost);
  };
} // namespace ThermoContact

#endif
