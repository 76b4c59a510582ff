// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/simulation/contact_tracker.h>
#include <thermocontact/space/node_laws.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Interpolants that miss a zero so often are not to be trusted. */
    constexpr unsigned int max_retakes = 10;



    /** Adds what an impact has cost to a step. */
    void
    book(const StepResult &impact, StepResult &result)
    {
      result.impulse += impact.impulse;
      result.work += impact.work;
      result.numerical_dissipation += impact.numerical_dissipation;
    }
  } // namespace



  template <int dim>
  ContactTracker<dim>::ContactTracker(Body<dim> &body, Reset<dim> &reset)
    : body(body)
    , reset(reset)
    , locator(body.law(),
              body.scene.contact.locates_events,
              body.scene.contact.order,
              body.scene.parameters.time.has_error_control() ?
                body.scene.parameters.time.tolerance :
                Tolerances::fixed_step_event,
              !body.scene.fields.has_temperature ||
                body.scene.heat.exchange->is_constant(),
              !body.scene.material.is_static())
    , n_retakes(0)
  {}



  template <int dim>
  void
  ContactTracker<dim>::start(const State               &initial,
                             std::vector<ContactEvent> &events)
  {
    get_values(initial, next);
    locator.start(next, events);
  }



  template <int dim>
  void
  ContactTracker<dim>::get_values(const State   &state,
                                  ContactValues &values) const
  {
    const ContactEnd<dim> &end = body.contact_end();
    values.time                = state.time;
    end.get_values(Field::displacement,
                   state.displacement,
                   values.displacement);
    for (const int side : {1, -1})
      {
        ContactValues::Side &seen = side > 0 ? values.front : values.rear;
        end.get_penetrations(state, side, seen.penetration);
        end.get_velocities_into(state, side, seen.velocity);
      }
    values.pressure = state.contact_pressure;
    // a damped obstacle is left where the penetration ends
    const ContactLaw &law = body.law();
    if (law.damping() > 0.)
      for (unsigned int i = 0; i < values.pressure.size(); ++i)
        {
          const double s     = values.front.penetration[i];
          const double rear  = values.rear.penetration[i];
          values.pressure[i] = std::isinf(rear) ?
                                 std::copysign(law.pressure(std::abs(s)), s) :
                                 law.pressure(s) - law.pressure(rear);
        }
  }



  template <int dim>
  ContactVerdict
  ContactTracker<dim>::leave_to_law()
  {
    locator.leave_to_law();
    return {ContactVerdict::again};
  }



  template <int dim>
  ContactVerdict
  ContactTracker<dim>::switch_state(const State       &accepted,
                                    const EnergyTerms &energy)
  {
    if (impacted && body.scene.contact.has_mass())
      {
        if (locator.mode() != ContactMode::closed)
          return leave_to_law();
        // Loads draw away at once what the obstacle has stopped. Stages that
        // know of no impact would throw it back instead.
        get_values(impacted->state, next);
        locator.release(next);
        return {ContactVerdict::again};
      }
    impacted.reset();
    if (locator.switch_at_start(finding.time,
                                finding.change_of_velocity,
                                finding.side) &&
        body.scene.contact.stops_nodes() &&
        locator.mode() == ContactMode::closed)
      {
        impacted.emplace();
        impacted->state  = accepted;
        impacted->energy = energy;
        reset.impact(*impacted);
      }
    return {ContactVerdict::again};
  }



  template <int dim>
  void
  ContactTracker<dim>::complete(StepResult &result)
  {
    if (!body.obstacle.is_active() || !body.scene.contact.has_impacts())
      return;
    // impacts take the velocity of the obstacle, not that of the last stage
    body.obstacle.set_rates(result.state.time, result.state);
    if (locator.mode() != ContactMode::closed)
      return;
    put_on_obstacle(body, result.state); // where they are but for rounding
    // the audit of a scheme of first order has the pressure of its stage
    if (!body.scene.sources.has_moving_end && body.scene.scheme.order > 1)
      reset.set_pressures_of_acceleration(result.state);
  }



  template <int dim>
  ContactVerdict
  ContactTracker<dim>::judge(const TimeStep    &time_step,
                             const StepResult  &result,
                             const State       &accepted,
                             const EnergyTerms &energy,
                             const bool         is_prescribed,
                             const double       mechanical_energy)
  {
    get_values(result.state, next);
    finding = EventLocator::Finding();
    if (is_prescribed)
      locator.leave_to_law();
    if (locator.mode() != ContactMode::unilateral)
      finding = locator.examine(next,
                                time_step.target == TimeStep::event,
                                {mechanical_energy,
                                 std::sqrt(2. * body.scene.material.inertia *
                                           mechanical_energy)});
    switch (finding.kind)
      {
        case EventLocator::Finding::at_start:
          return finding.is_of_all_nodes ? switch_state(accepted, energy) :
                                           leave_to_law();
        case EventLocator::Finding::within:
          if (++n_retakes < max_retakes)
            return {ContactVerdict::to_time, finding.time};
          return leave_to_law();
        default:
          return {};
      }
  }



  template <int dim>
  void
  ContactTracker<dim>::accept(StepResult                &result,
                              std::vector<ContactEvent> &events)
  {
    const ContactMode mode = locator.mode();
    if (!result.closed_nodes.empty() && body.law().is_rigid())
      {
        reset.settle_velocities(result.closed_nodes, result.state);
        get_values(result.state, next);
      }
    const std::size_t n_events = events.size();
    locator.accept(next, finding, events, result.contact_change);
    // a node without mass does not fly when it leaves, and then follows waves
    // shorter than those that the mesh has
    if (body.scene.contact.is_in_equilibrium() &&
        !body.scene.material.has_viscosity())
      for (std::size_t i = n_events; i < events.size(); ++i)
        if (events[i].kind == ContactEvent::end)
          events[i].velocity = nan;
    if (!events.empty()) // it may have been extrapolated
      events.back().time =
        std::min(events.back().time, body.scene.parameters.time.end_time);
    n_retakes = 0;
    reset.finish_pressure(mode, finding, result);
    const bool is_impact = body.scene.contact.stops_nodes() &&
                           mode != ContactMode::closed &&
                           locator.mode() == ContactMode::closed;
    if (is_impact)
      reset.impact(result);
    if (is_impact || finding.kind == EventLocator::Finding::at_end)
      {
        // an end of contact at once is that of nodes that have stopped
        get_values(result.state, next);
        locator.set_present(next);
      }
    if (impacted)
      book(*impacted, result);
    impacted.reset();
  }



  template <int dim>
  void
  ContactTracker<dim>::pass_slope_discontinuity(
    const LoadBreak           &at,
    StepResult                &result,
    std::vector<ContactEvent> &events)
  {
    // its velocity is that of the step, as are the rates that it followed
    if (body.scene.material.is_static())
      return;
    State &state = result.state;
    body.obstacle.set_rates(at.old_time, state);
    const std::vector<double> old_rate(state.gap_rate);
    body.obstacle.set_rates(at.new_time, state);
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    double towards = 0., away = 0., scale = 0.;
    for (unsigned int i = 0; i < old_rate.size(); ++i)
      if (laws[i].side > 0) // the obstacle behind the nodes rests
        {
          const double rate = state.gap_rate[i];
          towards           = std::max(towards, old_rate[i] - rate);
          away              = std::max(away, rate - old_rate[i]);
          scale = std::max({scale, std::abs(rate), std::abs(old_rate[i])});
        }
    const double continuous = Tolerances::continuous_velocity * scale;
    const bool   is_held =
      body.scene.contact.has_impacts() && locator.mode() == ContactMode::closed;
    if (is_held && towards > continuous)
      reset.impact(result);
    else
      reset.settle_velocities(closed_nodes(result), state);
    get_values(state, next);
    locator.set_present(next);
    if (is_held && towards <= continuous && away > continuous)
      locator.switch_at_start(state.time); // what has inertia does not follow
    else if (std::max(towards, away) > continuous && body.law().is_rigid() &&
             body.scene.contact.order == NodeOrder::viscous)
      jump(state, events);
  }



  template <int dim>
  std::vector<bool>
  ContactTracker<dim>::closed_nodes(const StepResult &result) const
  {
    ContactValues values;
    get_values(result.state, values);
    std::vector<bool> is_closed = locator.closed_nodes(values);
    for (unsigned int i = 0; i < result.closed_nodes.size(); ++i)
      if (result.closed_nodes[i])
        is_closed[i] = true;
    return is_closed;
  }



  template <int dim>
  void
  ContactTracker<dim>::jump(const State               &state,
                            std::vector<ContactEvent> &events)
  {
    get_values(state, next);
    locator.leave_to_law();
    const std::size_t n_events = events.size();
    locator.accept(next, {}, events);
    if (body.scene.material.is_static()) // moved at once
      for (std::size_t i = n_events; i < events.size(); ++i)
        events[i].velocity = nan;
  }



  template class ContactTracker<1>;
  template class ContactTracker<2>;
  template class ContactTracker<3>;
} // namespace ThermoContact
