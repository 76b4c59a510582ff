// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/stop_watch.h>
#include <thermocontact/space/node_laws.h>
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
  } // namespace



  template <int dim>
  void
  MonolithicSolver<dim>::set_interface(const State      &known,
                                       const ContactMode mode,
                                       const StageRates &rates)
  {
    const double tau = factorizations.front().matrix.tau();
    get_node_laws(body, known, laws, start);
    body.contact_end().get_values(Field::displacement, rates.velocity, free);
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        NodeLaw   &law    = laws[i];
        const bool has_to = !rates.held_at.empty() && rates.held_at[i] != 0;
        if (has_to && rates.held_at[i] != law.side)
          start[i] = law.change_side(start[i]);
        law.is_held = mode == ContactMode::closed ||
                      (!rates.is_held.empty() && rates.is_held[i]);
        if (mode == ContactMode::open)
          law.law = nullptr;
        if (body.law().damping() == 0.)
          {
            // from the obstacle on: in contact the first term is small or zero,
            // and the sum keeps the digits of the second in short stages
            free[i] = start[i] + tau * free[i];
            continue;
          }
        // as the obstacle sees it, which has moved to the end of the stage
        const double gap_rate = known.gap_rate.empty() ? 0. : known.gap_rate[i];
        law.is_in_velocity    = true;
        law.start             = start[i] + tau * gap_rate;
        law.tau               = tau;
        free[i] -= gap_rate;
      }
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
    const FullMatrix<double> &receptance = response();
    std::vector<double>       slope(is_closed.size(), 0.);
    for (unsigned int i = 0; i < slope.size(); ++i)
      if (is_closed[i])
        slope[i] =
          NodeLaw(body.law()).slope_of_pressure(pressure[i], receptance(i, i));
    const std::vector<double> change =
      change_of_pressure(receptance, slope, displacement);

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
  bool
  MonolithicSolver<dim>::has_lost_digits(const State      &known,
                                         const StageRates &rates)
  {
    if (body.law().damping() > 0.)
      return false; // not a body in equilibrium with its obstacle
    const double tau        = factorizations.front().matrix.tau();
    double       free_moved = 0.;
    for (unsigned int i = 0; i < free.size(); ++i)
      free_moved = std::max(free_moved, std::abs(free[i] - start[i]));
    body.contact_end().get_values(Field::displacement,
                                  rates.velocity,
                                  end_values);
    double fastest = 0.;
    for (const double velocity : end_values)
      fastest = std::max(fastest, std::abs(velocity));
    const double moved = tau * fastest;
    // velocities of a body at rest need no digits: what moves it by its
    // displacement in a unit of time is small
    return free_moved > largest_loss * moved &&
           free_moved > largest_loss * tau * known.displacement.linfty_norm();
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
  void
  MonolithicSolver<dim>::refine(const State               &known,
                                const Vector              &heat_load,
                                const Vector              &momentum_load,
                                const std::vector<double> &flux,
                                StageRates                &rates)
  {
    const StopWatch           watch(counters_.contact_seconds);
    const double              tau        = factorizations.front().matrix.tau();
    const unsigned int        n          = rates.pressure.size();
    const FullMatrix<double> &receptance = response();
    StageRates                change(rates);
    std::vector<double>       slope(n, 0.), misfit;
    for (unsigned int i = 0; i < n; ++i)
      if (laws[i].is_held || rates.pressure[i] != 0.)
        slope[i] =
          laws[i].slope_of_pressure(rates.pressure[i], receptance(i, i));

    for (unsigned int k = 0; k < max_refinements; ++k)
      {
        compute_residual(known, heat_load, momentum_load, flux, rates);
        factorizations.front().matrix.solve(heat_rhs,
                                            momentum_rhs,
                                            change.temperature_rate,
                                            change.velocity);
        change.velocity += rates.velocity;
        body.contact_end().get_values(Field::displacement,
                                      change.velocity,
                                      misfit);
        for (unsigned int i = 0; i < n; ++i)
          misfit[i] = start[i] + tau * misfit[i] -
                      laws[i].position_of_pressure(rates.pressure[i]);
        change.velocity -= rates.velocity;
        change.pressure = change_of_pressure(receptance, slope, misfit);
        for (unsigned int i = 0; i < n; ++i)
          {
            double &p = rates.pressure[i];
            if (!laws[i].is_held) // no obstacle pulls
              change.pressure[i] = p < 0. ? std::min(change.pressure[i], -p) :
                                            std::max(change.pressure[i], -p);
            p += change.pressure[i];
          }
        apply_pressure(change);
        rates.temperature_rate += change.temperature_rate;
        rates.velocity += change.velocity;
        if (change.velocity.linfty_norm() <=
            small_change * std::max(rates.velocity.linfty_norm(),
                                    known.displacement.linfty_norm()))
          return;
      }
  }



#define INSTANTIATE(dim)                                                    \
  template void MonolithicSolver<dim>::set_interface(const State &,         \
                                                     const ContactMode,     \
                                                     const StageRates &);   \
  template void MonolithicSolver<dim>::keep_contact(                        \
    const std::vector<bool> &, const std::vector<double> &, State &);       \
  template bool MonolithicSolver<dim>::has_lost_digits(const State &,       \
                                                       const StageRates &); \
  template void MonolithicSolver<dim>::refine(const State &,                \
                                              const Vector &,               \
                                              const Vector &,               \
                                              const std::vector<double> &,  \
                                              StageRates &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
