// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_contact_tracker_h
#define thermocontact_simulation_contact_tracker_h

#include <thermocontact/contact/event_locator.h>
#include <thermocontact/method/load_history.h>
#include <thermocontact/simulation/reset.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/step_controller.h>
#include <thermocontact/time/time_integrator.h>

#include <optional>
#include <vector>

namespace ThermoContact
{
  /** What contact says of a step that has been computed and is accurate. */
  struct ContactVerdict
  {
    enum Kind
    {
      accept,  ///< contact is what was supposed
      to_time, ///< contact changes within: take it again to @p time
      again    ///< take it again, in the mode that the tracker has now
    };

    Kind   kind = accept;
    double time = 0.;
  };



  /**
   * The discrete part of the motion: which state of contact an attempt at a
   * step supposes, from where it starts, and whether what it shows fits.
   * Between attempts nothing that was accepted changes: an impact at the start
   * of a step acts on a copy of the state, which counts when the step from it
   * is accepted and is dropped when its event is taken back.
   */
  template <int dim>
  class ContactTracker
  {
  public:
    /** Both are borrowed. */
    ContactTracker(Body<dim> &body, Reset<dim> &reset);

    /** Takes the initial state, before any step. */
    void
    start(const State &initial, std::vector<ContactEvent> &events);

    /** The state of contact that the next attempt supposes. */
    ContactMode
    mode() const
    {
      return locator.mode();
    }

    /** Where the next attempt starts: @p accepted, or what an impact makes. */
    const State &
    start_state(const State &accepted) const
    {
      return impacted ? impacted->state : accepted;
    }

    /** Energy there. */
    double
    start_energy(const EnergyTerms &accepted) const
    {
      return (impacted ? impacted->energy : accepted).sum();
    }

    /**
     * A step that was computed is complete: with the pressures of nodes that an
     * obstacle has moved.
     */
    void
    complete(StepResult &result);

    /**
     * Judges a step and prepares the next attempt.
     *
     * @param accepted,energy the state that was accepted last
     * @param is_prescribed the step of the paper, which supposes nothing
     * @param mechanical_energy largest elastic or kinetic energy so far
     */
    ContactVerdict
    judge(const TimeStep    &time_step,
          const StepResult  &result,
          const State       &accepted,
          const EnergyTerms &energy,
          const bool         is_prescribed,
          const double       mechanical_energy);

    /**
     * The step that was judged last is accepted: makes its end a state that the
     * next one can start from, books what impacts have cost, and appends its
     * events.
     */
    void
    accept(StepResult &result, std::vector<ContactEvent> &events);

    /**
     * Nodes in contact at the end of the step that was accepted last, or in the
     * state that was given or restored: those with pressure, those that closed
     * within the step, and those that lie on the obstacle to the accuracy of an
     * event, (C3.1).
     */
    std::vector<bool>
    closed_nodes(const StepResult &result) const;

    /**
     * Loads jump at the end of the step that was accepted last: contact in the
     * state after it may be another one.
     */
    void
    jump(const State &state, std::vector<ContactEvent> &events);

    /**
     * The velocity of the obstacle may jump where the step that was accepted
     * last ends: an impact, if a rigid one gets faster towards the nodes with
     * mass that are in contact with it; a release, if it gets slower. Viscous
     * nodes get the velocities and pressures with which they follow, or not.
     *
     * @param at where the step ends
     * @param result in, out: of the step, whose costs are added
     * @param events in, out: of nodes that do not follow
     */
    void
    pass_slope_discontinuity(const LoadBreak           &at,
                             StepResult                &result,
                             std::vector<ContactEvent> &events);

    /** What changes during a run, for checkpoints; after accept(). */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &locator;
    }

  private:
    const Body<dim>          &body;
    Reset<dim>               &reset;
    EventLocator              locator;
    EventLocator::Finding     finding;   ///< of the step that was judged last
    ContactValues             next;      ///< at its end
    std::optional<StepResult> impacted;  ///< by an impact at its start
    unsigned int              n_retakes; ///< to the next event

    void
    get_values(const State &state, ContactValues &values) const;

    /** Contact changes at the start of the step. */
    ContactVerdict
    switch_state(const State &accepted, const EnergyTerms &energy);

    ContactVerdict
    leave_to_law();
  };
} // namespace ThermoContact

#endif
