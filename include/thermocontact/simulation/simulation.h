// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_simulation_h
#define thermocontact_simulation_simulation_h

#include <thermocontact/simulation/contact_tracker.h>
#include <thermocontact/simulation/energy_monitor.h>
#include <thermocontact/simulation/error_norm.h>
#include <thermocontact/simulation/measurements.h>
#include <thermocontact/simulation/run_history.h>
#include <thermocontact/simulation/spatial_error_monitor.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/step_controller.h>
#include <thermocontact/time/time_integrator.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** The bytes from which a run goes on. */
  struct SavedRun
  {
    std::string progress; ///< the same on all ranks
    std::string nodes;    ///< values at nodes of this rank, StateSerialiser
  };



  /**
   * One scene from its initial state to its end time. Writes no file and
   * prints nothing: at the initial state and after every accepted step it
   * calls observers, which read the state from here.
   *
   * The body moves as a hybrid system: smoothly as long as contact stays as it
   * is and inputs are smooth; where contact begins or ends, or an input has a
   * discontinuity, what the equations do not keep continuous jumps: the reset
   * $R$ (Reset). A step goes from $x$ at time $t$ to $x'$ at $t'$; $m$ is the
   * state of contact that it supposes (open, closed, or the law in every
   * stage).
   * @code
   * propose t'; x^+ = x
   * repeat
   *   x' = integrate x^+ from t to t' with m held
   *   not solved, or too large an error:       t' = something smaller
   *   contact changes at t:                    m = the other; x^+ = R(x)
   *     but not at all nodes together:         m = the law
   *     and at once back again:                m = open;      x^+ = R(x)
   *       and again:                           m = the law;   x^+ = R(x)
   *   contact changes at s between t and t':   t' = s
   *     and s was missed too often:            m = the law
   *   contact changes at t':                   m = the other; x' = R(x'); done
   *   contact stays as m says:                 done
   * an input has a discontinuity at t':        x' = R(x'); m as contact then is
   * R(x') is not found:                        t' = something smaller, again
   * x = x'; t = t'
   * @endcode
   * Until it is done nothing that was accepted changes.
   */
  template <int dim>
  class Simulation
  {
  public:
    using Observer  = std::function<void(const Simulation<dim> &)>;
    using Observers = std::vector<Observer>;

    /**
     * Sets up mesh, matrices and the initial state. Collective on
     * @p communicator.
     *
     * @param scene borrowed
     * @param shared mesh and matrices of such a scene, borrowed; null: the
     *   simulation has its own
     * @throw InputError if expressions or initial values do not fit the scene
     */
    Simulation(const Scene               &scene,
               const MPI_Comm             communicator,
               const AssembledSpace<dim> *shared = nullptr);

    /** The same with a scene of its own. */
    Simulation(const Parameters          &parameters,
               const MPI_Comm             communicator,
               const AssembledSpace<dim> *shared = nullptr);

    ~Simulation(); // compiled once

    /**
     * Runs to the end time, from the present state on.
     *
     * @param observers called in this order at the initial state and after
     *   each step
     * @throw ComputationError naming step and time if a step cannot be solved,
     *   the time alone if the state that was restored lies at a discontinuity
     *   and what is behind it is not found
     */
    void
    run(const Observers &observers = {});

    /**
     * One step that is accepted, from the present state on; run() without
     * observers does nothing else.
     *
     * @return false if the run is at its end time
     * @throw ComputationError as run() does
     */
    bool
    step();

    /** All that changes during a run, after a step or at the start. */
    SavedRun
    save() const;

    /**
     * Goes on from what save() gave, for a scene that may differ in end time
     * and output. On the same number of ranks each later step is the same, bit
     * for bit; on another number it agrees to the tolerance of the solver,
     * which becomes a warning of the run. Observers are not called for the
     * state that is restored. Collective.
     *
     * @param progress of rank 0
     * @param n_ranks that saved the run
     * @param next_nodes fetches the nodes of one rank after the other, and
     *   returns false if there are no more; the nodes of this rank alone if the
     * ranks are as many
     * @throw InputError if that is not of such a run
     */
    void
    restore(const std::string                        &progress,
            const unsigned int                        n_ranks,
            const std::function<bool(std::string &)> &next_nodes);

    /** The state that was accepted last. */
    const State &
    state() const
    {
      return state_;
    }

    /** The history that led there. */
    const RunHistory &
    history() const
    {
      return history_;
    }

    /** The quantities of that state and the balances up to it. */
    const StepRecord &
    record() const
    {
      return history_.record;
    }

    const std::vector<ContactEvent> &
    events() const
    {
      return history_.events;
    }

    /** The history of the loads that steps follow. */
    const LoadHistory &
    loads() const
    {
      return controller.followed_loads();
    }

    /** Factorisations and solves so far. */
    SolverCounters
    counters() const;

    types::global_dof_index
    n_factorized_unknowns() const
    {
      return integrator->stage_solver().n_factorized_unknowns();
    }

    /** How linear systems of stages are solved, in one word or two. */
    std::string
    linear_solver() const
    {
      return integrator->stage_solver().linear_solver();
    }

    const Scene &
    scene() const
    {
      return scene_;
    }

    const Body<dim> &
    body() const
    {
      return body_;
    }

    const Discretization<dim> &
    discretization() const
    {
      return body_.discretization;
    }

    /** The entries of the user. */
    const Parameters &
    parameters() const
    {
      return scene_.parameters;
    }

  private:
    /** One of the two scenes is there. */
    Simulation(std::unique_ptr<const Scene> own,
               const Scene                 *borrowed,
               const MPI_Comm               communicator,
               const AssembledSpace<dim>   *shared);

    const std::unique_ptr<const Scene>    own_scene;
    const Scene                          &scene_;
    Body<dim>                             body_;
    Measurements<dim>                     measurements;
    const std::unique_ptr<TimeIntegrator> integrator;
    Reset<dim>                            reset;
    ContactTracker<dim>                   tracker;
    StepController                        controller;
    ErrorNorm                             error_norm;
    EnergyMonitor                         energy_monitor;
    SpatialErrorMonitor                   spatial_error_monitor;
    State                                 state_;
    RunHistory                            history_;
    StepResult                            result; ///< of the last attempt
    bool                                  is_restored = false;

    /** The last discontinuity of inputs that the state has passed. */
    double passed_break = -1.;

    /** The last time at which heat_fixed_end() looked for a discontinuity. */
    double heated_time = -1.;

    void
    set_initial_state();

    /**
     * Tries a step, and prepares the next attempt if it is not to be accepted.
     *
     * @return true if the step is to be accepted
     * @throw ComputationError naming step and time if there is nothing left to
     *   try
     */
    bool
    attempt(const TimeStep &time_step);

    /** The result of a successful attempt becomes the state. */
    void
    accept(const TimeStep &time_step);

    /** True if the step that is due is the first one of the paper. */
    bool
    is_prescribed_step() const;

    void
    compute_step(const TimeStep &time_step);

    /** Displacement of the body as a whole; 0 if it cannot move. */
    double
    rigid_displacement() const;

    /**
     * The error of a step relative to the tolerance. Impacts of nodes on a
     * rigid obstacle within unilateral steps make their velocity jump: then
     * temperature and displacement alone are judged.
     */
    double
    relative_error() const;

    /** The verdict on a step that was computed; the first that applies. */
    struct Verdict
    {
      enum Kind
      {
        failed,
        inaccurate,
        contact_changes, ///< at its start or within
        accept
      };

      Kind                  kind  = failed;
      double                error = 0.; ///< relative to the tolerance, if known
      EventLocator::Finding finding;    ///< of contact
    };

    Verdict
    judge(const TimeStep &time_step) const;

    /**
     * A step that is to be accepted is finished: its state becomes the state
     * behind the events and discontinuities of inputs at its end. If this
     * cannot be found the failure stands in the result, and nothing has
     * changed.
     *
     * @return the discontinuity that was passed, or nullptr
     */
    const LoadBreak *
    commit(const EventLocator::Finding &finding);

    /** $g'$ at the first contact node; NaN where it may have a jump. */
    double
    gap_rate() const;

    /**
     * The state behind a discontinuity of inputs at the end of a step that is
     * accepted; its failure stands in the result.
     *
     * @return the discontinuity, or nullptr
     */
    const LoadBreak *
    pass_break();

    /**
     * @p action changes the present state, whose energy is @p energy; the
     * result has what it costs.
     *
     * @throw ComputationError that says where
     */
    template <class Action>
    void
    change_present(const EnergyTerms &energy, const Action &action);

    /**
     * pass_break() in the present state.
     *
     * @throw ComputationError that says where
     */
    const LoadBreak *
    pass_present_break(const EnergyTerms &energy);

    /** Makes the present state one from which a step can start. */
    void
    prepare_step();

    /**
     * Where the temperature of the fixed end has a discontinuity the present
     * state becomes the one behind it. The row of that time is written before:
     * no heat has flowed then, and the heat that the mesh needs is that of a
     * cell.
     *
     * @throw ComputationError that says where
     */
    void
    heat_fixed_end();

    /**
     * Passes a discontinuity in the state that was restored, which the run that
     * was saved did not see, since it was to end there.
     *
     * @throw ComputationError that says where
     */
    void
    compensate_break();

    /** Takes over the warnings of the solver of stages. */
    void
    take_warnings();

    /**
     * Sizes of steps start again behind a jump of inputs, and where the state
     * of contact is another one.
     */
    void
    restart_controller(const ContactMode      old_mode,
                       const LoadBreak *const passed);

    /**
     * Does something that may fail on one rank alone: all take its failure, and
     * the sums of rank 0. Collective.
     */
    template <class Action>
    void
    together(const Action &action);

    /** @throw ComputationError that says where and why the run ends. */
    [[noreturn]] void
    give_up(const TimeStep &time_step, const std::string &reason) const;

    /** Reads or writes what changes during a run, but for the solvers. */
    template <class Archive>
    void
    archive_progress(Archive &archive);
  };
} // namespace ThermoContact

#endif
