// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/stop_watch.h>
#include <thermocontact/space/nearer_stop.h>
#include <thermocontact/time/monolithic_solver.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Four of sixteen digits may go. */
    constexpr double largest_loss = 1e4;

    constexpr unsigned int max_refinements = 3;

    /** Relative change at which velocities are refined no further. */
    constexpr double small_change = 1e-8;

    double
    largest_difference(const std::vector<double> &x,
                       const std::vector<double> &y)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < x.size(); ++i)
        largest = std::max(largest, std::abs(x[i] - y[i]));
      return largest;
    }
  } // namespace



  template <int dim>
  void
  MonolithicSolver<dim>::get_free_penetration(const State      &known,
                                              const StageRates &rates)
  {
    const double           tau = factorizations.front().matrix.tau();
    const ContactEnd<dim> &end = body.contact_end();
    // from the obstacle on: in contact the first term is small or zero, and
    // the sum keeps the digits of the second in short stages
    look_at_stops(body, known, stops);
    for (unsigned int i = 0; i < rates.held_at.size(); ++i)
      if (rates.held_at[i] != 0)
        stops.see_from(i, rates.held_at[i]);
    end.get_values(Field::displacement, rates.velocity, free_penetration);
    stops.turn(free_penetration);
    far_penetration = stops.far;
    for (unsigned int i = 0; i < far_penetration.size(); ++i)
      far_penetration[i] -= tau * free_penetration[i];
    for (unsigned int i = 0; i < free_penetration.size(); ++i)
      free_penetration[i] = stops.near[i] + tau * free_penetration[i];
  }



  template <int dim>
  bool
  MonolithicSolver<dim>::reaches_a_stop() const
  {
    const auto is_beyond = [](const double s) { return s > 0.; };
    return std::any_of(free_penetration.begin(),
                       free_penetration.end(),
                       is_beyond) ||
           std::any_of(far_penetration.begin(),
                       far_penetration.end(),
                       is_beyond);
  }



  template <int dim>
  const FullMatrix<double> &
  MonolithicSolver<dim>::seen_response()
  {
    if (!stops.are_two())
      return response();
    turned_response = stops.turned(response());
    return turned_response;
  }



  template <int dim>
  void
  MonolithicSolver<dim>::keep_contact(const std::vector<bool>   &is_closed,
                                      const std::vector<double> &pressure,
                                      State                     &difference)
  {
    if (std::find(is_closed.begin(), is_closed.end(), true) == is_closed.end())
      return;
    std::vector<double> displacement;
    body.contact_end().get_values(Field::displacement,
                                  difference.displacement,
                                  displacement);
    const std::vector<double> change = contact_solver.solve_linearized(
      response(), pressure, is_closed, displacement);

    // Viscous stress alone has carried the displacement of the nodes into the
    // velocity of the others: elastic stress does so with higher order.
    const Factorization &factorization = factorizations.front();
    const double         tau           = factorization.matrix.tau();
    const double         viscosity     = body.scene.material.viscosity;
    for (unsigned int j = 0; j < change.size(); ++j)
      if (const double p = change[j]; p != 0.)
        {
          const UnitResponse &unit_response =
            factorization.unit_responses[Field::displacement][j];
          difference.displacement.add(-p * tau, unit_response.velocity);
          difference.velocity.add(-p * viscosity / (viscosity + tau),
                                  unit_response.velocity);
          if (body.equations.is_coupled())
            difference.temperature.add(-p * tau,
                                       unit_response.temperature_rate);
        }
  }



  template <int dim>
  void
  MonolithicSolver<dim>::get_nodes_in_motion(const State      &known,
                                             const ContactMode mode,
                                             const StageRates &rates)
  {
    const ContactEnd<dim> &end = body.contact_end();
    nodes_in_motion.tau        = factorizations.front().matrix.tau();
    nodes_in_motion.is_held    = rates.is_held;
    if (mode == ContactMode::closed)
      nodes_in_motion.is_held.assign(end.n_nodes(), true);
    nodes_in_motion.start     = stops.near;
    nodes_in_motion.far_start = stops.far;
    end.get_values(Field::displacement,
                   rates.velocity,
                   nodes_in_motion.free_velocity);
    // as the obstacle sees them, which has moved to the end of the stage
    for (unsigned int i = 0; i < known.gap_rate.size(); ++i)
      {
        nodes_in_motion.start[i] += nodes_in_motion.tau * known.gap_rate[i];
        nodes_in_motion.free_velocity[i] -= known.gap_rate[i];
      }
    stops.turn(nodes_in_motion.free_velocity);
  }



  template <int dim>
  void
  MonolithicSolver<dim>::solve_damped_contact(const State      &known,
                                              const ContactMode mode,
                                              StageRates       &rates)
  {
    get_nodes_in_motion(known, mode, rates);
    FullMatrix<double> velocity_response(seen_response());
    velocity_response /= nodes_in_motion.tau;
    rates.n_iterations =
      damped_contact.solve(velocity_response, nodes_in_motion, rates.pressure);
  }



  template <int dim>
  bool
  MonolithicSolver<dim>::has_lost_digits(const State      &known,
                                         const StageRates &rates)
  {
    if (body.law().damping() > 0.)
      return false; // not a body in equilibrium with its obstacle
    const double tau  = factorizations.front().matrix.tau();
    const double free = largest_difference(free_penetration, stops.near);
    body.contact_end().get_values(Field::displacement,
                                  rates.velocity,
                                  end_values);
    double fastest = 0.;
    for (const double velocity : end_values)
      fastest = std::max(fastest, std::abs(velocity));
    const double moved = tau * fastest;
    // velocities of a body at rest need no digits: what moves it by its
    // displacement in a unit of time is small
    return free > largest_loss * moved &&
           free > largest_loss * tau * known.displacement.linfty_norm();
  }



  template <int dim>
  void
  MonolithicSolver<dim>::compute_residual(const State  &known,
                                          const Vector &heat_load,
                                          const Vector &momentum_load,
                                          const std::vector<double> &flux,
                                          const StageRates          &rates)
  {
    const ThermoviscoelasticOperator<dim> &equations = body.equations;
    const Material                        &material  = body.scene.material;
    const double tau = factorizations.front().matrix.tau();
    equations.stage_rhs(
      known, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    const auto subtract = [](const LinearMap &matrix,
                             const double     factor,
                             const Vector    &x,
                             Vector          &rows) {
      Vector product(rows);
      matrix.vmult(product, x);
      rows.add(-factor, product);
    };
    if (body.scene.fields.has_temperature)
      {
        const Vector &rate = rates.temperature_rate;
        subtract(equations.heat_mass(), 1., rate, heat_rhs);
        subtract(equations.conduction(), tau, rate, heat_rhs);
        equations.subtract_heating(rates.velocity, heat_rhs);
        if (!flux.empty())
          body.contact_end().subtract_load(Field::temperature,
                                           flux,
                                           1.,
                                           heat_rhs);
        equations.zero_constrained(Field::temperature, heat_rhs);
        equations.add_thermal_stress(rate, tau * tau, momentum_rhs);
      }
    const Vector &velocity = rates.velocity;
    if (material.has_inertia())
      subtract(equations.momentum_mass(),
               material.inertia,
               velocity,
               momentum_rhs);
    if (material.has_viscosity())
      subtract(equations.viscous_stiffness(),
               tau * material.viscosity,
               velocity,
               momentum_rhs);
    subtract(equations.stiffness(), tau * tau, velocity, momentum_rhs);
    body.contact_end().subtract_load(Field::displacement,
                                     rates.pressure,
                                     tau,
                                     momentum_rhs);
    equations.zero_constrained(Field::displacement, momentum_rhs);
  }



  template <int dim>
  std::vector<double>
  MonolithicSolver<dim>::misfit_of_law(const std::vector<bool>   &is_far,
                                       const std::vector<double> &pressure,
                                       const Vector &velocity) const
  {
    const double        tau = factorizations.front().matrix.tau();
    std::vector<double> misfit;
    body.contact_end().get_values(Field::displacement, velocity, misfit);
    stops.turn(misfit);
    for (unsigned int i = 0; i < misfit.size(); ++i)
      {
        const double way = tau * misfit[i];
        misfit[i] = (is_far[i] ? way - stops.far[i] : stops.near[i] + way) -
                    body.law().penetration(pressure[i]);
      }
    return misfit;
  }



  template <int dim>
  void
  MonolithicSolver<dim>::refine(const State               &known,
                                const Vector              &heat_load,
                                const Vector              &momentum_load,
                                const ContactMode          mode,
                                const std::vector<double> &flux,
                                StageRates                &rates)
  {
    const StopWatch     watch(counters_.contact_seconds);
    const unsigned int  n = rates.pressure.size();
    StageRates          change(rates);
    std::vector<double> pressure(rates.pressure); // seen from the stops
    std::vector<bool>   is_fixed(rates.is_held), is_active(n), is_far(n);
    is_fixed.resize(n, mode == ContactMode::closed);
    stops.turn(pressure);
    for (unsigned int i = 0; i < n; ++i)
      {
        is_far[i]    = !is_fixed[i] && pressure[i] < 0.;
        is_active[i] = is_fixed[i] || pressure[i] != 0.;
      }

    for (unsigned int k = 0; k < max_refinements; ++k)
      {
        compute_residual(known, heat_load, momentum_load, flux, rates);
        factorizations.front().matrix.solve(heat_rhs,
                                            momentum_rhs,
                                            change.temperature_rate,
                                            change.velocity);
        change.velocity += rates.velocity;
        const std::vector<double> misfit =
          misfit_of_law(is_far, pressure, change.velocity);
        change.velocity -= rates.velocity;
        change.pressure = contact_solver.solve_linearized(seen_response(),
                                                          pressure,
                                                          is_active,
                                                          misfit);
        for (unsigned int i = 0; i < n; ++i)
          {
            if (!is_fixed[i]) // no stop pulls
              change.pressure[i] =
                is_far[i] ? std::min(change.pressure[i], -pressure[i]) :
                            std::max(change.pressure[i], -pressure[i]);
            pressure[i] += change.pressure[i];
          }
        stops.turn(change.pressure);
        apply_pressure(change);

        rates.temperature_rate += change.temperature_rate;
        rates.velocity += change.velocity;
        for (unsigned int i = 0; i < n; ++i)
          rates.pressure[i] += change.pressure[i];
        if (change.velocity.linfty_norm() <=
            small_change * std::max(rates.velocity.linfty_norm(),
                                    known.displacement.linfty_norm()))
          return;
      }
  }



#define INSTANTIATE(dim)                                                       \
  template void MonolithicSolver<dim>::get_free_penetration(                   \
    const State &, const StageRates &);                                        \
  template bool MonolithicSolver<dim>::reaches_a_stop() const;                 \
  template void MonolithicSolver<dim>::keep_contact(                           \
    const std::vector<bool> &, const std::vector<double> &, State &);          \
  template void MonolithicSolver<dim>::get_nodes_in_motion(                    \
    const State &, const ContactMode, const StageRates &);                     \
  template void MonolithicSolver<dim>::solve_damped_contact(const State &,     \
                                                            const ContactMode, \
                                                            StageRates &);     \
  template std::vector<double> MonolithicSolver<dim>::misfit_of_law(           \
    const std::vector<bool> &, const std::vector<double> &, const Vector &)    \
    const;                                                                     \
  template bool MonolithicSolver<dim>::has_lost_digits(const State &,          \
                                                       const StageRates &);    \
  template void MonolithicSolver<dim>::refine(const State &,                   \
                                              const Vector &,                  \
                                              const Vector &,                  \
                                              const ContactMode,               \
                                              const std::vector<double> &,     \
                                              StageRates &);                   \
  template const FullMatrix<double> &MonolithicSolver<dim>::seen_response()

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
