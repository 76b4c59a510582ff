// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_time_integrator_h
#define thermocontact_time_time_integrator_h

#include <thermocontact/contact/contact_law.h>
#include <thermocontact/contact/event_locator.h>
#include <thermocontact/space/state.h>
#include <thermocontact/time/stage_solver.h>
#include <thermocontact/time/step_controller.h>
#include <thermocontact/time/step_sums.h>

#include <memory>
#include <optional>
#include <string>

namespace ThermoContact
{
  /** A step that has been computed but not yet accepted. */
  struct StepResult : StepSums
  {
    State       state;           ///< at the end of the step
    EnergyTerms energy;          ///< of that state
    EnergyTerms error;           ///< its estimate, (D3.3)
    double      old_energy = 0.; ///< where the step starts

    unsigned int n_iterations  = 0;     ///< of the stages, added up
    bool         is_prescribed = false; ///< the paper's first step, (D5.1)
    bool         is_pushed     = false; ///< a stage has contact pressure

    /**
     * Nodes in contact at the end of a step within which nodes without mass
     * have closed: no stage has seen their pressure there. Else empty.
     */
    std::vector<bool> closed_nodes;

    /** Of the tableau that was used; nothing: of the scheme. */
    std::optional<unsigned int> order;

    /** Where each contact begins or ends in the step, if the scheme knows it.
     */
    std::vector<std::optional<ContactChange>> contact_changes;

    /** Contacts of rigid masses that begin and end at once in the step. */
    std::vector<ContactEvent> impacts;

    std::string failure; ///< empty: the step is solved

    /** The numerical dissipation becomes what the balance of the rest lacks. */
    void
    close_balance()
    {
      numerical_dissipation = old_energy - energy.sum() + work - dissipation -
                              contact_dissipation + algebraic;
    }

    /**
     * All ranks take the numbers of StepSums of rank 0, as energies are, and
     * the failure of any, so that they decide alike. Collective.
     */
    void
    agree(const MPI_Comm communicator);
  };



  /**
   * Computes one step from a state to the next. The result depends on the
   * arguments alone, and on nothing of earlier steps but factorisations, so
   * that a step can be taken again, from another state, or by a run that goes
   * on from a checkpoint.
   */
  class TimeIntegrator
  {
  public:
    virtual ~TimeIntegrator() = default;

    /**
     * One step with all equations solved.
     *
     * @param mode unilateral: the contact law; open, closed: the state of
     *   contact is held, which makes the step a smooth function of its size
     * @param result in: old_energy; out: all else; its error is set if the
     *   scheme has an estimate; reuses the memory of an earlier result; if a
     *   stage did not converge only its failure has a meaning
     * @throw ComputationError as StageSolver::solve() does
     */
    virtual void
    step(const State      &state,
         const TimeStep   &time_step,
         const ContactMode mode,
         StepResult       &result) = 0;

    /**
     * The start of the paper, (D5.1): the displacement moves with the present
     * velocity, then the heat equation is solved. No stage is solved, so that
     * the pressure is that of the compliance law, and the defect of the energy
     * balance is booked as numerical dissipation, of either sign. The caller
     * has made sure that the scheme has this start and that a rigid obstacle is
     * not penetrated. The result has old_energy, as in step().
     *
     * @throw ComputationError if the heat matrix cannot be factorised
     */
    virtual void
    prescribed_step(const State &, const TimeStep &, StepResult &)
    {
      AssertThrow(false, dealii::ExcNotImplemented());
    }

    /** The solver of its stages. */
    virtual StageSolver &
    stage_solver() = 0;

    /** The cost beside the stage solver. */
    const SolverCounters &
    own_counters() const
    {
      return counters_;
    }

    /** Goes on counting from there, for a run that goes on. */
    void
    restore_own_counters(const SolverCounters &counters)
    {
      counters_ = counters;
    }

  protected:
    SolverCounters counters_;
  };



  /** The integrator of the scheme of a body, which is borrowed. */
  template <int dim>
  std::unique_ptr<TimeIntegrator>
  make_integrator(Body<dim> &body);
} // namespace ThermoContact

#endif
