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
  } // namespace



  template <int dim>
  ContactTracker<dim>::ContactTracker(Body<dim> &body, Reset<dim> &reset)
    : body(body)
    , reset(reset)
    , n_old_events(0)
    , n_retakes(0)
  {
    const unsigned int n =
      body.scene.row.is_given() ? body.contact_end().n_nodes() : 1;
    locators.reserve(n);
    for (unsigned int i = 0; i < n; ++i)
      locators.emplace_back(body.scene.contact.law_at(i),
                            body.scene.contact.locates_events &&
                              (n == 1 ||
                               !body.scene.contact.law_at(i).is_rigid()),
                            body.scene.contact.order,
                            body.scene.parameters.time.has_error_control() ?
                              body.scene.parameters.time.tolerance :
                              Tolerances::fixed_step_event,
                            !body.scene.fields.has_temperature ||
                              body.scene.heat.exchange->is_in_matrices(),
                            !body.scene.material.is_static(),
                            body.scene.contact.rear_law.get());
  }



  template <int dim>
  void
  ContactTracker<dim>::start(const State               &initial,
                             std::vector<ContactEvent> &events)
  {
    get_contact_values(body, initial, next);
    std::vector<ContactEvent> all;
    for (unsigned int i = 0; i < locators.size(); ++i)
      {
        locators[i].start(of_contact(next, i), events);
        for (ContactEvent &event : events)
          {
            event.contact = i;
            all.push_back(event);
          }
      }
    events = all;
  }



  template <int dim>
  EventLocator::Finding
  ContactTracker<dim>::judge(const TimeStep   &time_step,
                             const StepResult &result,
                             const double      mechanical_energy) const
  {
    if (result.is_prescribed ||
        std::all_of(locators.begin(), locators.end(), [](const auto &locator) {
          return locator.mode() == ContactMode::unilateral;
        }))
      return {};
    get_contact_values(body, result.state, next);
    const bool       is_aimed = time_step.target == TimeStep::event;
    const BodyScales scales   = {mechanical_energy,
                                 std::sqrt(2. * body.scene.material.inertia *
                                         mechanical_energy)};
    return is_of_several() ? judge_several(is_aimed, scales) :
                             locators[0].examine(next, is_aimed, scales);
  }



  template <int dim>
  EventLocator::Finding
  ContactTracker<dim>::judge_several(const bool        is_aimed,
                                     const BodyScales &scales) const
  {
    using Finding = EventLocator::Finding;
    Finding first, changes; // the kind of the latter stays nothing
    for (unsigned int i = 0; i < locators.size(); ++i)
      {
        if (locators[i].mode() == ContactMode::unilateral)
          continue;
        const Finding finding =
          locators[i].examine(of_contact(next, i), is_aimed, scales);
        if (finding.kind == Finding::within &&
            (first.kind == Finding::nothing || finding.time < first.time))
          first = finding;
        if (finding.kind == Finding::nothing)
          continue;
        changes.of_contacts.resize(locators.size());
        changes.of_contacts[i] = {finding.kind, finding.obstacle};
      }
    return first.kind == Finding::within ? first : changes;
  }



  template <int dim>
  void
  ContactTracker<dim>::finish_by_law()
  {
    for (EventLocator &locator : locators)
      locator.finish_by_law();
  }



  template <int dim>
  std::optional<double>
  ContactTracker<dim>::prepare(const EventLocator::Finding &finding,
                               const State                 &accepted,
                               const EnergyTerms           &energy)
  {
    if (finding.kind == EventLocator::Finding::within &&
        ++n_retakes < max_retakes)
      return finding.time;
    if (finding.kind == EventLocator::Finding::at_start &&
        finding.changes_all_nodes)
      switch_state(finding, accepted, energy);
    else
      finish_by_law();
    return {};
  }



  template <int dim>
  void
  ContactTracker<dim>::switch_state(const EventLocator::Finding &finding,
                                    const State                 &accepted,
                                    const EnergyTerms           &energy)
  {
    EventLocator &locator   = locators[0];
    const bool    is_closed = locator.mode() == ContactMode::closed;
    if (impacted && body.scene.contact.has_mass())
      {
        if (!is_closed)
          return locator.finish_by_law();
        // Loads draw away at once what the obstacle has stopped. Stages that
        // know of no impact would throw it back instead.
        get_contact_values(body, impacted->state, next);
        return locator.release(next);
      }
    std::optional<StepResult> impact;
    if (!is_closed && body.scene.contact.stops_nodes())
      {
        impact.emplace();
        impact->state  = accepted;
        impact->energy = energy;
        reset.impact(*impact);
      }
    impacted.reset();
    if (locator.switch_at_start(finding.time,
                                finding.change_of_velocity,
                                finding.obstacle))
      impacted = std::move(impact);
  }



  template <int dim>
  void
  ContactTracker<dim>::take_back(std::vector<ContactEvent> &events)
  {
    for (unsigned int i = 0; i < locators.size(); ++i)
      locators[i].restore(old_progress[i]);
    events.resize(n_old_events);
  }



  template <int dim>
  void
  ContactTracker<dim>::accept_several(const StepResult            &result,
                                      const EventLocator::Finding &finding,
                                      const std::size_t            first,
                                      std::vector<ContactEvent>   &events)
  {
    using Finding = EventLocator::Finding;
    get_contact_values(body, result.state, next);
    events.insert(events.end(), result.impacts.begin(), result.impacts.end());
    for (unsigned int i = 0; i < locators.size(); ++i)
      {
        Finding of_this;
        if (!finding.of_contacts.empty())
          {
            of_this.kind     = finding.of_contacts[i].kind;
            of_this.obstacle = finding.of_contacts[i].obstacle;
          }
        if (of_this.kind == Finding::at_start) // the law has seen it
          locators[i].finish_by_law();
        std::vector<ContactEvent> own_events;
        locators[i].accept(of_contact(next, i),
                           of_this,
                           own_events,
                           i < result.contact_changes.size() ?
                             result.contact_changes[i] :
                             std::nullopt);
        for (ContactEvent &event : own_events)
          {
            event.contact = i;
            event.time =
              std::min(event.time, body.scene.parameters.time.end_time);
            events.push_back(event);
          }
      }
    std::stable_sort(events.begin() + first,
                     events.end(),
                     [](const ContactEvent &a, const ContactEvent &b) {
                       return a.time < b.time;
                     });
  }



  template <int dim>
  void
  ContactTracker<dim>::accept(const EventLocator::Finding &finding,
                              StepResult                  &result,
                              std::vector<ContactEvent>   &events)
  {
    EventLocator &locator = locators[0];
    old_progress.resize(locators.size());
    for (unsigned int i = 0; i < locators.size(); ++i)
      old_progress[i] = locators[i].progress(); // in the memory of the last one
    n_old_events = events.size();
    if (is_of_several())
      {
        accept_several(result, finding, n_old_events, events);
        n_retakes = 0;
        return reset.finish_pressure(mode(), finding, result);
      }
    if (result.is_prescribed) // it supposes nothing
      locator.finish_by_law();
    const ContactMode mode = locator.mode();
    if (!result.closed_nodes.empty() && body.scene.contact.has_rigid())
      reset.settle_velocities(result.closed_nodes, result.state);
    get_contact_values(body, result.state, next);
    events.insert(events.end(), result.impacts.begin(), result.impacts.end());
    locator.accept(next,
                   finding,
                   events,
                   result.contact_changes.empty() ? std::nullopt :
                                                    result.contact_changes[0]);
    // a node without mass does not fly when it leaves, and then follows waves
    // shorter than those that the mesh has
    if (body.scene.contact.is_in_equilibrium() &&
        !body.scene.material.has_viscosity())
      for (std::size_t i = n_old_events; i < events.size(); ++i)
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
      // contact that ends at once ends with the velocities of stopped nodes
      set_present(result.state);
    if (impacted)
      result.add(*impacted);
  }



  template <int dim>
  void
  ContactTracker<dim>::set_present(const State &state)
  {
    get_contact_values(body, state, next);
    for (unsigned int i = 0; i < locators.size(); ++i)
      locators[i].set_present(of_contact(next, i));
  }



  template <int dim>
  void
  ContactTracker<dim>::pass_slope_discontinuity(
    const LoadBreak           &at,
    StepResult                &result,
    std::vector<ContactEvent> &events)
  {
    // a static body keeps the velocity that it had in the step
    if (body.scene.material.is_static())
      return;
    EventLocator        &locator = locators[0];
    State               &state   = result.state;
    std::vector<NodeLaw> before, behind;
    std::vector<double>  position;
    body.obstacle.set_rates(at.old_time, state);
    get_node_laws(body, state, before, position);
    body.obstacle.set_rates(at.new_time, state);
    get_node_laws(body, state, behind, position);
    double towards = 0., away = 0., scale = 0.;
    for (unsigned int i = 0; i < before.size(); ++i)
      {
        const double old_rate = before[i].local_rate();
        const double rate     = behind[i].local_rate();
        towards               = std::max(towards, old_rate - rate);
        away                  = std::max(away, rate - old_rate);
        scale = std::max({scale, std::abs(rate), std::abs(old_rate)});
      }
    const double continuous = Tolerances::continuous_velocity * scale;
    const bool   is_held =
      body.scene.contact.has_impacts() && locator.mode() == ContactMode::closed;
    if (is_held && towards > continuous)
      reset.impact(result);
    else
      reset.settle_velocities(closed_nodes(result), state);
    set_present(state);
    if (is_held && towards <= continuous && away > continuous)
      locator.switch_at_start(state.time); // nodes with inertia do not follow
    else if (std::max(towards, away) > continuous &&
             body.scene.contact.has_rigid() &&
             body.scene.contact.order == NodeOrder::viscous)
      jump(state, events);
  }



  template <int dim>
  std::vector<bool>
  ContactTracker<dim>::closed_nodes(const StepResult &result) const
  {
    ContactValues values;
    get_contact_values(body, result.state, values);
    std::vector<bool> is_closed;
    for (unsigned int i = 0; i < locators.size(); ++i)
      for (const bool one : locators[i].closed_nodes(of_contact(values, i)))
        is_closed.push_back(one);
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
    const std::size_t n_events = events.size();
    if (is_of_several())
      {
        StepResult at_jump;
        at_jump.state = state;
        finish_by_law();
        accept_several(at_jump, {}, n_events, events);
      }
    else
      {
        get_contact_values(body, state, next);
        locators[0].finish_by_law();
        locators[0].accept(next, {}, events);
      }
    if (body.scene.material.is_static()) // moved at once
      for (std::size_t i = n_events; i < events.size(); ++i)
        events[i].velocity = nan;
  }



  template class ContactTracker<1>;
  template class ContactTracker<2>;
  template class ContactTracker<3>;
} // namespace ThermoContact
