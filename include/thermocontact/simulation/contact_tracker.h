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
      return is_of_several() ? ContactMode::unilateral : locators[0].mode();
    }

    /** The next attempt starts here: at @p accepted, or behind an impact. */
    const State &
    start_state(const State &accepted) const
    {
      return impacted ? impacted->state : accepted;
    }

    /** The energy of start_state(). */
    double
    start_energy(const EnergyTerms &accepted) const
    {
      return (impacted ? impacted->energy : accepted).sum();
    }

    /**
     * The contact in a step that is accurate: the step is right if contact
     * changes neither at its start nor within.
     *
     * @param mechanical_energy largest elastic or kinetic energy so far
     */
    EventLocator::Finding
    judge(const TimeStep   &time_step,
          const StepResult &result,
          const double      mechanical_energy) const;

    /**
     * The step that shows this is to be taken again: in another state of
     * contact, or to an earlier time, which is returned. Nothing changes if it
     * throws.
     *
     * @param accepted,energy the state that was accepted last
     */
    std::optional<double>
    prepare(const EventLocator::Finding &finding,
            const State                 &accepted,
            const EnergyTerms           &energy);

    /**
     * Makes the end of a step that is accepted a state that the next one can
     * start from, books what impacts have cost, and appends its events. Counts
     * with confirm() and is undone by take_back().
     *
     * @param finding of judge()
     */
    void
    accept(const EventLocator::Finding &finding,
           StepResult                  &result,
           std::vector<ContactEvent>   &events);

    void
    confirm()
    {
      impacted.reset();
    }

    /** The step behind accept() is to be taken again after all. */
    void
    take_back(std::vector<ContactEvent> &events);

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

    /** EventLocator::forget_last(), of all. */
    void
    forget_last()
    {
      for (EventLocator &locator : locators)
        locator.forget_last();
    }

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

    /** The part that changes during a run, for checkpoints; after accept(). */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      for (EventLocator &locator : locators)
        archive &locator;
    }

  private:
    const Body<dim> &body;
    Reset<dim>      &reset;

    /**
     * One of all nodes; or, where a row has several contacts, one of each: then
     * stages leave contact to the law, and steps end where it changes.
     */
    std::vector<EventLocator>    locators;
    std::vector<ContactProgress> old_progress; ///< before accept()
    std::size_t                  n_old_events;
    std::optional<StepResult>    impacted;  ///< by an impact at its start
    unsigned int                 n_retakes; ///< to the next event
    mutable ContactValues        next;      ///< scratch
    mutable ContactValues        of_one;    ///< likewise

    /** The values that a locator looks at; valid until the next call. */
    const ContactValues &
    of_contact(const ContactValues &values, const unsigned int contact) const
    {
      if (!is_of_several())
        return values;
      values.get_node(contact, of_one);
      return of_one;
    }

    bool
    is_of_several() const
    {
      return locators.size() > 1;
    }

    /** The first change of a contact of a row within the step, or all that end
     * it. */
    EventLocator::Finding
    judge_several(const bool is_aimed, const BodyScales &scales) const;

    /** The contacts of a row have events of their own, which are sorted from
     * this one on. */
    void
    accept_several(const StepResult            &result,
                   const EventLocator::Finding &finding,
                   const std::size_t            first,
                   std::vector<ContactEvent>   &events);

    /** The present state of all contacts becomes that of the values. */
    void
    set_present(const State &state);

    /** No contact is supposed to stay as it is. */
    void
    finish_by_law();

    /** Contact changes at the start of the step. */
    void
    switch_state(const EventLocator::Finding &finding,
                 const State                 &accepted,
                 const EnergyTerms           &energy);
  };
} // namespace ThermoContact

#endif
