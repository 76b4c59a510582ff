// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_simulation_h
#define thermocontact_simulation_simulation_h

#include <thermocontact/input/parameters.h>
#include <thermocontact/method/event_locator.h>
#include <thermocontact/simulation/contact_transition.h>
#include <thermocontact/simulation/energy_watch.h>
#include <thermocontact/simulation/error_norm.h>
#include <thermocontact/simulation/measurements.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/energy.h>
#include <thermocontact/space/loads.h>
#include <thermocontact/space/problem_data.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>
#include <thermocontact/time/step_controller.h>
#include <thermocontact/time/step_solver.h>
#include <thermocontact/time/time_integrator.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * One scene from its initial state to its end time. Writes no file and
   * prints nothing: after the initial state and after every accepted step it
   * calls its observers, which read the state from here.
   */
  template <int dim>
  class Simulation
  {
  public:
    using Observer = std::function<void(const Simulation<dim> &)>;

    /**
     * Sets up mesh, matrices and the initial state. Collective on
     * @p communicator.
     *
     * @throw InputError if expressions or initial values do not fit the scene
     */
    Simulation(const Parameters &parameters, const MPI_Comm communicator);

    /** Calls @p observer at the initial state and after each step. */
    void
    add_observer(const Observer &observer);

    /**
     * Runs to the end time, from the present state on.
     *
     * @throw ComputationError naming step and time if a step cannot be solved
     */
    void
    run();

    /**
     * All that changes during a run, as bytes: the part of this rank, after a
     * step or at the start. Collective.
     */
    std::string
    memory() const;

    /**
     * Goes on from what memory() gave on the same number of ranks, for a scene
     * that may differ in end time and output: each later step is the same, bit
     * for bit. Observers are not called for the state that is restored.
     * Collective.
     *
     * @throw InputError if @p memory is not of such a run
     */
    void
    restore(const std::string &memory);

    /** The state that was accepted last. */
    const State &
    state() const
    {
      return state_;
    }

    /** The quantities of that state and the balances up to it. */
    const StepRecord &
    record() const
    {
      return record_;
    }

    /** Contact events so far, in order of time. */
    const std::vector<ContactEvent> &
    events() const
    {
      return events_;
    }

    /**
     * For observers: the attempts that the present step took, of which the last
     * one was accepted; none at the initial state. After a failure the attempts
     * at the step that failed.
     */
    const std::vector<StepAttempt> &
    attempts() const
    {
      return attempts_;
    }

    /** Attempts that were not accepted, for whatever reason. */
    unsigned int
    n_rejected_steps() const
    {
      return n_rejected_steps_;
    }

    /** What the user should know although the run goes on. */
    const std::vector<std::string> &
    warnings() const
    {
      return warnings_;
    }

    /** Factorisations and solves of the stages so far. */
    SolverCounters
    counters() const;

    types::global_dof_index
    n_factorized_unknowns() const
    {
      return step_solver->n_factorized_unknowns();
    }

    /**
     * Largest $\hat E^n-\hat E^{n-1}-W$ of a step that solved a stage, where
     * it is positive; 0 if the scheme always dissipated.
     */
    double
    max_energy_increase() const
    {
      return max_energy_increase_;
    }

    /** Largest penetration and contact force of the states so far. */
    double
    max_penetration() const
    {
      return max_penetration_;
    }

    double
    max_contact_force() const
    {
      return max_contact_force_;
    }

    const Discretization<dim> &
    discretization() const
    {
      return discretization_;
    }

    const ThermoviscoelasticOperator<dim> &
    stage_operator() const
    {
      return operator_;
    }

    const Energy<dim> &
    energy() const
    {
      return energy_;
    }

    const Parameters &
    parameters() const
    {
      return parameters_;
    }

  private:
    const Parameters                      parameters_;
    const ContactLaw                      law;
    const bool                            has_contact_mass;
    const bool                            has_contact_equilibrium;
    ProblemData<dim>                      data;
    const Discretization<dim>             discretization_;
    const ThermoviscoelasticOperator<dim> operator_;
    Loads<dim>                            loads;
    const Energy<dim>                     energy_;
    Measurements<dim>                     measurements;
    std::unique_ptr<StepSolver>           step_solver;
    std::unique_ptr<TimeIntegrator>       integrator;
    ContactTransition<dim>                transition;
    StepController                        controller;
    ErrorNorm                             error_norm;
    EnergyWatch                           energy_watch;
    EventLocator                          event_locator;

    State                     state_;
    StepRecord                record_;
    std::vector<ContactEvent> events_;
    std::vector<StepAttempt>  attempts_;
    unsigned int              n_rejected_steps_ = 0;
    unsigned int              n_retakes         = 0; ///< to the next event
    ContactValues             contact_values;
    double                    max_energy_increase_ = 0.;
    double                    max_penetration_     = 0.;
    double                    max_contact_force_   = 0.;
    std::vector<std::string>  warnings_;
    std::vector<Observer>     observers;
    bool                      is_restored = false;

    void
    set_initial_state();

    /** True if the step that is due is the first one of the paper. */
    bool
    is_prescribed_step() const;

    void
    compute_step(const TimeStep   &time_step,
                 const ContactMode mode,
                 StepResult       &result);

    /**
     * The error of a step relative to the tolerance. Impacts of nodes on a
     * rigid obstacle within unilateral steps make their velocity jump: then
     * temperature and displacement alone are judged.
     */
    double
    relative_error(const StepResult &result);

    /**
     * Tries a step and tells the controller how it went.
     *
     * @return true if the step is to be accepted
     * @throw ComputationError naming step and time if there is nothing left to
     *   try
     */
    bool
    attempt(const TimeStep &time_step, StepResult &result);

    /**
     * True if contact does not change within an accurate step, which then ends
     * a state of contact or leaves it as it is. False: the next attempt is
     * aimed at the change, or made in the other state of contact.
     */
    bool
    respects_contact(const TimeStep &time_step, StepResult &result);

    /** @throw ComputationError that says where and why the run ends. */
    [[noreturn]] void
    give_up(const TimeStep &time_step, const std::string &reason) const;

    void
    get_contact_values(const State &state, ContactValues &values) const;

    /**
     * Makes the end of a step a state that the next one can start from: a rigid
     * obstacle takes velocity away; where the contact nodes are in equilibrium,
     * a step that ends with an event is taken once more with the contact law.
     *
     * @param mode of the step
     */
    void
    finish_contact(const TimeStep   &time_step,
                   const ContactMode mode,
                   const bool        has_event,
                   StepResult       &result);

    void
    accept(const TimeStep &time_step, StepResult &result);

    /** Reads or writes what changes during a run, but for the solvers. */
    template <class Archive>
    void
    archive_progress(Archive &archive);

    void
    notify() const;
  };
} // namespace ThermoContact

#endif
