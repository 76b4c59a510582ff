// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/stop_watch.h>
#include <thermocontact/time/monolithic_solver.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** As many factorisations as small scenes profit from, and large ones
     * have memory for. */
    template <int dim>
    unsigned int
    cache_size(const types::global_dof_index n_unknowns)
    {
      return n_unknowns < 1000                   ? 64 :
             n_unknowns < (dim == 2 ? 10000 : 0) ? 32 :
             n_unknowns < 100000                 ? 8 :
                                                   2;
    }
  } // namespace



  template <int dim>
  MonolithicSolver<dim>::MonolithicSolver(const Body<dim> &body)
    : body(body)
    , contact_solver(body.law())
    , max_factorizations(
        cache_size<dim>(body.discretization.dof_handler().n_dofs()))
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
    const auto known = std::find_if(factorizations.begin(),
                                    factorizations.end(),
                                    [tau](const Factorization &f) {
                                      return f.matrix.tau() == tau;
                                    });
    if (known != factorizations.end())
      {
        factorizations.splice(factorizations.begin(), factorizations, known);
        return;
      }
    const StopWatch watch(counters_.factorization_seconds);
    while (factorizations.size() >= max_factorizations)
      factorizations.pop_back();
    factorizations.push_front(
      {StageFactorization<dim>(body.discretization, body.equations, tau),
       {},
       FullMatrix<double>()});
    counters_.factorizations +=
      factorizations.front().matrix.n_factorizations();
  }



  template <int dim>
  void
  MonolithicSolver<dim>::compute_response(Factorization &factorization)
  {
    const double tau       = factorization.matrix.tau();
    factorization.response = body.contact_end().response_matrix(
      [&](const unsigned int node) -> const Vector & {
        std::vector<double> unit_pressure(body.contact_end().n_nodes(), 0.);
        unit_pressure[node] = 1.;
        heat_rhs            = 0.;
        momentum_rhs        = 0.;
        body.equations.subtract_pressure(unit_pressure, -tau, momentum_rhs);
        factorization.unit_responses.push_back({heat_rhs, momentum_rhs});
        UnitResponse &unit_response = factorization.unit_responses.back();
        factorization.matrix.solve(heat_rhs,
                                   momentum_rhs,
                                   unit_response.temperature_rate,
                                   unit_response.velocity);
        ++counters_.responses;
        return unit_response.velocity;
      });
    factorization.response *= tau;
  }



  template <int dim>
  RetainedFactorizations
  MonolithicSolver<dim>::retained() const
  {
    RetainedFactorizations retained;
    retained.counters = counters_;
    for (const Factorization &factorization : factorizations)
      {
        retained.taus.push_back(factorization.matrix.tau());
        retained.has_response.push_back(!factorization.unit_responses.empty());
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
    counters_ = retained.counters;
  }



  template <int dim>
  const FullMatrix<double> &
  MonolithicSolver<dim>::response()
  {
    Factorization &factorization = factorizations.front();
    if (factorization.unit_responses.empty())
      compute_response(factorization);
    return factorization.response;
  }



  template <int dim>
  void
  MonolithicSolver<dim>::apply_pressure(StageRates &rates) const
  {
    const Factorization &factorization = factorizations.front();
    for (unsigned int j = 0; j < rates.pressure.size(); ++j)
      if (const double p = rates.pressure[j]; p != 0.)
        {
          const UnitResponse &unit_response = factorization.unit_responses[j];
          rates.velocity.add(-p, unit_response.velocity);
          if (body.equations.is_coupled())
            rates.temperature_rate.add(-p, unit_response.temperature_rate);
        }
  }



  template <int dim>
  void
  MonolithicSolver<dim>::solve_contact(const State      &known,
                                       const ContactMode mode,
                                       StageRates       &rates)
  {
    const StopWatch        watch(counters_.contact_seconds);
    const double           tau = factorizations.front().matrix.tau();
    const ContactEnd<dim> &end = body.contact_end();
    // from the obstacle on: in contact the first term is small or zero, and
    // the sum keeps the digits of the second in short stages
    end.get_penetrations(known.displacement, known_penetration);
    end.get_values(Field::displacement, rates.velocity, free_penetration);
    bool reaches_obstacle = false;
    for (unsigned int i = 0; i < free_penetration.size(); ++i)
      {
        free_penetration[i] = known_penetration[i] + tau * free_penetration[i];
        reaches_obstacle |= free_penetration[i] > 0. ||
                            (!rates.is_held.empty() && rates.is_held[i]);
      }
    if (mode == ContactMode::unilateral && !reaches_obstacle)
      return; // no node is pushed back: zero pressures solve (M.18)

    std::copy(known.contact_pressure.begin(),
              known.contact_pressure.end(),
              rates.pressure.begin());
    if (mode == ContactMode::closed)
      contact_solver.solve_closed(response(), free_penetration, rates.pressure);
    else
      rates.n_iterations = contact_solver.solve(response(),
                                                free_penetration,
                                                rates.pressure,
                                                rates.is_held);
    apply_pressure(rates);
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
          const UnitResponse &unit_response = factorization.unit_responses[j];
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
  MonolithicSolver<dim>::solve_without_contact(const State  &known,
                                               const double  tau,
                                               const Vector &heat_load,
                                               const Vector &momentum_load,
                                               StageRates   &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    provide_factorization(tau);
    body.equations.stage_rhs(
      known, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    factorizations.front().matrix.solve(heat_rhs,
                                        momentum_rhs,
                                        rates.temperature_rate,
                                        rates.velocity);
    ++counters_.solves;

    rates.failure.clear();
    rates.n_iterations = 0;
    rates.pressure.assign(body.contact_end().n_nodes(), 0.);
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
    if (body.law().is_active() && mode != ContactMode::open)
      solve_contact(known, mode, rates);
  }



  template class MonolithicSolver<1>;
  template class MonolithicSolver<2>;
  template class MonolithicSolver<3>;
} // namespace ThermoContact
