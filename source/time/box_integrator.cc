// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/local_sums.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/exchange_solver.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/box_integrator.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  bool
  BoxIntegrator::Contact::has_waves() const
  {
    return std::all_of(sides.begin(), sides.end(), [](const ContactSide &side) {
      return !side.is_mass() && side.has_waves();
    });
  }



  bool
  BoxIntegrator::Contact::has_rods_with_waves() const
  {
    return !is_of_masses() &&
           std::all_of(sides.begin(), sides.end(), [](const ContactSide &side) {
             return side.is_mass() || side.has_waves();
           });
  }



  template <typename OfSide>
  double
  BoxIntegrator::Contact::sum(const OfSide &of_side) const
  {
    double sum = of_side(sides[0]);
    for (unsigned int i = 1; i < sides.size(); ++i)
      sum += of_side(sides[i]);
    return sum;
  }



  double
  BoxIntegrator::Contact::arriving(const unsigned int side,
                                   const CellValues  &cell) const
  {
    const double stress = sides[side].stiffness * cell.strain -
                          sides[side].thermal_stress * cell.temperature;
    return cell.velocity - stress / impedances[side];
  }



  BoxIntegrator::BoxIntegrator(Body<1> &body)
    : body(body)
    , solver(body)
    , n_heat_stages(body.scene.fields.has_temperature ? HeatStages::n : 0)
    , rates(solver.make_rates())
    , right(rates)
    , known_velocity(rates.velocity)
    , known_displacement(rates.velocity)
    , known_temperature(rates.temperature_rate[0])
    , heat_load(rates.temperature_rate)
    , momentum_load(rates.velocity)
    , stage_momentum_load(rates.velocity)
    , heat_times{}
    , end_heating{}
    , heat_lift(known_temperature)
    , heat_scratch(known_temperature)
    , momentum_lift(rates.velocity)
    , velocity_change(rates.velocity)
    , viscous_part(rates.velocity)
    , stage(body.make_state())
    , acceleration(rates.velocity)
  {
    for (const auto &sides : contact_sides(body))
      {
        Contact contact{sides, {}, 0.};
        double  admittance = 0.;
        for (const ContactSide &side : sides)
          {
            contact.impedances.push_back(side.impedance);
            if (!side.is_mass())
              admittance += 1. / side.impedance;
          }
        contact.impedance = sides.size() == 1 && !sides[0].is_mass() ?
                              sides[0].impedance :
                            admittance > 0. ? 1. / admittance :
                                              infinity;
        contacts.push_back(contact);
      }
  }



  void
  BoxIntegrator::step(const State    &state,
                      const TimeStep &time_step,
                      const ContactMode,
                      StepResult &result)
  {
    const double size = time_step.size;
    present           = time_step;
    obstacle.gap      = state.gap;
    obstacle.gap_rate = state.gap_rate;
    body.obstacle.place(time_step.end, time_step.last_loads, obstacle);
    set_loads(state, time_step);
    solve_without_contact(state, size);
    find_contacts(state, size, ends);
    advance(state, time_step, ends, result.state);
    result.contact_changes.assign(contacts.size(), std::nullopt);
    result.failure.clear();
    result.impacts.clear();
    result.n_iterations  = 0;
    result.is_prescribed = false;
    for (unsigned int c = 0; c < contacts.size(); ++c)
      {
        if (body.law().is_active())
          result.contact_changes[c] = contact_change(
            c, state, path_of_node(c, state, size), ends[c], result.state);
        if (ends[c].contact.pressure != 0.)
          result.n_iterations = 1;
        if (ends[c].masses)
          for (const auto &[part, velocity, side] : ends[c].masses->impacts)
            for (const ContactEvent::Kind kind :
                 {ContactEvent::begin, ContactEvent::end})
              result.impacts.push_back(
                {state.time + part,
                 kind,
                 side * (kind == ContactEvent::begin ?
                           velocity :
                           0. - *body.scene.parameters.contact.restitution *
                                  velocity),
                 side,
                 c});
      }
    if (body.law().is_active() && contacts.size() > 1)
      begin_with_causes(state, result.contact_changes);
    result.start_sums();
    book(state, size, ends, result);
    result.energy = body.energy.energy(result.state);
    result.close_balance();
  }



  void
  BoxIntegrator::set_load_times(const TimeStep &time_step)
  {
    const double first = time_step.first_loads, last = time_step.last_loads;
    if (n_heat_stages == 0)
      load_times[0].assign(1, {first + 0.5 * (last - first), 1.});
    for (unsigned int i = 0; i < n_heat_stages; ++i)
      {
        heat_times[i] = first + HeatStages::times[i] * (last - first);
        load_times[i].assign(1, {heat_times[i], 1.});
      }
    if (time_step.breaks.empty())
      return;

    // the rule of the step in each of its pieces
    MeanOfTimes &mean = load_times[0];
    mean.clear();
    const auto add_piece =
      [&](const double begin, const double end, const double length) {
        const double part = length / (last - first);
        if (n_heat_stages == 0)
          mean.push_back({begin + 0.5 * (end - begin), part});
        for (unsigned int i = 0; i < n_heat_stages; ++i)
          mean.push_back({begin + HeatStages::times[i] * (end - begin),
                          part * HeatStages::weights[i]});
      };
    double begin = first, old_break = first;
    for (const LoadBreak &at : time_step.breaks)
      {
        add_piece(begin, at.old_time, at.time - old_break);
        begin     = at.new_time;
        old_break = at.time;
      }
    add_piece(begin, last, last - old_break);
    if (n_heat_stages == 0)
      return;
    // the last stage has the loads at the end of the step, the first one what
    // their mean needs beside them
    const double first_weight = HeatStages::weights.front();
    for (WeightedTime &at : mean)
      at.weight /= first_weight;
    mean.push_back(
      {heat_times.back(), -HeatStages::weights.back() / first_weight});
  }



  void
  BoxIntegrator::set_loads(const State &state, const TimeStep &time_step)
  {
    const Scene &scene = body.scene;
    const auto   time  = [&](const double part) {
      return time_step.first_loads +
             part * (time_step.last_loads - time_step.first_loads);
    };
    set_load_times(time_step);
    if (n_heat_stages == 0)
      body.loads.assemble(load_times[0], heat_lift, momentum_load);
    else
      set_zero(momentum_load);
    for (unsigned int i = 0; i < n_heat_stages; ++i)
      {
        body.loads.assemble(load_times[i], heat_load[i], stage_momentum_load);
        set_sum(momentum_load,
                momentum_load,
                HeatStages::weights[i],
                stage_momentum_load);
      }

    end_heating.fill(0.);
    for (const unsigned int entry : body.driven_end.entries(Field::temperature))
      for (unsigned int j = 0; j < HeatStages::n; ++j)
        {
          const double rise =
            scene.heat.fixed_end_drive->value(time(HeatStages::times[j])) -
            state.temperature.begin()[entry];
          for (unsigned int i = 0; i < HeatStages::n; ++i)
            end_heating[i] += HeatStages::inverse[i][j] * rise / time_step.size;
        }
    end_velocity = 0.;
    for (const unsigned int entry :
         body.driven_end.entries(Field::displacement))
      end_velocity = (scene.fixed_end_motion->value(time(1.)) -
                      state.displacement.begin()[entry]) /
                     time_step.size;
  }



  void
  BoxIntegrator::solve_without_contact(const State &state, const double size)
  {
    using Term                  = RodMatrices::Term;
    const Material    &material = body.scene.material;
    const RodMatrices &products = *body.equations.rod();
    const double       tau      = 0.5 * size;

    // the motion of the fixed end is known
    set_equal(known_velocity, state.velocity);
    set_equal(known_displacement, state.displacement);
    known_velocity.begin()[0] -= end_velocity;
    // of the first cell
    const BodyRow &row       = body.scene.row;
    const double   viscosity = row.is_given() && !row.cells[0].is_gap ?
                                 material.viscosity *
                                 row.cells[0].whole.viscosity /
                                 row.cells[0].whole.stiffness :
                                 material.viscosity;
    known_displacement.begin()[0] += (tau + viscosity) * end_velocity;
    const Term inertia = {material.inertia,
                          RodMatrices::momentum_mass,
                          known_velocity.begin()};
    const Term elastic = {-tau,
                          RodMatrices::stiffness,
                          known_displacement.begin()};
    if (n_heat_stages == 0)
      products.combine<2>({{inertia, elastic}},
                          tau,
                          momentum_load.begin(),
                          right.velocity.begin());
    else
      {
        set_equal(known_temperature, state.temperature);
        for (unsigned int i = 0; i < n_heat_stages; ++i)
          {
            double rise = 0.;
            for (unsigned int j = 0; j < n_heat_stages; ++j)
              rise += size * HeatStages::coefficients[i][j] * end_heating[j];
            known_temperature.begin()[0] = state.temperature.begin()[0] + rise;
            products.combine<1>(
              {{{-1., RodMatrices::conduction, known_temperature.begin()}}},
              1.,
              heat_load[i].begin(),
              right.temperature_rate[i].begin());
            if (!body.driven_end.is_active())
              continue;
            heat_lift.begin()[0] = end_heating[i];
            body.equations.heat_mass.add(-1.,
                                         heat_lift,
                                         right.temperature_rate[i],
                                         heat_scratch);
            momentum_lift.begin()[0] = end_velocity;
            if (material.has_heating())
              body.equations.divergence.add(-material.heating,
                                            momentum_lift,
                                            right.temperature_rate[i],
                                            heat_scratch);
          }
        double rise = 0.; // of the mean of the stages
        for (unsigned int i = 0; i < n_heat_stages; ++i)
          for (unsigned int j = 0; j < n_heat_stages; ++j)
            rise += HeatStages::weights[i] * size *
                    HeatStages::coefficients[i][j] * end_heating[j];
        known_temperature.begin()[0] = state.temperature.begin()[0] + rise;
        products.combine<3>({{inertia,
                              elastic,
                              {tau * material.thermal_stress,
                               RodMatrices::thermal_stress,
                               known_temperature.begin()}}},
                            tau,
                            momentum_load.begin(),
                            right.velocity.begin());
      }
    for (const unsigned int entry :
         body.discretization.constrained_entries(Field::displacement))
      right.velocity.begin()[entry] = 0.;
    for (const unsigned int entry :
         body.discretization.constrained_entries(Field::temperature))
      for (unsigned int i = 0; i < n_heat_stages; ++i)
        right.temperature_rate[i].begin()[entry] = 0.;
    solver.solve(size, right, rates);
    for (const unsigned int entry :
         body.driven_end.entries(Field::displacement))
      rates.velocity.begin()[entry] = end_velocity;
    for (const unsigned int entry : body.driven_end.entries(Field::temperature))
      for (unsigned int i = 0; i < n_heat_stages; ++i)
        rates.temperature_rate[i].begin()[entry] = end_heating[i];
  }



  BoxIntegrator::EndValues
  BoxIntegrator::end_response(const BoxRates    &response,
                              const double       size,
                              const unsigned int c) const
  {
    const Contact &contact = contacts[c];
    EndValues      values;
    values.velocity = contact.sum(
      [&](const ContactSide &side) { return side.value(response.velocity); });
    values.inner = contact.sum([&](const ContactSide &side) {
      return side.inner_value(response.velocity);
    });
    for (unsigned int i = 0; i < n_heat_stages; ++i)
      for (unsigned int j = 0; j < n_heat_stages; ++j)
        values.temperature[i] +=
          size * HeatStages::coefficients[i][j] *
          contact.sum([&](const ContactSide &side) {
            return side.value(response.temperature_rate[j]);
          });
    return values;
  }



  BoxIntegrator::EndValues
  BoxIntegrator::end_values(const State       &state,
                            const double       size,
                            const unsigned int c) const
  {
    EndValues values  = end_response(rates, size, c);
    values.old_middle = contacts[c].sum([&](const ContactSide &side) {
      return side.sign * side.middle(state.velocity, 0);
    });
    for (unsigned int i = 0; i < n_heat_stages; ++i)
      values.temperature[i] += contacts[c].sum([&](const ContactSide &side) {
        return side.value(state.temperature);
      }) - body.surroundings.temperature(c, heat_times[i]);
    return values;
  }



  double
  BoxIntegrator::old_coefficient(const unsigned int c,
                                 const State       &state,
                                 const StepPath    &path) const
  {
    if (n_heat_stages == 0 || !present.begins_at_break ||
        body.scene.heat.exchange->is_in_matrices())
      return state.contact.exchange_coefficient[c];
    const double p     = state.contact.pressure[c];
    const double theta = contacts[c].sum(
      [&](const ContactSide &side) { return side.value(state.temperature); });
    return body.scene.heat.exchange->coefficient(
      p != 0. ? 0. : std::max(path.front, path.rear),
      std::abs(p),
      body.surroundings.conditions(c, theta, present.first_loads));
  }



  double
  BoxIntegrator::former_rate(const unsigned int c,
                             const State       &state,
                             const double       size,
                             const unsigned int n_steps)
  {
    if (!body.obstacle.is_active())
      return 0.;
    const auto gap = [&](const unsigned int n) {
      body.obstacle.get_derivatives(std::max(state.time - n * size, 0.),
                                    former_gaps);
      return former_gaps[c].value;
    };
    return (gap(n_steps - 1) - gap(n_steps)) / size;
  }



  StepPath
  BoxIntegrator::path_of_node(const unsigned int c,
                              const State       &state,
                              const double       size) const
  {
    const SceneContact &contact = body.scene.contact;
    const double        u       = contacts[c].sum(
      [&](const ContactSide &side) { return side.value(state.displacement); });
    const double p = state.contact.pressure[c];
    // the pressure has more digits than the difference of displacement and gap
    const auto start = [](const ContactLaw &law,
                          const double      penetration,
                          const double      pressure) {
      return law.is_damped() ? penetration :
             pressure > 0.   ? law.penetration(pressure) :
                               std::min(penetration, 0.);
    };
    StepPath path;
    path.size       = size;
    path.front      = start(contact.law_at(c), u - state.gap[c], p);
    path.front_rate = (obstacle.gap[c] - state.gap[c]) / size;
    path.rear = start(contact.law_at(c, -1), -u - contact.rear_gap_at(c), -p);
    // bodies that rest side by side do not meet by the rounding of waves
    // and of their places
    path.negligible_velocity =
      (body.scene.row.is_given() ? Tolerances::rounding_of_fronts :
                                   Tolerances::rounding_of_solution) *
        rates.velocity.linfty_norm() +
      Tolerances::rounding_of_solution * state.displacement.linfty_norm() /
        size;
    return path;
  }



  void
  BoxIntegrator::set_impedances(const double size)
  {
    if (!body.law().is_active() || body.scene.material.has_viscosity())
      return;
    for (unsigned int c = 0; c < contacts.size(); ++c)
      {
        Contact      &contact  = contacts[c];
        const Vector &response = solver.response_to_pressure(size, c).velocity;
        double        sum      = 0.;
        for (unsigned int i = 0; i < contact.sides.size(); ++i)
          if (const ContactSide &side = contact.sides[i]; !side.is_mass())
            {
              contact.impedances[i] = 1. / side.value(response);
              sum += side.value(response);
            }
        contact.impedance = sum > 0. ? 1. / sum : infinity;
      }
  }



  double
  BoxIntegrator::rounding_of_velocity(const State &state) const
  {
    return Tolerances::rounding_of_fronts * rates.velocity.linfty_norm() +
           Tolerances::rounding_of_solution * state.displacement.linfty_norm() /
             present.size;
  }



  void
  BoxIntegrator::finish_node(const unsigned int c,
                             const State       &state,
                             const EndValues   &values,
                             EndContact        &end) const
  {
    const StepContact &contact   = end.contact;
    const double       impedance = contacts[c].impedance;
    // with the waves that arrive at the end of the step, but for its own
    // pressure
    const double arriving = values.velocity + values.inner - values.old_middle +
                            contact.pressure / impedance;
    const int         side = contact.end_pressure < 0. ? -1 : 1;
    const ContactLaw &law  = body.scene.contact.law_at(c, side);
    const double      rate = side > 0 ? obstacle.gap_rate[c] : 0.;
    end.end_pressure       = contact.end_pressure;
    if (const auto &now = end.releases.now; law.is_rigid() && now)
      {
        end.end_pressure = 0.;
        end.end_velocity = rate + now->side * now->after;
        return;
      }
    if (law.is_rigid() && contact.pressure != 0.)
      {
        // the pressure that stops an end that comes, without a front that is
        // yet to come
        const auto &next = end.releases.next;
        end.stopping =
          impedance * (next ? side * next->before : arriving - rate);
        end.end_pressure =
          side * end.stopping > impedance * rounding_of_velocity(state) ?
            end.stopping :
            0.;
      }
    if (law.is_damped() && contact.end_pressure != 0.)
      {
        const double elastic = std::abs(contact.end_pressure);
        const double damping = law.damping() * elastic + law.dashpot();
        end.end_pressure =
          side * std::max(0., elastic + damping * side * (arriving - rate)) /
          (1. + damping / impedance);
      }
    end.end_velocity = arriving - end.end_pressure / impedance;
  }



  double
  BoxIntegrator::velocity_of(const unsigned int c, const State &state) const
  {
    return state.contact_velocity.empty() ?
             contacts[c].sum([&](const ContactSide &side) {
               return side.value(state.velocity);
             }) :
             state.contact_velocity[c];
  }



  void
  BoxIntegrator::follow_masses(const unsigned int c,
                               const State       &state,
                               const StepPath    &path,
                               EndContact        &end)
  {
    // seen from an obstacle that moves along a parabola, too
    const double start_rate = state.gap_rate[c];
    const double rise       = 2. * (path.front_rate - start_rate);
    const double velocity   = velocity_of(c, state) - start_rate;
    const double change =
      2. * (path.free_velocity - path.front_rate - velocity);
    // one behind rests
    const double own_velocity = velocity_of(c, state);
    const double own_change   = 2. * (path.free_velocity - own_velocity);
    const double old_pressure = state.contact.pressure[c];
    end.masses                = ThermoContact::follow_masses(
      {path.size,
                      {path.front, velocity, change / path.size},
                      {path.rear, -own_velocity, -own_change / path.size},
       old_pressure == 0. ? 0 :
                      old_pressure > 0.  ? 1 :
                                           -1,
                      *body.scene.parameters.contact.restitution});
    const MassImpacts &masses = *end.masses;
    end.end_velocity =
      masses.velocity + (masses.held_at > 0 ? obstacle.gap_rate[c] :
                         masses.held_at < 0 ? 0. :
                                              start_rate + rise);
    // the midpoint rule changes velocities by twice the mean pressure
    const double by_contact =
      masses.held_at > 0 ?
        end.end_velocity - start_rate - rise + masses.change :
        masses.change;
    end.contact.pressure = -0.5 * by_contact / path.response;
    end.contact.velocity =
      path.free_velocity - path.response * end.contact.pressure;
    double at_end = change;
    if (body.obstacle.is_active())
      {
        body.obstacle.get_derivatives(present.last_loads, former_gaps);
        at_end += rise - former_gaps[c].second * path.size;
      }
    end.end_pressure = end.contact.end_pressure =
      masses.held_at > 0 ? std::max(0., 0.5 * at_end / path.response) :
      masses.held_at < 0 ? std::min(0., 0.5 * own_change / path.response) :
                           0.;
    end.contact.weight = 1.;
    // a mean power over the step, of the mass that response shows
    end.contact.damping_power = 0.5 * masses.loss / path.response;
  }



  BoxIntegrator::EndContact
  BoxIntegrator::contact_for(const unsigned int c,
                             const State       &state,
                             const double       end_coefficient,
                             const EndValues   &free,
                             const StepPath    &path_without_exchange,
                             const double       size,
                             const Releases    &releases)
  {
    constexpr unsigned int n = HeatStages::n;
    const bool             flows =
      n_heat_stages > 0 && !body.scene.heat.exchange->is_in_matrices();
    EndContact end;
    end.end_coefficient = end_coefficient;
    const double old    = old_coefficient(c, state, path_without_exchange);
    for (unsigned int i = 0; i < n; ++i)
      end.coefficient[i] = old + HeatStages::times[i] * (end_coefficient - old);
    EndValues values(free);
    EndValues by_pressure;
    // fluxes q = k (theta - p dtheta), and what they take of the rest
    std::array<double, n>                flux{}, flux_by_pressure{};
    std::array<EndValues, HeatStages::n> by_flux;
    if (body.law().is_active())
      by_pressure = end_response(solver.response_to_pressure(size, c), size, c);
    if (flows)
      {
        for (unsigned int i = 0; i < n; ++i)
          by_flux[i] =
            end_response(solver.response_to_flux(size, c, i), size, c);
        const auto a = [&](const unsigned int i, const unsigned int j) {
          return (i == j) + end.coefficient[i] * by_flux[j].temperature[i];
        };
        const double determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
        const auto   fluxes      = [&](const EndValues &of) {
          const double first  = end.coefficient[0] * of.temperature[0],
                       second = end.coefficient[1] * of.temperature[1];
          return std::array<double, n>{
            {(a(1, 1) * first - a(0, 1) * second) / determinant,
             (a(0, 0) * second - a(1, 0) * first) / determinant}};
        };
        flux             = fluxes(free);
        flux_by_pressure = fluxes(by_pressure);
      }
    const auto take =
      [](EndValues &from, const double factor, const EndValues &what) {
        from.velocity -= factor * what.velocity;
        from.inner -= factor * what.inner;
      };
    for (unsigned int i = 0; i < n; ++i)
      {
        take(values, flux[i], by_flux[i]);
        take(by_pressure, flux_by_pressure[i], by_flux[i]);
      }
    StepPath path(path_without_exchange);
    path.free_velocity = end.free_velocity = values.velocity;
    path.response                          = by_pressure.velocity;
    end.contact.velocity                   = values.velocity;
    const bool is_rigid = body.scene.contact.law_at(c).is_rigid();
    if (is_rigid && contacts[c].is_of_masses())
      follow_masses(c, state, path, end);
    else if (body.law().is_active())
      end.contact = solve_step_contact(body.scene.contact.law_at(c),
                                       body.scene.contact.law_at(c, -1),
                                       path);
    end.releases = releases;
    if (auto &now = end.releases.now; now && is_rigid)
      {
        const double pressure =
          now->side * now->part * now->before / path.response;
        const double velocity = path.free_velocity - path.response * pressure;
        if (std::max(path.front + size * (velocity - path.front_rate),
                     path.rear - size * velocity) >
            size * rounding_of_velocity(state))
          now.reset(); // it meets the other obstacle at once
        else
          {
            end.contact.pressure = pressure;
            end.contact.velocity = velocity;
          }
      }
    take(values, end.contact.pressure, by_pressure);
    for (unsigned int i = 0; i < n; ++i)
      end.flux[i] = flux[i] - end.contact.pressure * flux_by_pressure[i];
    end.end_excess = free.temperature.back() -
                     end.contact.pressure * by_pressure.temperature.back();
    for (unsigned int i = 0; i < n && flows; ++i)
      end.end_excess -= end.flux[i] * by_flux[i].temperature.back();
    if (!end.masses)
      finish_node(c, state, values, end);
    return end;
  }



  BoxIntegrator::EndContact
  BoxIntegrator::find_contact(const unsigned int c,
                              const State       &state,
                              const double       size,
                              const EndValues   &free,
                              const StepPath    &path,
                              const Releases    &releases)
  {
    if (n_heat_stages == 0 || body.scene.heat.exchange->is_in_matrices())
      return contact_for(c,
                         state,
                         state.contact.exchange_coefficient[c],
                         free,
                         path,
                         size,
                         releases);
    EndContact          end;
    const HeatExchange &exchange = *body.scene.heat.exchange;
    const double        new_time = heat_times.back();
    const auto          law_at   = [&](const double coefficient) {
      end = contact_for(c, state, coefficient, free, path, size, releases);
      const double s =
        std::max(path.front + size * (end.contact.velocity - path.front_rate),
                 path.rear - size * end.contact.velocity);
      // the flux that left is k times the difference of temperatures
      return exchange.coefficient(end.end_pressure != 0. ? 0. : s,
                                  std::abs(end.end_pressure),
                                  body.surroundings.conditions(
                                    c,
                                    body.surroundings.temperature(c, new_time) +
                                      end.end_excess,
                                    new_time));
    };
    const auto excess = [&](const double coefficient) {
      return coefficient - law_at(coefficient);
    };
    const double found =
      coefficient_next_to(old_coefficient(c, state, path), excess, 1);
    return contact_for(c, state, found, free, path, size, releases);
  }



  namespace
  {
    /** Times that the contacts of a row are looked at, one after the other. */
    constexpr unsigned int max_sweeps = 10000;
  } // namespace



  void
  BoxIntegrator::find_contacts(const State             &state,
                               const double             size,
                               std::vector<EndContact> &ends)
  {
    set_impedances(size);
    const unsigned int n = contacts.size();
    free.resize(n);
    paths.resize(n);
    releases.resize(n);
    ends.assign(n, EndContact());
    for (unsigned int c = 0; c < n; ++c)
      {
        free[c] = end_values(state, size, c);
        if (body.law().is_active())
          paths[c] = path_of_node(c, state, size);
        releases[c] = find_releases(c, state, paths[c]);
      }
    // the effect of loads at another contact
    const auto subtract =
      [](EndValues &from, const double load, const EndValues &response) {
        from.velocity -= load * response.velocity;
        from.inner -= load * response.inner;
        for (unsigned int i = 0; i < HeatStages::n; ++i)
          from.temperature[i] -= load * response.temperature[i];
      };
    double largest = 0.;
    for (unsigned int sweep = 0;; ++sweep)
      {
        double change = 0.;
        for (unsigned int c = 0; c < n; ++c)
          {
            EndValues without = free[c];
            for (unsigned int d = 0; d < n; ++d)
              if (d != c)
                {
                  if (ends[d].contact.pressure != 0.)
                    subtract(without,
                             ends[d].contact.pressure,
                             end_response(solver.response_to_pressure(size, d),
                                          size,
                                          c));
                  for (unsigned int i = 0; i < n_heat_stages; ++i)
                    if (ends[d].flux[i] != 0.)
                      subtract(without,
                               ends[d].flux[i],
                               end_response(solver.response_to_flux(size, d, i),
                                            size,
                                            c));
                }
            const EndContact found =
              find_contact(c, state, size, without, paths[c], releases[c]);
            change  = std::max(change,
                              std::abs(found.contact.pressure -
                                       ends[c].contact.pressure));
            largest = std::max(largest, std::abs(found.contact.pressure));
            for (unsigned int i = 0; i < n_heat_stages; ++i)
              {
                change =
                  std::max(change, std::abs(found.flux[i] - ends[c].flux[i]));
                largest = std::max(largest, std::abs(found.flux[i]));
              }
            ends[c] = found;
          }
        if (n == 1 || change <= Tolerances::rounding_of_solution * largest)
          break;
        if (sweep == max_sweeps)
          throw ComputationError(
            "the contacts of the row act on each other and do not come to "
            "rest\n  remedy:  heavier masses or more cells of the rods");
      }
    for (unsigned int c = 0; c < n; ++c)
      {
        if (ends[c].contact.pressure != 0.)
          add_response(ends[c].contact.pressure,
                       solver.response_to_pressure(size, c));
        for (unsigned int i = 0; i < n_heat_stages; ++i)
          if (ends[c].flux[i] != 0.)
            add_response(ends[c].flux[i], solver.response_to_flux(size, c, i));
      }
  }



  void
  BoxIntegrator::add_response(const double load, const BoxRates &response)
  {
    rates.velocity.add(-load, response.velocity);
    for (unsigned int i = 0; i < n_heat_stages; ++i)
      rates.temperature_rate[i].add(-load, response.temperature_rate[i]);
  }



  void
  BoxIntegrator::advance(const State                   &state,
                         const TimeStep                &time_step,
                         const std::vector<EndContact> &ends,
                         State                         &new_state)
  {
    const double size = time_step.size;
    new_state.copy_values(state);
    new_state.time     = time_step.end;
    new_state.gap      = obstacle.gap;
    new_state.gap_rate = obstacle.gap_rate;
    for (unsigned int i = 0; i < n_heat_stages; ++i)
      new_state.temperature.add(size * HeatStages::weights[i],
                                rates.temperature_rate[i]);
    for (const unsigned int entry : body.driven_end.entries(Field::temperature))
      new_state.temperature.begin()[entry] =
        body.scene.heat.fixed_end_drive->value(time_step.last_loads);
    new_state.displacement.add(size, rates.velocity);
    for (const unsigned int entry :
         body.driven_end.entries(Field::displacement))
      new_state.displacement.begin()[entry] =
        body.scene.fixed_end_motion->value(time_step.last_loads);
    advance_velocity(size, state, new_state.velocity);
    work_of_impacts = 0.;
    set_end_velocities(state, ends, new_state);

    if (!body.scene.heat.exchange->is_in_matrices())
      for (unsigned int c = 0; c < contacts.size(); ++c)
        new_state.contact.exchange_coefficient[c] = ends[c].end_coefficient;
    if (!body.law().is_active())
      return;
    for (unsigned int c = 0; c < contacts.size(); ++c)
      {
        const EndContact &end         = ends[c];
        new_state.contact.pressure[c] = end.end_pressure;
        if (const ContactLaw &law =
              body.scene.contact.law_under(end.end_pressure, c);
            law.is_damped() || (end.end_pressure == 0. && !law.is_rigid() &&
                                body.scene.contact.is_damped()))
          continue;
        // on the obstacle to the last digit, and never behind it
        const double u    = contacts[c].sum([&](const ContactSide &side) {
          return side.value(new_state.displacement);
        });
        const double rear = body.scene.contact.place(-1, c, new_state.gap[c]);
        const double place =
          end.masses && end.masses->held_at < 0 ?
            rear :
          end.masses ?
            std::max(new_state.gap[c] + end.masses->penetration, rear) :
          end.end_pressure != 0. ?
            displacement_of_law(body, new_state, c) :
            std::max(std::min(u, new_state.gap[c]), rear);
        if (end.masses) // as impulses move them
          {
            const Vector &response =
              solver.response_to_pressure(size, c).velocity;
            const double all = contacts[c].sum(
              [&](const ContactSide &side) { return side.value(response); });
            for (const ContactSide &side : contacts[c].sides)
              {
                const double way =
                  (place - u) * response.begin()[side.node] / all;
                new_state.displacement.begin()[side.node] += way;
                work_of_impacts += momentum_load.begin()[side.node] * way;
              }
            if (body.obstacle.is_active() && contacts[c].sides.size() == 1)
              {
                // at the velocities that the obstacle has at the impacts,
                // instead of its mean one, by the balance of the mass
                const double mass = 0.5 * size / all, v = velocity_of(c, state),
                             change = 2. * (end.free_velocity - v),
                             old_u =
                               contacts[c].sides[0].value(state.displacement);
                work_of_impacts +=
                  mass * (0.5 * (end.end_velocity * end.end_velocity - v * v) -
                          change / size * (place - old_u) + end.masses->loss);
                // which the pressure has done already, but behind the mass
                if (end.contact.pressure > 0. || std::isinf(rear))
                  work_of_impacts +=
                    end.contact.pressure * (new_state.gap[c] - state.gap[c]);
              }
          }
        else if (contacts[c].sides.size() == 1)
          new_state.displacement.begin()[contacts[c].sides[0].node] = place;
        else
          body.contact_end().add_to_value(Field::displacement,
                                          c,
                                          place - u,
                                          new_state.displacement);
      }
  }



  void
  BoxIntegrator::set_end_velocities(const State                   &state,
                                    const std::vector<EndContact> &ends,
                                    State &new_state) const
  {
    double *const v = new_state.velocity.begin();
    // values that alternate from node to node are zero in all cells
    const auto set_end = [&](const ContactSide &side, const double velocity) {
      double change = velocity - v[side.node];
      for (unsigned int i = 0; i <= side.n_cells; ++i, change = -change)
        v[side.node_behind(i)] += change;
    };
    if (!body.scene.row.is_given())
      return set_end(contacts[0].sides[0], ends[0].end_velocity);
    new_state.contact_velocity.resize(contacts.size());
    for (unsigned int c = 0; c < contacts.size(); ++c)
      new_state.contact_velocity[c] = ends[c].end_velocity;
    // from the right: a rod between two contacts has the velocity of its right
    // end
    for (unsigned int c = contacts.size(); c-- > 0;)
      for (unsigned int i = contacts[c].sides.size(); i-- > 0;)
        {
          const ContactSide &side = contacts[c].sides[i];
          const bool         has_other_end =
            side.sign < 0. && c + 1 < contacts.size() &&
            contacts[c + 1].sides[0].node_behind(side.n_cells) == side.node;
          if (side.is_mass() || has_other_end)
            continue;
          const double free = side.value(rates.velocity) +
                              side.inner_value(rates.velocity) -
                              side.sign * side.middle(state.velocity, 0);
          set_end(side,
                  side.sign *
                    (free + (ends[c].contact.pressure - ends[c].end_pressure) /
                              contacts[c].impedances[i]));
        }
  }



  CellValues
  BoxIntegrator::later_values_in(const ContactSide &side,
                                 const State       &state,
                                 const double       size,
                                 const unsigned int cell) const
  {
    CellValues values = side.values_in(state, cell);
    values.velocity =
      2. * side.sign * side.middle(rates.velocity, cell) - values.velocity;
    values.strain +=
      (size + side.viscosity) * side.difference(rates.velocity, cell);
    for (unsigned int stage = 0; stage < n_heat_stages; ++stage)
      values.temperature += size * HeatStages::weights[stage] *
                            side.middle(rates.temperature_rate[stage], cell);
    return values;
  }



  BoxIntegrator::Releases
  BoxIntegrator::find_releases(const unsigned int c,
                               const State       &state,
                               const StepPath    &path)
  {
    constexpr unsigned int n_cells_seen = 3;
    const Contact         &contact      = contacts[c];
    if (!body.law().is_active() || !contact.has_rods_with_waves())
      return {};
    // a mass goes on as it is
    const auto mass_velocity = [&](const ContactSide &side) {
      return side.value(state.velocity);
    };
    const auto sum_of_sides = [&](const auto &of_side) {
      double sum = of_side(0U);
      for (unsigned int i = 1; i < contact.sides.size(); ++i)
        sum += of_side(i);
      return sum;
    };
    const double stopped = state.contact.pressure[c];
    const double free    = contact.sum(
      [&](const ContactSide &side) { return side.value(rates.velocity); });
    const int    side = stopped != 0. ? (stopped > 0. ? 1 : -1) :
                                        (free > path.front_rate ? 1 : -1);
    const double rate = side > 0 ? path.front_rate : 0.;
    Releases     releases;
    releases.change = free - sum_of_sides([&](const unsigned int i) {
                        const ContactSide &of = contact.sides[i];
                        return of.is_mass() ?
                                 mass_velocity(of) :
                                 contact.arriving(i, of.values_in(state, 0));
                      });
    for (const ContactSide &of : contact.sides)
      if (!of.is_mass() && of.n_cells < n_cells_seen)
        return releases;
    // the part of the loads that acts from the middle of the last cell on
    const Vector &response = solver.response_to_pressure(path.size, c).velocity;
    const double  along    = contact.sum([&](const ContactSide &of) {
      return (of.is_mass() ? 1. : 0.5) * of.inner_value(momentum_load) *
             of.value(response);
    });
    const auto    change   = [&](const unsigned int cell) {
      return releases.change + 2. * cell * along;
    };
    // waves on their way back show the waves that came, to an end that had the
    // velocity of the obstacle
    const auto doubled_rate = [&](const unsigned int n_steps) {
      return side > 0 ? 2. * former_rate(c, state, path.size, n_steps) - rate :
                        0.;
    };
    const double former_rates[] = {doubled_rate(1), doubled_rate(2)};
    const auto   came           = [&](const unsigned int cell) {
      return side * (sum_of_sides([&](const unsigned int i) {
                       if (contact.sides[i].is_mass())
                         return 0. - mass_velocity(contact.sides[i]);
                       const CellValues values =
                         contact.sides[i].values_in(state, cell);
                       return contact.arriving(i, values) -
                              2. * values.velocity;
                     }) +
                     former_rates[cell] + change(cell));
    };
    const auto comes = [&](const unsigned int cell) {
      return side *
             (sum_of_sides([&](const unsigned int i) {
                if (contact.sides[i].is_mass())
                  return mass_velocity(contact.sides[i]);
                return contact.arriving(
                  i, later_values_in(contact.sides[i], state, path.size, cell));
              }) -
              rate + change(cell));
    };
    const double coming[] = {
      came(1), came(0), side * (free - rate), comes(0), comes(1), comes(2)};
    const auto around = [&](const unsigned int now) {
      return std::abs(coming[now - 2] - coming[now - 1]) +
             std::abs(coming[now + 2] - coming[now + 1]);
    };
    const auto release = [&](const unsigned int now) -> std::optional<Release> {
      const double before = coming[now - 1], after = coming[now + 1];
      const double jump     = before - after;
      const double rounding = Tolerances::rounding_of_fronts * jump;
      if (before > Tolerances::rounding_of_data * jump && after <= rounding &&
          around(now) < 0.5 * jump && coming[now] <= before + rounding &&
          coming[now] >= after - rounding)
        return Release{side,
                       std::min(1., std::max(0., (coming[now] - after) / jump)),
                       before,
                       after};
      return std::nullopt;
    };
    releases.now  = stopped != 0. ? release(2) : std::nullopt;
    releases.next = release(3);
    if (releases.now && releases.next) // one front, in the one or the other
      (around(3) < around(2) ? releases.now : releases.next).reset();
    return releases;
  }



  std::optional<ContactChange>
  BoxIntegrator::contact_change(const unsigned int c,
                                const State       &state,
                                const StepPath    &path,
                                const EndContact  &end,
                                const State       &new_state) const
  {
    const Contact &contact   = contacts[c];
    const bool     has_waves = contact.has_waves();
    const auto     law_of    = [&](const double pressure) -> const auto &
    {
      return body.scene.contact.law_under(pressure, c);
    };
    const double within =
      path.rear > 0. ? -path.rear : std::max(path.front, 0.);
    const double before = within != 0. && law_of(within).can_be_silent() ?
                            within :
                            state.contact.pressure[c];
    const double after  = law_of(end.contact.end_pressure).can_be_silent() ?
                            end.contact.end_pressure :
                            end.end_pressure;
    if ((before != 0.) == (after != 0.))
      return std::nullopt;

    const ContactLaw &law   = law_of(before != 0. ? before : after);
    const int         side  = (before != 0. ? before : after) < 0. ? -1 : 1;
    const double      rate  = side > 0 ? path.front_rate : 0.;
    const double      start = side > 0 ? path.front : path.rear;
    const auto        at    = [&](const double part, const double velocity) {
      return ContactChange{state.time +
                             path.size * std::min(std::max(part, 0.), 1.),
                           velocity};
    };
    const auto arriving = [&]() {
      double sum = 0.;
      for (unsigned int i = 0; i < contact.sides.size(); ++i)
        {
          const ContactSide &of = contact.sides[i];
          if (of.is_mass())
            {
              sum += of.value(new_state.velocity);
              continue;
            }
          CellValues last = of.values_in(new_state, 0);
          last.strain += of.viscosity * of.difference(rates.velocity, 0);
          sum += contact.arriving(i, last);
        }
      return sum;
    };
    // behind a front each rod has the velocity of its waves, a mass its own
    const double leaving =
      contact.has_rods_with_waves() ?
        arriving() + end.releases.change - rate :
        end.end_velocity - (side > 0 ? obstacle.gap_rate[c] : 0.);
    if (end.masses)
      return at(end.masses->change_time / path.size, 0.);
    // what arrives, without the pressure that the end has had
    const double velocity = velocity_of(c, state) +
                            state.contact.pressure[c] / contact.impedance -
                            (side > 0 ? state.gap_rate[c] : 0.);
    // where the mean velocity of the step takes it to the surface; what arrives
    // there, if that changes steadily up to the next step
    const auto at_surface = [&](const double way) {
      const double part = -start / (path.size * side * way);
      if (!has_waves)
        return at(part, way);
      const double mean   = end.free_velocity - rate;
      const double first  = 2. * (mean - velocity);
      const double second = leaving - mean;
      const double change = first * second < 0.                ? 0. :
                            std::abs(first) < std::abs(second) ? first :
                                                                 second;
      return at(part, mean + (part - 0.5) * change);
    };
    if (before == 0.)
      return at_surface(end.free_velocity - rate);
    if (!law.ends_with_pressure() && end.contact.weight == 0.)
      return at_surface(end.contact.velocity - rate);
    if (const auto &now = end.releases.now)
      return at(now->part, has_waves ? leaving : now->side * now->after);
    if (law.dashpot() > 0.)
      {
        const double pull =
          law.held_pressure(std::max(0.,
                                     start + path.size * side *
                                               (end.contact.velocity - rate)),
                            side * (end.end_velocity - rate));
        return at(before / (before - side * pull), end.end_velocity - rate);
      }

    // pressures that stop the end at the start of this step, and at its end
    const double stopping = law.is_rigid() && end.contact.pressure != 0. ?
                              end.stopping :
                              contact.impedance * (end.end_velocity - rate);
    const double behind_break =
      2. * contact.impedance * (end.free_velocity - rate) - stopping;
    const double stopped = present.begins_at_break ?
                             side * std::max(0., side * behind_break) :
                             state.contact.pressure[c];
    return at(stopped / (stopped - stopping), leaving);
  }



  void
  BoxIntegrator::begin_with_causes(
    const State                               &state,
    std::vector<std::optional<ContactChange>> &changes) const
  {
    const auto share_mass = [&](const unsigned int c, const unsigned int d) {
      for (const ContactSide &of_c : contacts[c].sides)
        for (const ContactSide &of_d : contacts[d].sides)
          if (of_c.is_mass() && of_d.is_mass() && of_c.node == of_d.node)
            return true;
      return false;
    };
    const auto waits = [&](const unsigned int c) {
      return changes[c] && changes[c]->time == state.time &&
             state.contact.pressure[c] == 0. && paths[c].front == 0. &&
             velocity_of(c, state) - state.gap_rate[c] <=
               paths[c].negligible_velocity;
    };
    const auto begin_with = [&](const unsigned int c, const unsigned int d) {
      if (waits(c) && changes[d] && share_mass(c, d))
        changes[c]->time = changes[d]->time;
    };
    for (unsigned int c = 1; c < contacts.size(); ++c)
      begin_with(c, c - 1);
    for (unsigned int c = contacts.size() - 1; c-- > 0;)
      begin_with(c, c + 1);
  }



  void
  BoxIntegrator::advance_velocity(const double size,
                                  const State &state,
                                  Vector      &velocity)
  {
    const Material &material = body.scene.material;
    if (!material.has_viscosity())
      {
        velocity.sadd(-1., 2., rates.velocity);
        return;
      }
    set_sum(velocity_change, rates.velocity, -1., state.velocity);
    set_equal(velocity, rates.velocity);
    for (const double factor : {2., -1.})
      {
        body.equations.rod()->combine<1>({{{material.inertia,
                                            RodMatrices::momentum_mass,
                                            velocity_change.begin()}}},
                                         0.,
                                         nullptr,
                                         viscous_part.begin());
        solver.solve_viscous(size, viscous_part, velocity_change);
        velocity.add(factor, velocity_change);
      }
  }



  void
  BoxIntegrator::book(const State                   &state,
                      const double                   size,
                      const std::vector<EndContact> &ends,
                      StepResult                    &result)
  {
    set_equal(stage.velocity, rates.velocity);
    for (unsigned int c = 0; c < ends.size(); ++c)
      {
        stage.contact.pressure[c] = ends[c].contact.pressure;
        result.contact_dissipation +=
          size * body.contact_end().share(c) * ends[c].contact.damping_power;
      }
    for (unsigned int i = 0; i < stage.gap_rate.size(); ++i)
      stage.gap_rate[i] = (obstacle.gap[i] - state.gap[i]) / size;
    if (body.scene.sources.has_moving_end || body.boundary_flows.is_active())
      {
        set_sum(stage.displacement,
                state.displacement,
                0.5 * size,
                rates.velocity);
        set_equal(acceleration, rates.velocity);
        acceleration -= state.velocity;
        acceleration *= 2. / size;
      }

    result.add_impulse(size, stage.contact.pressure, body);
    result.work += size * body.energy.obstacle_power(stage) + work_of_impacts;
    const auto add = [&](const double       weight,
                         const Vector      &heat,
                         const Vector      &heating,
                         const MeanOfTimes &times) {
      result.add_dissipation(size * weight, stage, body);
      result.add_work(
        size * weight,
        {stage, heating, acceleration, heat, momentum_load, &times},
        body);
    };
    if (n_heat_stages == 0)
      add(1., heat_lift, heat_lift, load_times[0]);
    for (unsigned int i = 0; i < n_heat_stages; ++i)
      {
        set_equal(stage.temperature, state.temperature);
        for (unsigned int j = 0; j < n_heat_stages; ++j)
          stage.temperature.add(size * HeatStages::coefficients[i][j],
                                rates.temperature_rate[j]);
        stage.load_time = heat_times[i];
        if (!body.scene.heat.exchange->is_in_matrices())
          for (unsigned int c = 0; c < ends.size(); ++c)
            stage.contact.exchange_coefficient[c] = ends[c].coefficient[i];
        add(HeatStages::weights[i],
            heat_load[i],
            rates.temperature_rate[i],
            load_times[i]);
      }
  }
} // namespace ThermoContact
