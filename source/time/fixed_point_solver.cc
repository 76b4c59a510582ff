// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/stop_watch.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/method/impact_layer.h>
#include <thermocontact/multigrid/stage_preconditioner.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/fixed_point_solver.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /** A change by iterations whose square, which norms take, is still finite
     * after the next one. */
    constexpr double diverged = 1e100;
  } // namespace



  template <int dim>
  FixedPointSolver<dim>::FixedPointSolver(const Body<dim> &body)
    : body(body)
    , tolerance(body.scene.parameters.solver.fixed_point_tolerance)
    , max_iterations(body.scene.parameters.solver.fixed_point_iterations)
    , factorized_tau(0.)
    , preconditioner(make_stage_preconditioner(body))
    , heat_rhs(body.discretization.make_vector(Field::temperature))
    , momentum_rhs(body.discretization.make_vector(Field::displacement))
    , rhs(heat_rhs)
    , momentum_stage_rhs(momentum_rhs)
    , last_velocity(momentum_rhs)
  {}



  template <int dim>
  types::global_dof_index
  FixedPointSolver<dim>::n_factorized_unknowns() const
  {
    return preconditioner ? preconditioner->n_factorized_unknowns() :
                            std::max(body.discretization.n_temperature_dofs(),
                                     body.discretization.n_displacement_dofs());
  }



  template <int dim>
  void
  FixedPointSolver<dim>::factorize(const double tau)
  {
    const StopWatch watch(counters_.factorization_seconds);
    if (preconditioner)
      {
        preconditioner->make(tau);
        ++counters_.factorizations;
      }
    const auto make = [&](const Field::Block field) {
      auto system =
        std::make_unique<LinearSystem<dim>>(body.equations,
                                            stage_coefficients(tau).of(field),
                                            nullptr,
                                            LinearSystem<dim>::Rows::all,
                                            preconditioner.get());
      counters_.factorizations += system->n_factorizations();
      return system;
    };
    heat_system     = make(Field::temperature);
    momentum_system = make(Field::displacement);
    factorized_tau  = tau;
  }



  template <int dim>
  void
  FixedPointSolver<dim>::solve_field(const LinearSystem<dim> &system,
                                     const Vector            &right,
                                     Vector                  &solution)
  {
    const unsigned int n_before = system.n_iterations();
    system.solve(solution, right, body.scene.linear_solver.tolerance);
    counters_.count_iterations(system.n_iterations() - n_before);
  }



  template <int dim>
  RetainedFactorizations
  FixedPointSolver<dim>::retained() const
  {
    RetainedFactorizations retained;
    retained.counters = counters_;
    if (heat_system)
      retained.taus = {factorized_tau};
    return retained;
  }



  template <int dim>
  void
  FixedPointSolver<dim>::restore(const RetainedFactorizations &retained)
  {
    if (!retained.taus.empty())
      factorize(retained.taus.front());
    counters_ = retained.counters;
  }



  template <int dim>
  void
  FixedPointSolver<dim>::update_pressure(const double tau, StageRates &rates)
  {
    const ContactEnd<dim> &end = body.contact_end();
    end.get_values(Field::displacement, rates.velocity, contact_velocity);
    rates.contact.pressure.resize(contact_velocity.size());
    for (unsigned int i = 0; i < rates.contact.pressure.size(); ++i)
      {
        const double v = contact_velocity[i];
        rates.contact.pressure[i] =
          laws[i].pressure_at(known_position[i] + tau * v, v);
      }
  }



  template <int dim>
  void
  FixedPointSolver<dim>::solve(const State      &known,
                               const double      tau,
                               const Vector     &heat_load,
                               const Vector     &momentum_load,
                               const ContactMode mode,
                               StageRates       &rates)
  {
    Assert(mode == ContactMode::unilateral, ExcNotImplemented());
    (void)mode;
    const StopWatch watch(counters_.solve_seconds);
    if (tau != factorized_tau)
      factorize(tau);
    body.equations.stage_rhs(
      known, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    get_node_laws(body, known, laws, known_position);

    // the gap may be far beyond reach; it counts only if nothing moves
    const double reach =
      known.displacement.linfty_norm() + tau * known.velocity.linfty_norm();
    double known_scale = reach;
    if (reach == 0. && body.law().is_active())
      for (const double gap : known.gap)
        known_scale = std::max(known_scale, std::abs(gap));

    rates.start(known);
    rates.velocity = 0.; // the paper's start: the last displacement
    update_pressure(tau, rates);

    double change = 0., last_change = 0.;
    for (unsigned int iteration = 1; iteration <= max_iterations; ++iteration)
      {
        last_velocity = rates.velocity;

        rhs = heat_rhs;
        body.equations.add_heating(last_velocity, -1., rhs);
        solve_field(*heat_system, rhs, rates.temperature_rate);

        momentum_stage_rhs = momentum_rhs;
        body.equations.add_thermal_stress(rates.temperature_rate,
                                          tau * tau,
                                          momentum_stage_rhs);
        body.contact_end().subtract_load(Field::displacement,
                                         rates.contact.pressure,
                                         tau,
                                         momentum_stage_rhs);
        solve_field(*momentum_system, momentum_stage_rhs, rates.velocity);
        ++counters_.solves;
        update_pressure(tau, rates);

        last_velocity -= rates.velocity;
        last_change        = change;
        change             = tau * last_velocity.linfty_norm();
        rates.n_iterations = iteration;
        const double scale =
          std::max(known_scale, tau * rates.velocity.linfty_norm());
        if (change <= tolerance * scale)
          return;
        if (!(change < diverged))
          {
            change = infinity;
            break;
          }
      }
    rates.failure =
      describe_failure(tau, rates.n_iterations, change, last_change);
  }



  template <int dim>
  double
  FixedPointSolver<dim>::contraction_factor(const double tau)
  {
    if (!body.law().is_active())
      return 0.;
    // Power iteration for the largest eigenvalue of W, whose eigenvalues are
    // positive. One step is exact for one node. The start has a part in all
    // modes of a symmetric body.
    const unsigned int  n = body.contact_end().n_nodes();
    std::vector<double> pressure(n), response;
    for (unsigned int i = 0; i < n; ++i)
      pressure[i] = 1. + 1. / (i + 1.);
    Vector velocity(momentum_rhs);
    double eigenvalue = 0.;
    for (unsigned int iteration = 0; iteration < 200; ++iteration)
      {
        momentum_stage_rhs = 0.;
        body.contact_end().subtract_load(Field::displacement,
                                         pressure,
                                         -tau,
                                         momentum_stage_rhs);
        momentum_system->solve(velocity, momentum_stage_rhs);
        body.contact_end().get_values(Field::displacement, velocity, response);

        double norm = 0., response_norm = 0.;
        for (unsigned int i = 0; i < n; ++i)
          {
            norm          = std::max(norm, std::abs(pressure[i]));
            response_norm = std::max(response_norm, std::abs(response[i]));
          }
        const double last_eigenvalue = eigenvalue;
        eigenvalue                   = tau * response_norm / norm;
        if (n == 1 || std::abs(eigenvalue - last_eigenvalue) <=
                        Tolerances::eigenvalue_change * eigenvalue)
          break;
        for (unsigned int i = 0; i < n; ++i)
          pressure[i] = response[i] / response_norm;
      }
    return eigenvalue / body.law().tangent(0.);
  }



  template <int dim>
  std::string
  FixedPointSolver<dim>::describe_failure(const double       tau,
                                          const unsigned int n_iterations,
                                          const double       change,
                                          const double       last_change)
  {
    const double       rho = contraction_factor(tau);
    std::ostringstream message;
    message << "the fixed point iteration "
            << (std::isfinite(change) ? "did not converge" : "diverged")
            << " in " << n_iterations << " iterations";
    if (body.law().is_active())
      message << "\n  contraction factor rho = " << rho
              << " of the contact (chi / epsilon; it must be below 1)";
    if (const double factor = change / last_change; std::isfinite(factor))
      message << "\n  the last change was " << factor
              << " times the one before";
    message << "\n  remedy:  ";
    if (rho >= 1.)
      message << "Time/Step size below "
              << time_of_impact(body.scene.material.inertia,
                                body.scene.material.viscosity,
                                body.law().tangent(0.))
              << ", or ";
    else
      message << "more Solver/Fixed point iterations, a smaller Time/Step size "
                 "if the thermal coupling a = "
              << body.scene.material.thermal_stress << " is strong, or ";
    message << "Solver/Step solver = monolithic, which has no such limit";
    return message.str();
  }



  template class FixedPointSolver<1>;
  template class FixedPointSolver<2>;
  template class FixedPointSolver<3>;
} // namespace ThermoContact
