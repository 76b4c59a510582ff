// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/linear_system.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/dirk_integrator.h>
#include <thermocontact/time/make_stage_solver.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Whose abscissae are in the order of time. */
    const std::string scheme_in_order = "sdirk3";
  } // namespace



  template <int dim>
  DirkIntegrator<dim>::DirkIntegrator(Body<dim> &body)
    : body(body)
    , of_scheme(butcher_tableau(body.scene.scheme.name))
    , in_order(std::is_sorted(of_scheme.c.begin(), of_scheme.c.end()) ?
                 of_scheme :
                 butcher_tableau(scheme_in_order))
    , solver(body.nonlinear ? nullptr : make_stage_solver(body))
    , newton(body.nonlinear ? std::make_unique<NewtonStage<dim>>(body) :
                              nullptr)
    , driven(body)
    , stages(of_scheme.n_stages())
    , known(body.make_state())
    , difference(of_scheme.has_error_estimate() ||
                     in_order.has_error_estimate() ?
                   known :
                   State())
    , heat_load(body.discretization.make_vector(Field::temperature))
    , momentum_load(body.discretization.make_vector(Field::displacement))
  {
    for (StageRates &stage : stages)
      known.set_layout(stage);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::set_known_values(const State       &state,
                                        const double       step_size,
                                        const unsigned int i)
  {
    for (unsigned int k = 0; k < known.vectors().size(); ++k)
      {
        sum.clear();
        for (unsigned int j = 0; j < i; ++j)
          sum.push_back({step_size * tableau->a[i][j], stages[j].vectors()[k]});
        set_sum(*known.vectors()[k], *state.vectors()[k], sum.data(), i);
      }
    const StageRates *const last = i > 0 ? &stages[i - 1] : nullptr;
    known.contact                = last ? last->contact : state.contact;
  }



  template <int dim>
  double
  DirkIntegrator<dim>::load_time(const State       &state,
                                 const TimeStep    &time_step,
                                 const unsigned int i) const
  {
    return i + 1 == tableau->n_stages() ?
             time_step.last_loads :
             state.time + tableau->c[i] * time_step.size;
  }



  template <int dim>
  void
  DirkIntegrator<dim>::solve_stage(const unsigned int i,
                                   const double       tau,
                                   const ContactMode  mode)
  {
    StageRates &stage = stages[i];
    if (newton)
      newton->solve(
        i, tau, mode, driven, known, heat_load, momentum_load, stage);
    else
      {
        const auto loads =
          driven.constrain(i, {heat_load, momentum_load}, known);
        solver->solve(known, tau, loads.heat, loads.momentum, mode, stage);
      }
    if (stage.failure.empty() &&
        (i + 1 < tableau->n_stages() || tableau->has_error_estimate() ||
         driven.is_active() || body.boundary_flows.is_active()))
      set_difference(stage.acceleration,
                     1. / tau,
                     stage.velocity,
                     known.velocity);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::advance(const unsigned int i, const double tau)
  {
    StageRates &stage = stages[i];
    known.advance(known, tau, stage);
    // the known values of a driven end are those of its stage already
    driven.complete(i, stage);
    set_equal(known.velocity, stage.velocity);
    known.contact = stage.contact;
  }



  template <int dim>
  void
  DirkIntegrator<dim>::step(const State      &state,
                            const TimeStep   &time_step,
                            const ContactMode mode,
                            StepResult       &result)
  {
    result.is_prescribed = false;
    choose_stops(state, mode);
    const bool can_close = mode == ContactMode::unilateral &&
                           body.scene.contact.order == NodeOrder::viscous;
    tableau = can_close && is_partial(state) ? &in_order : &of_scheme;
    solve_stages(state, time_step, mode, result);
    if (result.failure.empty() && can_close && tableau != &in_order &&
        closes_nodes(state))
      {
        tableau = &in_order;
        solve_stages(state, time_step, mode, result);
      }
    result.order = tableau->order;
    if (!result.failure.empty())
      return;
    if (result.state.contact.pressure.size() != known.contact.pressure.size())
      result.state = known; // the first one: gets its layout
    else
      result.state.swap(known);
    result.state.time = time_step.end;
    result.state.known_penetration.clear();
    result.is_pushed = pushes();
    find_closed_nodes(state, mode, result);
    result.energy = body.energy.energy(result.state);
    if (tableau->has_error_estimate())
      estimate_error(time_step.size, mode, result);
    if (tableau->n_stages() == 1)
      result.numerical_dissipation =
        body.energy.numerical_dissipation(state, result.state);
    else
      {
        // no sum over stages, whose lengths only the motion decides
        if (body.scene.contact.has_dashpot() && !result.is_pushed)
          result.contact_dissipation =
            body.energy.obstacle_energy(state) -
            body.energy.obstacle_energy(result.state);
        result.close_balance();
      }
  }



  template <int dim>
  bool
  DirkIntegrator<dim>::pushes() const
  {
    for (unsigned int i = 0; i < tableau->n_stages(); ++i)
      for (const double pressure : stages[i].contact.pressure)
        if (pressure != 0.)
          return true;
    return false;
  }



  template <int dim>
  void
  DirkIntegrator<dim>::solve_stages(const State      &state,
                                    const TimeStep   &time_step,
                                    const ContactMode mode,
                                    StepResult       &result)
  {
    const double tau = tableau->gamma() * time_step.size;

    result.start_sums();
    result.n_iterations = 0;
    start_drives(state, time_step);
    for (unsigned int i = 0; i < tableau->n_stages(); ++i)
      {
        StageRates &stage = stages[i];
        set_known_values(state, time_step.size, i);
        if (body.obstacle.is_active())
          place_obstacle(i, tau, mode);
        known.load_time = load_time(state, time_step, i);
        body.loads.assemble(known.load_time, heat_load, momentum_load);
        solve_stage(i, tau, mode);
        result.failure = stage.failure;
        result.n_iterations += stage.n_iterations;
        if (!result.failure.empty())
          return;

        const double weight = tableau->b()[i] * time_step.size;
        result.algebraic += weight * stage.algebraic_power;
        advance(i, tau);
        result.add_stage(weight,
                         {known,
                          stage.temperature_rate,
                          stage.acceleration,
                          heat_load,
                          momentum_load},
                         body);
      }
  }



  template <int dim>
  void
  DirkIntegrator<dim>::keep_contact(const ContactMode          mode,
                                    const std::vector<double> &pressure)
  {
    const std::vector<bool> is_closed = closed_at_end(mode);
    if (std::find(is_closed.begin(), is_closed.end(), true) == is_closed.end())
      return;
    std::vector<double> displacement;
    body.contact_end().get_values(Field::displacement,
                                  difference.displacement,
                                  displacement);
    std::vector<AffineLaw> laws(displacement.size());
    double                 largest = 0.;
    for (unsigned int i = 0; i < laws.size(); ++i)
      if (is_closed[i])
        {
          laws[i].compliance =
            NodeLaw(body.scene.contact.law_under(pressure[i], i))
              .tangent_of_pressure(pressure[i])
              .compliance;
          largest = std::max(largest, std::abs(displacement[i]));
        }
    // a rigid obstacle holds nodes to less than this already
    if (largest >
        (body.law().is_rigid() ? Tolerances::negligible_displacement : 0.) *
          difference.displacement.linfty_norm())
      stage_solver().subtract_response(laws, displacement, difference);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::estimate_error(const double      step_size,
                                      const ContactMode mode,
                                      StepResult       &result)
  {
    const bool is_static =
      body.scene.fields.has_displacement && body.scene.material.is_static();
    const auto &of_motion = is_static ? tableau->static_b : tableau->embedded_b;
    const auto &of_heat =
      body.equations.is_coupled() ? of_motion : tableau->embedded_b;
    for (unsigned int k = 0; k < difference.vectors().size(); ++k)
      {
        const auto &embedded = k == 0 ? of_heat : of_motion;
        sum.clear();
        for (unsigned int i = 0; i < tableau->n_stages(); ++i)
          if (const double weight = tableau->b()[i] - embedded[i]; weight != 0.)
            sum.push_back({step_size * weight, stages[i].vectors()[k]});
        Vector &vector = *difference.vectors()[k];
        set_zero(vector);
        set_sum(vector, vector, sum.data(), sum.size());
      }
    const std::vector<double> &pressure = result.state.contact.pressure;
    if (can_change_at_once(mode))
      keep_contact(mode, pressure);
    result.error = body.energy.difference_energy(difference, pressure);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::solve_heat_alone(const State &state,
                                        const double tau,
                                        Vector      &rate)
  {
    LinearSystem<dim> heat_system(
      body.equations, stage_coefficients(tau).of(Field::temperature));
    counters_.factorizations += heat_system.n_factorizations();
    Vector heat_rhs(heat_load), momentum_rhs(momentum_load);
    known            = state;
    const auto loads = driven.constrain(0, {heat_load, momentum_load}, known);
    body.equations.stage_rhs(
      known, tau, loads.heat, momentum_load, heat_rhs, momentum_rhs);
    body.equations.add_heating(state.velocity, -1., heat_rhs);
    heat_system.solve(rate, heat_rhs);
    ++counters_.solves;
    driven.complete(0, stages[0]);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::prescribed_step(const State    &state,
                                       const TimeStep &time_step,
                                       StepResult     &result)
  {
    const double tau   = time_step.size;
    StageRates  &stage = stages[0];
    body.loads.assemble(time_step.last_loads, heat_load, momentum_load);
    static const std::vector<std::vector<double>> one_stage  = {{1.}};
    static const std::vector<double>              one_weight = {1.};
    driven.start(state, tau, {one_stage, one_weight, {time_step.last_loads}});
    if (body.scene.fields.has_temperature)
      solve_heat_alone(state, tau, stage.temperature_rate);

    result.failure.clear();
    result.n_iterations    = 0;
    result.is_prescribed   = true;
    result.state           = state;
    result.state.time      = time_step.end;
    result.state.load_time = time_step.last_loads;
    result.state.temperature.add(tau, stage.temperature_rate);
    result.state.displacement.add(tau, state.velocity);

    set_pressures_of_law(body, result.state);

    result.start_sums();
    if (!driven.is_active())
      set_zero(stage.acceleration); // the velocity stays
    result.add_stage(tau,
                     {result.state,
                      stage.temperature_rate,
                      stage.acceleration,
                      heat_load,
                      momentum_load},
                     body);
    result.energy = body.energy.energy(result.state);
    result.close_balance();
  }



  template <int dim>
  void
  DirkIntegrator<dim>::start_drives(const State    &state,
                                    const TimeStep &time_step)
  {
    const bool obstacle_moves = body.obstacle.is_active();
    if (!driven.is_active() && !obstacle_moves)
      return;
    StageTimes loads_at{tableau->a, tableau->b(), {}};
    for (unsigned int i = 0; i < tableau->n_stages(); ++i)
      loads_at.times.push_back(load_time(state, time_step, i));
    driven.start(state, time_step.size, loads_at);
    if (obstacle_moves)
      start_obstacle(state, time_step, loads_at);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::start_obstacle(const State      &state,
                                      const TimeStep   &time_step,
                                      const StageTimes &loads_at)
  {
    std::vector<TimeDerivatives>
               obstacle; // at the time that was asked for last
    const auto derivatives_at = [&](const double time) {
      body.obstacle.get_derivatives(time, obstacle);
      return obstacle;
    };
    const auto rates_of = [](const std::vector<TimeDerivatives> &functions) {
      std::vector<double> rates;
      for (const TimeDerivatives &function : functions)
        rates.push_back(function.first);
      return rates;
    };
    gaps.start(loads_at,
               time_step.size,
               state.gap,
               body.scene.contact.has_impacts(),
               derivatives_at);
    if (tableau->n_stages() > 1)
      {
        const std::vector<double> new_rates = rates_of(obstacle);
        gaps.set_accelerations(rates_of(derivatives_at(time_step.first_loads)),
                               new_rates);
        return;
      }
    std::vector<double> velocity;
    body.contact_end().get_values(Field::displacement,
                                  state.velocity,
                                  velocity);
    gaps.set_accelerations(velocity, gaps.stages().back().rates);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::place_obstacle(const unsigned int i,
                                      const double       tau,
                                      const ContactMode  mode)
  {
    const PrescribedStage &obstacle = gaps.stages()[i];
    known.gap                       = obstacle.values;
    known.gap_rate                  = obstacle.rates;
    known.known_penetration.clear();
    if (mode != ContactMode::closed || !body.scene.contact.has_impacts() ||
        !follow_motion(stages[i].held_at))
      return;
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::displacement))
      known.velocity.begin()[entry] =
        obstacle.rates[node] - tau * obstacle.accelerations[node];
    known.known_penetration = obstacle.rates;
    for (double &penetration : known.known_penetration) // 0 at the end
      penetration *= -tau;
  }



  template <int dim>
  bool
  DirkIntegrator<dim>::can_change_at_once(const ContactMode mode) const
  {
    const SceneContact &contact = body.scene.contact;
    return contact.law->is_active() && !contact.has_mass() &&
           (mode == ContactMode::unilateral || contact.is_in_equilibrium());
  }



  template <int dim>
  bool
  DirkIntegrator<dim>::is_partial(const State &state) const
  {
    const auto &pressures = state.contact.pressure;
    const auto  n_open    = std::count(pressures.begin(), pressures.end(), 0.);
    return n_open != 0 && n_open != std::ptrdiff_t(pressures.size());
  }



  template <int dim>
  bool
  DirkIntegrator<dim>::closes_nodes(const State &state) const
  {
    for (unsigned int i = 0; i < tableau->n_stages(); ++i)
      for (unsigned int node = 0; node < stages[i].contact.pressure.size();
           ++node)
        if (state.contact.pressure[node] == 0. &&
            stages[i].contact.pressure[node] != 0.)
          return true;
    return false;
  }



  template <int dim>
  void
  DirkIntegrator<dim>::choose_stops(const State &state, const ContactMode mode)
  {
    for (StageRates &stage : stages)
      if (mode == ContactMode::closed)
        get_held_at(body, state, stage.held_at);
      else
        stage.held_at.clear();
  }



  template <int dim>
  std::vector<bool>
  DirkIntegrator<dim>::closed_at_end(const ContactMode mode) const
  {
    std::vector<bool> is_closed;
    for (const double p : stages[tableau->n_stages() - 1].contact.pressure)
      is_closed.push_back(mode == ContactMode::closed || p != 0.);
    return is_closed;
  }



  template <int dim>
  void
  DirkIntegrator<dim>::find_closed_nodes(const State      &state,
                                         const ContactMode mode,
                                         StepResult       &result) const
  {
    result.closed_nodes.clear();
    // velocity and pressure of a step of one stage are its differences
    if (mode != ContactMode::unilateral || tableau->n_stages() == 1 ||
        body.scene.contact.order != NodeOrder::viscous)
      return;
    const std::vector<bool> is_closed = closed_at_end(mode);
    for (unsigned int i = 0; i < is_closed.size(); ++i)
      if (is_closed[i] && state.contact.pressure[i] == 0.)
        {
          result.closed_nodes = is_closed;
          return;
        }
  }



  template class DirkIntegrator<1>;
  template class DirkIntegrator<2>;
  template class DirkIntegrator<3>;
} // namespace ThermoContact
