// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/stop_watch.h>
#include <thermocontact/time/iterative_solver.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Relative residual while the set of active nodes still changes. */
    constexpr double loose_tolerance = 1e-5;

    constexpr unsigned int max_block_sets  = 20;
    constexpr unsigned int max_single_sets = 200;
  } // namespace



  template <int dim>
  IterativeSolver<dim>::IterativeSolver(const Body<dim> &body)
    : body(body)
    , stage(body)
  {}



  template <int dim>
  types::global_dof_index
  IterativeSolver<dim>::n_factorized_unknowns() const
  {
    const Discretization<dim> &coarsest =
      stage.multigrid_levels().discretization(0);
    return std::max(coarsest.n_temperature_dofs(),
                    coarsest.n_displacement_dofs());
  }



  template <int dim>
  void
  IterativeSolver<dim>::provide_hierarchy(const double tau)
  {
    const StopWatch watch(counters_.factorization_seconds);
    if (stage.preconditioners().provide(tau))
      ++counters_.factorizations;
  }



  template <int dim>
  RetainedFactorizations
  IterativeSolver<dim>::retained() const
  {
    RetainedFactorizations retained;
    retained.counters = counters_;
    retained.taus     = stage.preconditioners().lengths();
    retained.has_response.assign(retained.taus.size(), false);
    return retained;
  }



  template <int dim>
  void
  IterativeSolver<dim>::restore(const RetainedFactorizations &retained)
  {
    stage.preconditioners().clear();
    for (unsigned int i = retained.taus.size(); i-- > 0;)
      provide_hierarchy(retained.taus[i]);
    counters_ = retained.counters;
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_linear(const double         tolerance,
                                     std::vector<double> &pressure)
  {
    const unsigned int n_iterations = stage.solve(tolerance);
    counters_.linear_iterations += n_iterations;
    counters_.max_linear_iterations =
      std::max(counters_.max_linear_iterations, n_iterations);
    stage.get_pressures(pressure);
  }



  template <int dim>
  bool
  IterativeSolver<dim>::update_set(const std::vector<double> &pressure,
                                   const bool                 only_the_first,
                                   std::vector<bool>         &is_active) const
  {
    std::vector<double> reach;
    stage.get_reach(reach);
    double largest_pressure = 0., largest_reach = 0.;
    for (unsigned int i = 0; i < reach.size(); ++i)
      {
        largest_pressure = std::max(largest_pressure, std::abs(pressure[i]));
        largest_reach    = std::max(largest_reach, std::abs(reach[i]));
      }
    // A node that touches without pressure must not flip for ever.
    const double rounding = 1e-13;
    bool         changed  = false;
    for (unsigned int i = 0; i < reach.size() && !(changed && only_the_first);
         ++i)
      if (is_active[i] ? pressure[i] < -rounding * largest_pressure :
                         reach[i] > rounding * largest_reach)
        {
          is_active[i] = !is_active[i];
          changed      = true;
        }
    return changed;
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_prepared(const State      &known,
                                       const ContactMode mode,
                                       StageRates       &rates)
  {
    const unsigned int n         = body.contact_end().n_nodes();
    const double       tolerance = body.scene.linear_solver.tolerance;
    rates.failure.clear();
    rates.pressure.assign(n, 0.);
    rates.exchange_coefficient = known.exchange_coefficient;
    std::vector<bool> is_active(n, false);
    if (body.law().is_active() && mode != ContactMode::open)
      for (unsigned int i = 0; i < n; ++i)
        is_active[i] =
          mode == ContactMode::closed || known.contact_pressure[i] > 0.;
    stage.set_active(is_active);
    if (!body.law().is_active() || mode != ContactMode::unilateral)
      {
        solve_linear(tolerance, rates.pressure);
        return;
      }
    unsigned int n_sets            = 0;
    double       present_tolerance = std::max(tolerance, loose_tolerance);
    while (true)
      {
        ++n_sets;
        solve_linear(present_tolerance, rates.pressure);
        if (update_set(rates.pressure, n_sets > max_block_sets, is_active))
          stage.set_active(is_active);
        else if (present_tolerance <= tolerance)
          break;
        else
          {
            --n_sets; // the same set again
            present_tolerance = tolerance;
          }
        if (n_sets > max_block_sets + max_single_sets)
          throw ComputationError(
            "the active set of " + std::to_string(n) +
            " contact nodes did not settle\n  remedy:  a larger "
            "Contact/Compliance or a smaller Time/Step size");
      }
    for (double &p : rates.pressure)
      p = std::max(p, 0.);
    rates.n_iterations = n_sets;
    counters_.active_set_iterations += n_sets;
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_fields(const State      &known,
                                     const double      tau,
                                     const Vector     &heat_load,
                                     const Vector     &momentum_load,
                                     const ContactMode mode,
                                     const bool        with_heat,
                                     StageRates       &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    provide_hierarchy(tau);
    stage.prepare(known, tau, heat_load, momentum_load, with_heat);
    solve_prepared(known, mode, rates);
    ++counters_.solves;
    if (with_heat)
      rates.temperature_rate.equ(1. / tau, stage.unknowns(Field::temperature));
    if (body.scene.fields.has_displacement)
      rates.velocity.copy_locally_owned_data_from(
        stage.unknowns(Field::displacement));
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve(const State      &known,
                              const double      tau,
                              const Vector     &heat_load,
                              const Vector     &momentum_load,
                              const ContactMode mode,
                              StageRates       &rates)
  {
    solve_fields(known,
                 tau,
                 heat_load,
                 momentum_load,
                 mode,
                 body.scene.fields.has_temperature,
                 rates);
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_momentum(const State      &known,
                                       const double      tau,
                                       const Vector     &heat_load,
                                       const Vector     &momentum_load,
                                       const ContactMode mode,
                                       StageRates       &rates)
  {
    solve_fields(known, tau, heat_load, momentum_load, mode, false, rates);
  }



  template class IterativeSolver<2>;
  template class IterativeSolver<3>;
} // namespace ThermoContact
