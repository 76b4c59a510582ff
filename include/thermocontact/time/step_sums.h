// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_step_sums_h
#define thermocontact_time_step_sums_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <algorithm>
#include <vector>

namespace ThermoContact
{
  /** The end of a stage with the rates and loads there; all are borrowed. */
  struct StageOfStep
  {
    const State  &state;
    const Vector &temperature_rate; ///< $\theta'$
    const Vector &acceleration;     ///< $v'$
    const Vector &heat_load;        ///< without the motion of a driven end
    const Vector &momentum_load;    ///< likewise

    /** Times of which the loads are the mean; null: that of the state. */
    const MeanOfTimes *load_times = nullptr;
  };



  /**
   * The terms of the balances of a step or a reset, doc/discretisation.md
   * (D4.1), that are integrals over its time; nondimensional, per unit
   * cross-section.
   */
  struct StepSums
  {
    using S = StepSums;

    double work                  = 0.; ///< $W$
    double dissipation           = 0.; ///< $D$
    double lateral_dissipation   = 0.; ///< the part (D4.5) of $D$
    double numerical_dissipation = 0.; ///< $N$
    double algebraic             = 0.; ///< $A$, (D8.5)
    double contact_dissipation   = 0.; ///< by the obstacle, (D4.7)
    double impulse               = 0.; ///< of the contact force

    /** The same of each contact of a row; else empty. */
    std::vector<double> impulses;

    BoundarySums boundaries; ///< with Output/Boundaries

    /** Calls @p act with a pointer to each member that is a number. */
    template <class Act>
    static void
    for_each_number(const Act &act)
    {
      act(&S::work);
      act(&S::dissipation);
      act(&S::lateral_dissipation);
      act(&S::numerical_dissipation);
      act(&S::algebraic);
      act(&S::contact_dissipation);
      act(&S::impulse);
    }

    /** All become zero; memory stays. */
    void
    start_sums()
    {
      for_each_number([&](double S::*const number) { this->*number = 0.; });
      impulses.clear();
      boundaries = {};
    }

    /** Adds all terms of a reset to those of a step. */
    void
    add(const StepSums &other)
    {
      for_each_number(
        [&](double S::*const number) { this->*number += other.*number; });
      add_impulses(1., other.impulses);
      boundaries.add(1., other.boundaries);
    }

    /** Adds the impulses of pressures of the contact nodes in a time. */
    template <int dim>
    void
    add_impulse(const double               duration,
                const std::vector<double> &pressure,
                const Body<dim>           &body)
    {
      impulse += duration * body.contact_end().mean(pressure);
      if (body.scene.row.is_given())
        add_impulses(duration, pressure);
    }

    /** Adds the dissipation in the body. Collective. */
    template <int dim>
    void
    add_dissipation(const double weight, const State &state, Body<dim> &body)
    {
      dissipation += weight * body.energy.dissipation_rate(state);
      lateral_dissipation +=
        weight * body.energy.lateral_dissipation_rate(state);
    }

    /** Adds the work of loads and of a driven end, and the flows through the
     * boundary. Collective. */
    template <int dim>
    void
    add_work(const double weight, const StageOfStep &at, Body<dim> &body)
    {
      if (body.energy.has_work())
        work += weight *
                body.energy.work_rate(at.heat_load, at.momentum_load, at.state);
      if (body.driven_end.is_active())
        work += weight * body.driven_end.power(at.state,
                                               at.temperature_rate,
                                               at.acceleration,
                                               at.heat_load,
                                               at.momentum_load);
      if (body.boundary_flows.is_active())
        boundaries.add(weight,
                       body.boundary_flows.rates(at.state,
                                                 at.temperature_rate,
                                                 at.acceleration,
                                                 at.heat_load,
                                                 at.momentum_load,
                                                 at.load_times));
    }

    /** Adds impulse, work and dissipation of the obstacle. Collective. */
    template <int dim>
    void
    add_contact(const double weight, const State &state, Body<dim> &body)
    {
      contact_dissipation += weight * body.energy.damping_rate(state);
      add_impulse(weight, state.contact.pressure, body);
      if (body.energy.has_work())
        work += weight * body.energy.obstacle_power(state);
    }

    /** Adds all terms of a stage. Collective. */
    template <int dim>
    void
    add_stage(const double weight, const StageOfStep &at, Body<dim> &body)
    {
      add_dissipation(weight, at.state, body);
      add_work(weight, at, body);
      add_contact(weight, at.state, body);
    }

  private:
    void
    add_impulses(const double weight, const std::vector<double> &others)
    {
      impulses.resize(std::max(impulses.size(), others.size()), 0.);
      for (unsigned int i = 0; i < others.size(); ++i)
        impulses[i] += weight * others[i];
    }
  };
} // namespace ThermoContact

#endif
