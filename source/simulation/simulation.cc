// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/simulation/initial_state.h>
#include <thermocontact/simulation/scheme_selection.h>
#include <thermocontact/simulation/simulation.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

namespace ThermoContact
{
  template <int dim>
  Simulation<dim>::Simulation(const Parameters &parameters,
                              const MPI_Comm    communicator)
    : parameters_(parameters)
    , law(parameters.contact_law())
    , has_contact_mass(parameters.has_contact_mass())
    , has_contact_equilibrium(parameters.has_contact_equilibrium())
    , data(parameters)
    , discretization_(parameters, communicator)
    , operator_(discretization_, parameters)
    , loads(discretization_, parameters, data)
    , energy_(discretization_, operator_, loads, law, parameters)
    , measurements(discretization_, operator_, law, parameters)
    , step_solver(make_step_solver(discretization_, operator_, law, parameters))
    , integrator(make_time_integrator(discretization_,
                                      operator_,
                                      energy_,
                                      law,
                                      parameters,
                                      loads,
                                      *step_solver))
    , transition(discretization_, operator_, energy_, law, has_contact_mass)
    , controller(parameters, order_of(parameters.time))
    , error_norm(energy_.steady_profile_energy())
    , energy_watch(parameters, energy_.has_work())
    , event_locator(law,
                    law.is_active && parameters.time.locates_contact_events(),
                    parameters.model.is_static() ?
                      ContactNodes::of_static_body :
                    has_contact_mass ? ContactNodes::with_mass :
                                       ContactNodes::massless,
                    parameters.time.has_error_control() ?
                      parameters.time.tolerance :
                      1e-13)
  {
    set_initial_state();
  }



  template <int dim>
  void
  Simulation<dim>::set_initial_state()
  {
    state_ = initial_state(parameters_,
                           data,
                           discretization_,
                           operator_,
                           law,
                           controller.propose(0.).size,
                           loads,
                           warnings_);
    measurements.measure(state_, data, record_);
    if (!parameters_.model.has_displacement())
      record_.contact_impulse = record_.contact_force; // there is none
    record_.energy_terms = energy_.energy(state_);
    record_.energy       = record_.energy_terms.sum();
    if (!std::isfinite(record_.energy))
      throw InputError("Initial values: the energy of the initial state is " +
                       std::to_string(record_.energy) +
                       "\n  allowed: expressions that are finite, with their "
                       "gradients, in the whole body");
    error_norm.add(record_.energy_terms);
    energy_watch.start(record_.energy_terms);
    get_contact_values(state_, contact_values);
    event_locator.start(contact_values, events_);
    max_penetration_   = record_.penetration;
    max_contact_force_ = record_.contact_force;
  }



  template <int dim>
  void
  Simulation<dim>::add_observer(const Observer &observer)
  {
    observers.push_back(observer);
  }



  template <int dim>
  void
  Simulation<dim>::notify() const
  {
    for (const Observer &observer : observers)
      observer(*this);
  }



  template <int dim>
  void
  Simulation<dim>::run()
  {
    if (!is_restored)
      notify();
    StepResult result;
    while (!controller.is_finished(state_.time))
      {
        const TimeStep time_step = controller.propose(state_.time);
        if (attempt(time_step, result))
          {
            accept(time_step, result);
            notify();
            attempts_.clear();
          }
      }
  }



  template <int dim>
  bool
  Simulation<dim>::is_prescribed_step() const
  {
    return record_.step == 0 && parameters_.has_prescribed_start();
  }



  template <int dim>
  void
  Simulation<dim>::compute_step(const TimeStep   &time_step,
                                const ContactMode mode,
                                StepResult       &result)
  {
    try
      {
        if (is_prescribed_step())
          integrator->prescribed_step(state_, time_step, result);
        else
          integrator->step(state_, record_.energy, time_step, mode, result);
      }
    catch (const ComputationError &error)
      {
        result.failure = error.what();
      }
    if (result.failure.empty() && !std::isfinite(result.energy.sum()))
      result.failure = "the solution is not finite\n  remedy:  smaller initial "
                       "values and sources, or a smaller Time/Step size";
  }



  template <int dim>
  double
  Simulation<dim>::relative_error(const StepResult &result)
  {
    if (!parameters_.time.has_error_control())
      return std::numeric_limits<double>::quiet_NaN();
    EnergyTerms error = result.error;
    if (law.is_active && law.compliance == 0. && has_contact_mass &&
        event_locator.mode() == ContactMode::unilateral &&
        result.n_iterations > 0) // a node was pushed back in some stage
      error.kinetic = 0.;
    return error_norm(error, result.energy) / parameters_.time.tolerance;
  }



  template <int dim>
  bool
  Simulation<dim>::attempt(const TimeStep &time_step, StepResult &result)
  {
    const auto        begin = std::chrono::steady_clock::now();
    const ContactMode mode  = event_locator.mode();
    compute_step(time_step, mode, result);

    StepAttempt attempt{state_.time, time_step.size};
    if (!result.failure.empty())
      {
        attempt.reason = "failed";
        if (!controller.retry_smaller(time_step))
          give_up(time_step, result.failure);
      }
    else
      {
        attempt.error = relative_error(result);
        if (!controller.is_accurate(attempt.error))
          {
            attempt.reason = "tolerance";
            controller.reject(time_step, attempt.error);
          }
        else if (!respects_contact(time_step, result))
          attempt.reason = "contact";
        else
          {
            attempt.reason      = name_of(time_step.target);
            attempt.is_accepted = true;
            controller.accept(time_step, attempt.error);
          }
      }
    if (event_locator.mode() != mode)
      controller.restart(event_locator.mode() == ContactMode::closed);
    attempt.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
        .count();
    attempts_.push_back(attempt);
    if (attempt.is_accepted)
      return true;

    ++n_rejected_steps_;
    if ((!result.failure.empty() || !controller.is_accurate(attempt.error)) &&
        controller.is_exhausted(time_step, state_.time))
      give_up(time_step, describe_exhaustion(attempt, result.failure));
    return false;
  }



  template <int dim>
  bool
  Simulation<dim>::respects_contact(const TimeStep &time_step,
                                    StepResult     &result)
  {
    get_contact_values(result.state, contact_values);
    EventLocator::Finding finding;
    if (is_prescribed_step())
      event_locator.hold_nothing();
    const ContactMode mode       = event_locator.mode();
    const double      mechanical = std::max({error_norm.mechanical_energy(),
                                             result.energy.elastic,
                                             result.energy.kinetic});
    if (mode != ContactMode::unilateral)
      finding = event_locator.examine(
        contact_values,
        time_step.target == TimeStep::event,
        {mechanical, std::sqrt(2. * parameters_.model.inertia * mechanical)});

    if (finding.kind == EventLocator::Finding::at_start &&
        !finding.is_of_all_nodes)
      event_locator.hold_nothing();
    else if (finding.kind == EventLocator::Finding::at_start)
      {
        event_locator.switch_at_start(finding.time, events_);
        if (law.compliance == 0. && !has_contact_equilibrium &&
            event_locator.mode() == ContactMode::closed)
          {
            transition.impact(state_,
                              record_.energy_terms,
                              record_.contact_impulse,
                              record_.numerical_dissipation);
            record_.energy = record_.energy_terms.sum();
          }
      }
    else if (finding.kind == EventLocator::Finding::within)
      {
        // An interpolant that misses the zero so often is not to be trusted.
        if (++n_retakes < 10)
          controller.aim_at(finding.time);
        else
          event_locator.hold_nothing();
      }
    else
      {
        event_locator.accept(contact_values, finding, events_);
        n_retakes = 0;
        finish_contact(time_step,
                       mode,
                       finding.kind == EventLocator::Finding::at_end,
                       result);
        return true;
      }
    return false;
  }



  template <int dim>
  void
  Simulation<dim>::finish_contact(const TimeStep   &time_step,
                                  const ContactMode mode,
                                  const bool        has_event,
                                  StepResult       &result)
  {
    if (has_event && has_contact_equilibrium)
      {
        compute_step(time_step, ContactMode::unilateral, result);
        if (!result.failure.empty())
          give_up(time_step, result.failure);
        get_contact_values(result.state, contact_values);
        event_locator.set_present(contact_values);
        return;
      }
    transition.finish_pressure(has_event && mode == ContactMode::open, result);
    if (law.compliance == 0. && mode != ContactMode::closed &&
        event_locator.mode() == ContactMode::closed)
      transition.impact(result.state,
                        result.energy,
                        result.impulse,
                        result.numerical_dissipation);
  }



  template <int dim>
  void
  Simulation<dim>::get_contact_values(const State   &state,
                                      ContactValues &values) const
  {
    values.time = state.time;
    discretization_.contact_values(1, state.displacement, values.displacement);
    discretization_.contact_values(1, state.velocity, values.velocity);
    values.pressure = state.contact_pressure;
  }



  template <int dim>
  void
  Simulation<dim>::give_up(const TimeStep    &time_step,
                           const std::string &reason) const
  {
    std::ostringstream place;
    place << "step " << record_.step + 1 << ", from t = " << state_.time
          << " to " << time_step.end << ": ";
    throw ComputationError(place.str() + reason);
  }



  template <int dim>
  void
  Simulation<dim>::accept(const TimeStep &time_step, StepResult &result)
  {
    const StepRecord old_record = record_;
    state_.swap(result.state);
    measurements.measure(state_, data, record_);
    ++record_.step;
    record_.step_size    = time_step.size;
    record_.iterations   = result.n_iterations;
    record_.energy_terms = result.energy;
    record_.energy       = result.energy.sum();
    record_.work += result.work;
    record_.dissipation += result.dissipation;
    record_.numerical_dissipation += result.numerical_dissipation;
    record_.contact_impulse += result.impulse;

    error_norm.add(result.energy);
    max_penetration_   = std::max(max_penetration_, record_.penetration);
    max_contact_force_ = std::max(max_contact_force_, record_.contact_force);
    if (result.is_prescribed)
      {
        energy_watch.start(record_.energy_terms);
        return;
      }
    max_energy_increase_ =
      std::max(max_energy_increase_,
               record_.energy - old_record.energy - result.work);
    const std::string warning =
      energy_watch.add(record_.step, record_.time, record_.energy_terms);
    if (!warning.empty())
      warnings_.push_back(warning);
  }



  template <int dim>
  SolverCounters
  Simulation<dim>::counters() const
  {
    SolverCounters sum = step_solver->counters();
    for (const SolverCounters &part :
         {integrator->counters(), transition.counters()})
      sum += part;
    return sum;
  }



  template class Simulation<1>;
  template class Simulation<2>;
  template class Simulation<3>;
} // namespace ThermoContact
