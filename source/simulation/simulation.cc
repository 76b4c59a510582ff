// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/stop_watch.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/simulation/first_step.h>
#include <thermocontact/simulation/initial_state.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/load_scan.h>
#include <thermocontact/space/state_serialiser.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /** The line about the loads of a step in the message of its failure. */
    template <int dim>
    std::string
    load_description(const Body<dim> &body, const double from, const double to)
    {
      const std::string loads = changing_loads(body.scene, body.data, from, to);
      return loads.empty() ? "" : "\n  load:    " + loads + " changes then";
    }
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const Scene               &scene,
                              const MPI_Comm             communicator,
                              const AssembledSpace<dim> *shared)
    : Simulation(nullptr, &scene, communicator, shared)
  {}



  template <int dim>
  Simulation<dim>::Simulation(const Parameters          &parameters,
                              const MPI_Comm             communicator,
                              const AssembledSpace<dim> *shared)
    : Simulation(std::make_unique<const Scene>(parameters),
                 nullptr,
                 communicator,
                 shared)
  {}



  template <int dim>
  Simulation<dim>::Simulation(std::unique_ptr<const Scene> own,
                              const Scene                 *borrowed,
                              const MPI_Comm               communicator,
                              const AssembledSpace<dim>   *shared)
    : own_scene(std::move(own))
    , scene_(own_scene ? *own_scene : *borrowed)
    , body_(scene_, communicator, shared)
    , measurements(body_)
    , integrator(make_integrator(body_))
    , reset(body_)
    , tracker(body_, reset)
    , controller(parameters().time,
                 parameters().output,
                 scene_.scheme.order,
                 DimensionTraits<dim>::has_cheap_factors ?
                   StepLadder{4, false} :
                   StepLadder{1, true})
    , error_norm(body_.energy.steady_profile_energy(),
                 scene_.material.heating,
                 scene_.material.inertia,
                 scene_.linear_solver.is_iterative ?
                   scene_.linear_solver.tolerance :
                   Tolerances::rounding_of_solution)
    , energy_monitor(scene_)
    , spatial_error_monitor(scene_, discretization())
  {
    std::vector<std::string> warnings; // after warnings of the initial state
    controller.follow(load_history(scene_, body_.data, warnings));
    set_initial_state();
    history_.warnings.insert(history_.warnings.end(),
                             warnings.begin(),
                             warnings.end());
  }



  template <int dim>
  Simulation<dim>::~Simulation() = default;



  template <int dim>
  void
  Simulation<dim>::set_initial_state()
  {
    state_             = initial_state(body_,
                           reset,
                           controller.propose(0.).size,
                           history_.warnings);
    StepRecord &record = history_.record;
    tracker.start(state_, history_.events);
    if (controller.followed_loads().break_at(0.) != nullptr)
      pass_present_break(body_.energy.energy(state_));
    measurements.measure(state_, record);
    history_.warn(dispersion_warning(scene_));
    history_.warn(oscillation_warning(scene_));
    history_.warn(impact_warning(scene_));
    history_.warn(resolution_warning(scene_));
    if (!scene_.fields.has_displacement)
      record.contact_impulse = record.contact_force; // there is none
    record.energy_terms = body_.energy.energy(state_);
    record.energy       = record.energy_terms.sum();
    if (!std::isfinite(record.energy))
      throw InputError("Initial values: the energy of the initial state is " +
                       std::to_string(record.energy) +
                       "\n  allowed: expressions that are finite, with their "
                       "gradients, in the whole body");
    error_norm.add(record.energy_terms);
    energy_monitor.start(record.energy_terms);
    tracker.start(state_, history_.events);
    history_.add_maxima(scene_, gap_rate());
  }



  template <int dim>
  void
  Simulation<dim>::run(const Observers &observers)
  {
    const auto notify = [&]() {
      for (const Observer &observer : observers)
        observer(*this);
    };
    if (!is_restored)
      notify();
    else if (!controller.is_finished(state_.time))
      compensate_break();
    while (step())
      notify();
  }



  template <int dim>
  bool
  Simulation<dim>::step()
  {
    history_.attempts.clear();
    if (!controller.is_finished(state_.time))
      prepare_step();
    while (!controller.is_finished(state_.time))
      {
        const TimeStep time_step = controller.propose(state_.time);
        if (attempt(time_step))
          {
            accept(time_step);
            return true;
          }
      }
    return false;
  }



  template <int dim>
  bool
  Simulation<dim>::attempt(const TimeStep &time_step)
  {
    StepAttempt attempt{state_.time, time_step.size};
    {
      const StopWatch   watch(attempt.wall_seconds);
      const ContactMode mode   = tracker.mode();
      const LoadBreak  *passed = nullptr;
      compute_step(time_step);
      const Verdict verdict = judge(time_step);
      attempt.error         = verdict.error;
      switch (verdict.kind)
        {
          case Verdict::failed:
            break;
          case Verdict::inaccurate:
            attempt.reason = rejected_by_tolerance;
            controller.reject(time_step, verdict.error, result.order);
            break;
          case Verdict::contact_changes:
            attempt.reason = "contact";
            together([&]() {
              if (const std::optional<double> end = tracker.prepare(
                    verdict.finding, state_, record().energy_terms))
                controller.aim_at(*end);
            });
            break;
          case Verdict::accept:
            attempt.reason      = name_of(time_step.target);
            passed              = commit(verdict.finding);
            attempt.is_accepted = result.failure.empty();
            if (attempt.is_accepted)
              controller.accept(time_step, verdict.error, result.order);
        }
      if (result.failure.empty())
        restart_controller(mode, passed);
      else
        {
          attempt.reason = "failed";
          if (!controller.retry_smaller(time_step))
            give_up(time_step, result.failure);
        }
    }
    history_.attempts.push_back(attempt);
    if (attempt.is_accepted)
      return true;

    ++history_.n_rejected_steps;
    if ((!result.failure.empty() || attempt.reason == rejected_by_tolerance) &&
        controller.is_exhausted(time_step, state_.time))
      give_up(time_step,
              describe_exhaustion(history_.attempts,
                                  result.failure,
                                  parameters()));
    return false;
  }



  template <int dim>
  template <class Action>
  void
  Simulation<dim>::together(const Action &action)
  {
    try
      {
        action();
      }
    catch (const ComputationError &error)
      {
        result.failure = error.what();
      }
    catch (const InputError &error) // of a coefficient of the temperature
      {
        result.failure = error.what();
      }
    result.agree(discretization().communicator());
  }



  template <int dim>
  typename Simulation<dim>::Verdict
  Simulation<dim>::judge(const TimeStep &time_step) const
  {
    Verdict verdict;
    if (!result.failure.empty())
      return verdict;
    verdict.error = relative_error();
    verdict.kind  = Verdict::inaccurate;
    if (!controller.is_accurate(time_step, verdict.error))
      return verdict;
    verdict.finding =
      tracker.judge(time_step,
                    result,
                    error_norm.mechanical_energy(result.energy));
    verdict.kind = verdict.finding.kind == EventLocator::Finding::at_start ||
                       verdict.finding.kind == EventLocator::Finding::within ?
                     Verdict::contact_changes :
                     Verdict::accept;
    return verdict;
  }



  template <int dim>
  void
  Simulation<dim>::accept(const TimeStep &time_step)
  {
    state_.swap(result.state);
    measurements.measure(state_, history_.record);
    history_.add_step(time_step, result);
    history_.add_maxima(scene_, gap_rate());
    error_norm.add(result.energy);
    spatial_error_monitor.add(state_, record());
    if (result.is_prescribed)
      energy_monitor.start(result.energy);
    else
      history_.warn(energy_monitor.add(
        record().step, record().time, result.energy, result.algebraic));
    if (controller.is_finished(state_.time))
      {
        history_.warn(spatial_error_monitor.take_warning());
        history_.warn(warning_of_largest_force(scene_, history_));
      }
  }



  template <int dim>
  void
  Simulation<dim>::restart_controller(const ContactMode      old_mode,
                                      const LoadBreak *const passed)
  {
    if (passed != nullptr && passed->is_jump)
      controller.restart(StepController::at_change);
    if (tracker.mode() != old_mode)
      controller.restart(tracker.mode() == ContactMode::closed ?
                           StepController::at_touch :
                           StepController::at_change);
  }



  template <int dim>
  double
  Simulation<dim>::gap_rate() const
  {
    if (!body_.obstacle.is_active())
      return 0.;
    return controller.followed_loads().break_at(state_.time) != nullptr ?
             nan :
             state_.gap_rate.front();
  }



  template <int dim>
  bool
  Simulation<dim>::is_prescribed_step() const
  {
    return record().step == 0 && scene_.has_prescribed_start;
  }



  template <int dim>
  void
  Simulation<dim>::compute_step(const TimeStep &time_step)
  {
    const State &start = tracker.start_state(state_);
    result.old_energy  = tracker.start_energy(record().energy_terms);
    together([&]() {
      if (is_prescribed_step())
        integrator->prescribed_step(start, time_step, result);
      else
        integrator->step(start, time_step, tracker.mode(), result);
      result.state.load_time = time_step.last_loads;
      result.state.jump_time = start.jump_time; // no stage moves it at once
      if (result.failure.empty())
        reset.complete_step(tracker.mode(), result);
      if (result.failure.empty() &&
          !std::isfinite(result.energy.sum() + result.work +
                         result.dissipation))
        result.failure = "the solution is not finite\n  remedy:  smaller "
                         "initial values and sources, or a smaller Time/Step "
                         "size";
    });
    if (result.failure.empty() && parameters().time.has_error_control())
      error_norm.note_attempt(result.energy, rigid_displacement());
    take_warnings();
  }



  template <int dim>
  void
  Simulation<dim>::take_warnings()
  {
    for (const std::string &warning :
         integrator->stage_solver().take_warnings())
      history_.warn(warning);
  }



  template <int dim>
  double
  Simulation<dim>::rigid_displacement() const
  {
    return scene_.sources.has_moving_end ?
             result.state.displacement.linfty_norm() :
             0.;
  }



  template <int dim>
  double
  Simulation<dim>::relative_error() const
  {
    const TimeParameters &time = parameters().time;
    if (!time.has_error_control())
      return nan;
    EnergyTerms error = result.error;
    if (scene_.contact.has_impacts() &&
        tracker.mode() == ContactMode::unilateral &&
        result.is_pushed) // velocities jump within the step
      error.kinetic = 0.;
    return error_norm(error, result.energy, rigid_displacement()) /
           time.tolerance;
  }



  template <int dim>
  const LoadBreak *
  Simulation<dim>::commit(const EventLocator::Finding &finding)
  {
    together([&]() { tracker.accept(finding, result, history_.events); });
    const LoadBreak *const passed =
      result.failure.empty() ? pass_break() : nullptr;
    take_warnings();
    if (result.failure.empty())
      tracker.confirm();
    else
      tracker.take_back(history_.events);
    return passed;
  }



  template <int dim>
  const LoadBreak *
  Simulation<dim>::pass_break()
  {
    const double     time = result.state.time;
    const LoadBreak *at   = controller.followed_loads().break_at(time);
    if (at == nullptr)
      return nullptr;
    result.state.load_time = at->new_time;
    tracker.forget_last();
    together([&]() {
      if (body_.obstacle.is_active())
        tracker.pass_slope_discontinuity(*at, result, history_.events);
      if (at->is_jump &&
          reset.pass_discontinuity(tracker.closed_nodes(result), *at, result))
        tracker.jump(result.state, history_.events);
    });
    if (result.failure.empty())
      passed_break = time;
    else
      result.failure = text("inputs have a discontinuity at t = ",
                            QuantityUnits(parameters()).text("time", time),
                            ": ",
                            result.failure);
    return at;
  }



  template <int dim>
  template <class Action>
  void
  Simulation<dim>::change_present(const EnergyTerms &energy,
                                  const Action      &action)
  {
    result        = StepResult();
    result.state  = state_;
    result.energy = energy;
    action();
    take_warnings();
    if (!result.failure.empty())
      throw ComputationError(result.failure +
                             load_description(body_, state_.time, state_.time));
    state_.swap(result.state);
  }



  template <int dim>
  const LoadBreak *
  Simulation<dim>::pass_present_break(const EnergyTerms &energy)
  {
    const LoadBreak *passed = nullptr;
    change_present(energy, [&]() { passed = pass_break(); });
    return passed;
  }



  template <int dim>
  void
  Simulation<dim>::prepare_step()
  {
    heat_fixed_end();
    if (record().step == 0)
      controller.limit_first_step(
        first_step_of_heat(body_, state_, record().energy_terms.thermal));
  }



  template <int dim>
  void
  Simulation<dim>::heat_fixed_end()
  {
    if (!scene_.fields.has_temperature || heated_time == state_.time)
      return;
    heated_time = state_.time;
    const LoadBreak *const at =
      controller.followed_loads().break_at(state_.time);
    if (state_.time != 0. && at == nullptr)
      return;
    const ContactMode mode       = tracker.mode();
    bool              was_heated = false;
    change_present(record().energy_terms, [&]() {
      together([&]() {
        was_heated =
          reset.heat_fixed_end(tracker.closed_nodes(result), at, result);
        if (was_heated && reset.moves_at_once())
          tracker.jump(result.state, history_.events);
      });
    });
    if (!was_heated)
      return;
    restart_controller(mode, nullptr);
    history_.add_jump(result);
    error_norm.add(result.energy);
  }



  template <int dim>
  void
  Simulation<dim>::give_up(const TimeStep    &time_step,
                           const std::string &reason) const
  {
    const QuantityUnits units(parameters());
    throw ComputationError(
      text("step ",
           record().step + 1,
           ", from t = ",
           units.text("time", state_.time),
           " to ",
           units.text("time", time_step.end),
           ": ",
           reason,
           load_description(body_, state_.time, time_step.end)));
  }



  template <int dim>
  SolverCounters
  Simulation<dim>::counters() const
  {
    SolverCounters sum = integrator->stage_solver().counters();
    sum += integrator->own_counters();
    sum += reset.counters();
    return sum;
  }



  template <int dim>
  template <class Archive>
  void
  Simulation<dim>::archive_progress(Archive &archive)
  {
    archive &state_ &history_ &passed_break &heated_time;
    archive &controller &error_norm &energy_monitor &spatial_error_monitor
      &tracker;
  }



  template <int dim>
  SavedRun
  Simulation<dim>::save() const
  {
    std::ostringstream stream;
    {
      boost::archive::binary_oarchive archive(stream,
                                              boost::archive::no_header);
      // one function says what is written and read; writing changes nothing
      const_cast<Simulation<dim> *>(this)->archive_progress(archive);
      const RetainedFactorizations retained =
        integrator->stage_solver().retained();
      const SolverCounters    of_integrator     = integrator->own_counters();
      const SolverCounters    of_reset          = reset.counters();
      const std::vector<bool> retained_by_reset = reset.retained();
      archive << retained << of_integrator << of_reset << retained_by_reset;
    }
    return {stream.str(), StateSerialiser<dim>(discretization()).save(state_)};
  }



  template <int dim>
  void
  Simulation<dim>::restore(const std::string                        &progress,
                           const unsigned int                        n_ranks,
                           const std::function<bool(std::string &)> &next_nodes)
  {
    const MPI_Comm         communicator = discretization().communicator();
    const unsigned int     n = Utilities::MPI::n_mpi_processes(communicator);
    RetainedFactorizations retained;
    SolverCounters         of_integrator, of_reset;
    std::vector<bool>      retained_by_reset;
    std::string            fault;
    const StateSerialiser<dim> values(discretization());
    std::size_t                n_set = 0, n_saved = 0;
    const std::size_t          n_nodes =
      n == n_ranks ? values.n_nodes() :
                              Utilities::MPI::sum(values.n_nodes(), communicator);
    try
      {
        std::istringstream              stream(progress);
        boost::archive::binary_iarchive archive(stream,
                                                boost::archive::no_header);
        archive_progress(archive);
        archive >> retained >> of_integrator >> of_reset >> retained_by_reset;
        for (std::string nodes; next_nodes(nodes);)
          {
            n_set += values.restore(nodes, state_);
            n_saved += values.n_nodes_of(nodes);
          }
        if (n_set != values.n_nodes() || n_saved != n_nodes)
          fault = "vectors of another discretisation";
      }
    catch (const std::exception &error)
      {
        fault = error.what();
      }
    fault = first_fault(fault, communicator); // perhaps on one rank alone
    if (!fault.empty())
      throw InputError("--resume: the checkpoint does not fit this scene: " +
                       fault + "\n  remedy:  run without --resume");
    integrator->stage_solver().restore(retained);
    integrator->restore_own_counters(of_integrator);
    reset.restore(retained_by_reset, of_reset);
    if (n != n_ranks)
      history_.warn(
        text("resumed at t = ",
             QuantityUnits(parameters()).text("time", state_.time),
             " on another number of ranks, ",
             n,
             " instead of ",
             n_ranks,
             ": from there on equal to an uninterrupted run to the tolerance "
             "of the solver, not bit for bit"));
    is_restored = true;
  }



  template <int dim>
  void
  Simulation<dim>::compensate_break()
  {
    if (passed_break == state_.time ||
        controller.followed_loads().break_at(state_.time) == nullptr)
      return;
    const ContactMode      mode   = tracker.mode();
    const LoadBreak *const passed = pass_present_break(record().energy_terms);
    restart_controller(mode, passed);
    measurements.measure(state_, history_.record);
    history_.add_jump(result);
    history_.add_maxima(scene_, gap_rate());
    error_norm.add(result.energy);
  }



  template class Simulation<1>;
  template class Simulation<2>;
  template class Simulation<3>;
} // namespace ThermoContact
