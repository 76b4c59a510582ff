// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/base/stop_watch.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/monolithic_solver.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ThermoContact
{
  unsigned int
  n_kept_factorizations(const unsigned int dim, const std::size_t n_unknowns)
  {
    return n_unknowns < 1000                   ? 64 :
           n_unknowns < (dim == 2 ? 10000 : 0) ? 32 :
           n_unknowns < 100000                 ? 8 :
                                                 2;
  }



  template <int dim>
  MonolithicSolver<dim>::MonolithicSolver(const Body<dim> &body)
    : body(body)
    , exchange(*body.scene.heat.exchange)
    , factorizations(
        n_kept_factorizations(dim, body.discretization.dof_handler().n_dofs()))
    , heat_rhs(body.discretization.make_vector(Field::temperature))
    , momentum_rhs(body.discretization.make_vector(Field::displacement))
  {}



  template <int dim>
  types::global_dof_index
  MonolithicSolver<dim>::n_factorized_unknowns() const
  {
    const Discretization<dim> &space = body.discretization;
    return body.equations.is_coupled() ?
             space.dof_handler().n_dofs() :
             std::max(space.n_temperature_dofs(), space.n_displacement_dofs());
  }



  template <int dim>
  void
  MonolithicSolver<dim>::provide_factorization(const double tau)
  {
    if (factorizations.use(tau))
      return;
    const StopWatch watch(counters_.factorization_seconds);
    keep(tau, LinearSystem<dim>(body.equations, stage_coefficients(tau)));
  }



  template <int dim>
  void
  MonolithicSolver<dim>::factorize(
    const double                                           tau,
    std::unique_ptr<const ThermoviscoelasticOperator<dim>> tangents)
  {
    const StopWatch watch(counters_.factorization_seconds);
    factorizations.clear();
    keep(tau, LinearSystem<dim>(std::move(tangents), stage_coefficients(tau)));
  }



  template <int dim>
  void
  MonolithicSolver<dim>::keep(const double tau, LinearSystem<dim> &&made)
  {
    factorizations.add({tau, std::move(made), {}, EndResponse()});
    const LinearSystem<dim> &system = factorizations.front().system;
    counters_.factorizations += system.n_factorizations();
    if (system.refused_growth() > 0. &&
        !std::exchange(has_refused_blocks, true))
      warnings.push_back(
        text("Solver/Linear solver = automatic: the blocks of the stage "
             "matrix grow by ",
             significant(system.refused_growth(), 2),
             " in a stage of length ",
             significant(tau, 3),
             ", more digits than a result may lose: sparse factors (direct) "
             "where they do"));
  }



  template <int dim>
  std::string
  MonolithicSolver<dim>::linear_solver() const
  {
    return !body.equations.is_eliminated_along_rod() ? "direct" :
           has_refused_blocks ? "block tridiagonal, direct" :
                                "block tridiagonal";
  }



  template <int dim>
  void
  MonolithicSolver<dim>::compute_unit_responses(const Field::Block load,
                                                Factorization &factorization)
  {
    const double tau = factorization.tau;
    for (unsigned int node = 0; node < body.contact_end().n_nodes(); ++node)
      {
        heat_rhs     = 0.;
        momentum_rhs = 0.;
        if (load == Field::displacement)
          body.contact_end().set_load_of_node(load, node, tau, momentum_rhs);
        else
          body.contact_end().set_load_of_node(load, node, 1., heat_rhs);
        UnitResponse &unit_response =
          factorization.unit_responses[load].emplace_back(
            UnitResponse{heat_rhs, momentum_rhs});
        factorization.system.solve(heat_rhs,
                                   momentum_rhs,
                                   unit_response.temperature_rate,
                                   unit_response.velocity);
        ++counters_.responses;
      }
  }



  template <int dim>
  FullMatrix<double>
  MonolithicSolver<dim>::loss_at_end(const Field::Block   field,
                                     const Field::Block   load,
                                     const Factorization &factorization) const
  {
    FullMatrix<double> matrix = body.contact_end().response_matrix(
      [&](const unsigned int node) -> const Vector & {
        const UnitResponse &response = factorization.unit_responses[load][node];
        return field == Field::displacement ? response.velocity :
                                              response.temperature_rate;
      },
      field);
    matrix *= factorization.tau;
    return matrix;
  }



  template <int dim>
  void
  MonolithicSolver<dim>::compute_response(Factorization &factorization)
  {
    const Field::Block pressure = Field::displacement;
    const Field::Block flux     = Field::temperature;
    EndResponse       &end      = factorization.end;
    compute_unit_responses(pressure, factorization);
    end.penetration_by_pressure =
      loss_at_end(Field::displacement, pressure, factorization);
    end.velocity_by_pressure = end.penetration_by_pressure;
    end.velocity_by_pressure /= factorization.tau;
    if (exchange.is_in_matrices())
      return;
    compute_unit_responses(flux, factorization);
    end.penetration_by_flux =
      loss_at_end(Field::displacement, flux, factorization);
    end.temperature_by_pressure =
      loss_at_end(Field::temperature, pressure, factorization);
    end.temperature_by_flux =
      loss_at_end(Field::temperature, flux, factorization);
  }



  template <int dim>
  RetainedFactorizations
  MonolithicSolver<dim>::retained() const
  {
    RetainedFactorizations retained;
    retained.counters           = counters_;
    retained.has_refused_blocks = has_refused_blocks;
    if (body.nonlinear)
      return retained; // each stage has its own
    for (const Factorization &factorization : factorizations.all())
      {
        retained.taus.push_back(factorization.tau);
        retained.has_response.push_back(factorization.has_response());
      }
    return retained;
  }



  template <int dim>
  void
  MonolithicSolver<dim>::restore(const RetainedFactorizations &retained)
  {
    factorizations.clear();
    for (unsigned int i = retained.taus.size(); i-- > 0;)
      {
        provide_factorization(retained.taus[i]);
        if (retained.has_response[i])
          compute_response(factorizations.front());
      }
    counters_          = retained.counters;
    has_refused_blocks = retained.has_refused_blocks;
    warnings.clear(); // the run has given them before
  }



  template <int dim>
  const FullMatrix<double> &
  MonolithicSolver<dim>::response()
  {
    Factorization &factorization = factorizations.front();
    if (!factorization.has_response())
      compute_response(factorization);
    return factorization.end.penetration_by_pressure;
  }



  template <int dim>
  const FullMatrix<double> &
  MonolithicSolver<dim>::response(const double tau)
  {
    {
      const StopWatch watch(counters_.solve_seconds);
      provide_factorization(tau);
    }
    const StopWatch watch(counters_.contact_seconds);
    return response();
  }



  template <int dim>
  void
  MonolithicSolver<dim>::apply_pressure(StageRates &rates)
  {
    subtract_responses(Field::displacement, rates.contact.pressure, rates);
  }



  template <int dim>
  void
  MonolithicSolver<dim>::subtract_responses(
    const Field::Block         load,
    const std::vector<double> &densities,
    StageRates                &rates) const
  {
    const auto &responses = factorizations.front().unit_responses[load];
    const bool  heats =
      load == Field::temperature || body.equations.is_coupled();
    for (unsigned int j = 0; j < densities.size(); ++j)
      if (const double density = densities[j]; density != 0.)
        {
          rates.velocity.add(-density, responses[j].velocity);
          if (heats)
            rates.temperature_rate.add(-density, responses[j].temperature_rate);
        }
  }



  template <int dim>
  void
  MonolithicSolver<dim>::solve_contact(const State &known, StageRates &rates)
  {
    const StopWatch watch(counters_.contact_seconds);
    bool            is_open = true;
    for (unsigned int i = 0; i < laws.size(); ++i)
      is_open &= laws[i].is_open(free[i]);
    if (is_open)
      return; // zero pressures solve (C2.4)

    rates.contact.pressure                          = known.contact.pressure;
    const FullMatrix<double> &displacement_response = response();
    rates.n_iterations =
      problem.solve(body.scene.contact.is_damped() ?
                      factorizations.front().end.velocity_by_pressure :
                      displacement_response,
                    laws,
                    free,
                    rates.contact.pressure);
    apply_pressure(rates);
  }



  template <int dim>
  void
  MonolithicSolver<dim>::solve_exchange(const State &known, StageRates &rates)
  {
    const StopWatch watch(counters_.contact_seconds);
    response();
    EndResponse           &response = factorizations.front().end;
    const double           tau      = factorizations.front().tau;
    const ContactEnd<dim> &end      = body.contact_end();
    response.free                   = free;
    response.x_per_displacement =
      body.scene.contact.is_damped() ? 1. / tau : 1.;
    end.get_values(Field::temperature, known.temperature, known_values);
    end.get_values(Field::temperature,
                   rates.temperature_rate,
                   response.free_temperature);
    response.time = known.load_time;
    response.surroundings.resize(known_values.size());
    for (unsigned int i = 0; i < known_values.size(); ++i)
      {
        response.surroundings[i] =
          body.surroundings.temperature(i, known.load_time);
        response.free_temperature[i] = known_values[i] -
                                       response.surroundings[i] +
                                       tau * response.free_temperature[i];
      }

    rates.contact      = known.contact;
    rates.n_iterations = solve_contact_and_exchange(
      exchange, response, laws, rates.contact, end_flux);
    apply_pressure(rates);
    subtract_responses(Field::temperature, end_flux, rates);
  }



  template <int dim>
  void
  MonolithicSolver<dim>::solve_without_contact(const State  &known,
                                               const double  tau,
                                               const Vector &heat_load,
                                               const Vector &momentum_load,
                                               StageRates   &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    rates.start(known);
    provide_factorization(tau);
    body.equations.stage_rhs(
      known, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    factorizations.front().system.solve(heat_rhs,
                                        momentum_rhs,
                                        rates.temperature_rate,
                                        rates.velocity);
    ++counters_.solves;
  }



  template <int dim>
  void
  MonolithicSolver<dim>::solve(const State      &known,
                               const double      tau,
                               const Vector     &heat_load,
                               const Vector     &momentum_load,
                               const ContactMode mode,
                               StageRates       &rates)
  {
    solve_without_contact(known, tau, heat_load, momentum_load, rates);
    const bool has_flux = !exchange.is_in_matrices();
    const bool has_contact =
      body.law().is_active() && mode != ContactMode::open;
    if (!has_flux && !has_contact)
      return;
    set_interface(known, mode, rates);
    if (has_flux)
      solve_exchange(known, rates);
    else
      solve_contact(known, rates);
    if (has_contact && has_lost_digits(known, rates))
      refine(known,
             heat_load,
             momentum_load,
             has_flux ? end_flux : std::vector<double>(),
             rates);
  }



  namespace
  {
    constexpr unsigned int max_refinements = 3;
  } // namespace



  template <int dim>
  void
  MonolithicSolver<dim>::set_interface(const State      &known,
                                       const ContactMode mode,
                                       const StageRates &rates)
  {
    const double factor = get_stage_laws(body,
                                         known,
                                         factorizations.front().tau,
                                         mode,
                                         rates.held_at,
                                         laws,
                                         start);
    // from the obstacle on: in contact the first term is small or zero, and the
    // sum keeps the digits of the second in short stages
    body.contact_end().get_values(Field::displacement, rates.velocity, free);
    for (unsigned int i = 0; i < laws.size(); ++i)
      free[i] = start[i] + factor * free[i];
  }



  template <int dim>
  void
  MonolithicSolver<dim>::subtract_response(
    const std::vector<AffineLaw> &laws,
    const std::vector<double>    &displacement,
    State                        &difference)
  {
    const FullMatrix<double> &receptance = response();
    std::vector<double>       slope(laws.size());
    for (unsigned int i = 0; i < slope.size(); ++i)
      slope[i] = laws[i].slope(receptance(i, i));
    const std::vector<double> pressure =
      change_of_pressure(receptance, slope, displacement);
    const Factorization &factorization = factorizations.front();
    for (unsigned int j = 0; j < pressure.size(); ++j)
      if (pressure[j] != 0.)
        {
          const UnitResponse &unit =
            factorization.unit_responses[Field::displacement][j];
          this->subtract(pressure[j],
                         factorization.tau,
                         body.scene.material.viscosity,
                         unit.velocity,
                         factorization.tau,
                         unit.temperature_rate,
                         difference);
        }
  }



  template <int dim>
  bool
  MonolithicSolver<dim>::has_lost_digits(const State      &known,
                                         const StageRates &rates)
  {
    if (body.scene.contact.is_damped())
      return false; // not a body in equilibrium with its obstacle
    const double tau        = factorizations.front().tau;
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
    // velocities of a body at rest need no digits: to move by its displacement
    // in a unit of time is little
    return free_moved > Tolerances::tolerated_cancellation * moved &&
           free_moved > Tolerances::tolerated_cancellation * tau *
                          known.displacement.linfty_norm();
  }



  template <int dim>
  void
  MonolithicSolver<dim>::compute_residual(const State  &known,
                                          const Vector &heat_load,
                                          const Vector &momentum_load,
                                          const std::vector<double> &flux,
                                          const StageRates          &rates,
                                          StageRates                &products)
  {
    const double tau = factorizations.front().tau;
    body.equations.stage_rhs(
      known, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    factorizations.front().system.of_equations().product(
      stage_coefficients(tau),
      rates.temperature_rate,
      rates.velocity,
      products.temperature_rate,
      products.velocity);
    if (body.scene.fields.has_temperature)
      heat_rhs -= products.temperature_rate;
    momentum_rhs -= products.velocity;
    if (!flux.empty())
      body.contact_end().subtract_load(Field::temperature, flux, 1., heat_rhs);
    body.contact_end().subtract_load(Field::displacement,
                                     rates.contact.pressure,
                                     tau,
                                     momentum_rhs);
    if (body.scene.fields.has_temperature)
      body.equations.zero_constrained(Field::temperature, heat_rhs);
    body.equations.zero_constrained(Field::displacement, momentum_rhs);
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
    const double              tau        = factorizations.front().tau;
    const unsigned int        n          = rates.contact.pressure.size();
    const FullMatrix<double> &receptance = response();
    StageRates                change(rates);
    std::vector<double>       slope(n, 0.), misfit;
    for (unsigned int i = 0; i < n; ++i)
      if (laws[i].is_held || rates.contact.pressure[i] != 0.)
        slope[i] = laws[i]
                     .tangent_of_pressure(rates.contact.pressure[i])
                     .slope(receptance(i, i));

    for (unsigned int k = 0; k < max_refinements; ++k)
      {
        compute_residual(known, heat_load, momentum_load, flux, rates, change);
        factorizations.front().system.solve(heat_rhs,
                                            momentum_rhs,
                                            change.temperature_rate,
                                            change.velocity);
        change.velocity += rates.velocity;
        body.contact_end().get_values(Field::displacement,
                                      change.velocity,
                                      misfit);
        for (unsigned int i = 0; i < n; ++i)
          misfit[i] = start[i] + tau * misfit[i] -
                      laws[i].position_of_pressure(rates.contact.pressure[i]);
        change.velocity -= rates.velocity;
        change.contact.pressure = change_of_pressure(receptance, slope, misfit);
        for (unsigned int i = 0; i < n; ++i)
          {
            double &p = rates.contact.pressure[i];
            if (!laws[i].is_held) // no obstacle pulls
              change.contact.pressure[i] =
                p < 0. ? std::min(change.contact.pressure[i], -p) :
                         std::max(change.contact.pressure[i], -p);
            p += change.contact.pressure[i];
          }
        apply_pressure(change);
        rates.temperature_rate += change.temperature_rate;
        rates.velocity += change.velocity;
        if (change.velocity.linfty_norm() <=
            Tolerances::refined_change *
              std::max(rates.velocity.linfty_norm(),
                       known.displacement.linfty_norm()))
          return;
      }
  }



  template class MonolithicSolver<1>;
  template class MonolithicSolver<2>;
  template class MonolithicSolver<3>;
} // namespace ThermoContact
