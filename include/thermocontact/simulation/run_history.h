// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_run_history_h
#define thermocontact_simulation_run_history_h

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/contact/event_locator.h>
#include <thermocontact/simulation/measurements.h>
#include <thermocontact/simulation/sampled_peak.h>
#include <thermocontact/time/step_controller.h>
#include <thermocontact/time/time_integrator.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** The history of a run up to the state that was accepted last. */
  struct RunHistory
  {
    /** The quantities of that state and the balances up to it. */
    StepRecord record;

    /** Contact events in order of time. */
    std::vector<ContactEvent> events;

    /**
     * For observers: the attempts that the present step took, of which the last
     * one was accepted; none at the initial state. After a failure the attempts
     * at the step that failed.
     */
    std::vector<StepAttempt> attempts;

    /** Attempts that were not accepted, for whatever reason. */
    unsigned int n_rejected_steps = 0;

    /**
     * Largest $\hat E^n-\hat E^{n-1}-W$ of a step that solved a stage, where
     * it is positive; 0 if the scheme always dissipated.
     */
    double max_energy_increase = 0.;

    // of the states so far; NaN: none, or nothing moves
    double max_penetration   = nan;
    double max_contact_force = max_penetration;

    /** The largest penetration and force of a contact, between step ends, too.
     */
    struct Peaks
    {
      SampledPeak penetration, force;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &penetration &force;
      }
    };

    std::vector<Peaks> peaks; ///< of the end, or of each contact of a row

    double
    peak_force() const;

    double
    peak_penetration() const;

    /** Of the contact with the largest force; without contact of no value. */
    const SampledPeak &
    largest_force() const;

    /** Likewise of the penetration. */
    const SampledPeak &
    largest_penetration() const;

    /** Warnings for the user although the run goes on. */
    std::vector<std::string> warnings;

    /** Adds a warning that is not empty and not there yet. */
    void
    warn(const std::string &warning);

    /**
     * Takes the quantities of the present state into the largest so far.
     *
     * @param gap_rate velocity $g'$ of the obstacle of a rod; NaN where it
     *   jumps, so that the force has no single rate
     */
    void
    add_maxima(const Scene &scene, const double gap_rate);

    /** Books a step that is accepted, with its cost, not its measurements. */
    void
    add_step(const TimeStep &time_step, const StepResult &result);

    /** Books the changes by a jump of the loads in the present state. */
    void
    add_jump(const StepResult &result);

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &record &events &n_rejected_steps &max_energy_increase
        &max_penetration &max_contact_force &peaks &warnings;
    }
  };
} // namespace ThermoContact

#endif
