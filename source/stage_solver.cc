// SPDX-License-Identifier: LGPL-2.1-or-later

#include "stage_solver.h"

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** As many factorisations as small scenes profit from, and large ones
     * have memory for. */
    unsigned int
    cache_size(const types::global_dof_index n_unknowns)
    {
      return n_unknowns < 1000 ? 64 : n_unknowns < 100000 ? 8 : 2;
    }
  } // namespace



  template <int dim>
  StageSolver<dim>::StageSolver(
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &stage_operator,
    const ContactLaw                      &law)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , law(law)
    , contact_solver(law)
    , max_factorizations(cache_size(discretization.dof_handler().n_dofs()))
    , heat_rhs(discretization.make_vector(0))
    , momentum_rhs(discretization.make_vector(1))
    , system_rhs(discretization.make_system_vector())
    , system_rates(system_rhs)
  {}



  template <int dim>
  types::global_dof_index
  StageSolver<dim>::n_factorized_unknowns() const
  {
    return discretization.dof_handler().n_dofs();
  }



  template <int dim>
  void
  StageSolver<dim>::provide_factorization(const double tau)
  {
    const auto known =
      std::find_if(factorizations.begin(),
                   factorizations.end(),
                   [tau](const Factorization &f) { return f.tau == tau; });
    if (known != factorizations.end())
      {
        factorizations.splice(factorizations.begin(), factorizations, known);
        return;
      }
    while (factorizations.size() >= max_factorizations)
      factorizations.pop_back();
    Factorization &factorization = factorizations.emplace_front();
    factorization.tau            = tau;
    factorization.solver =
      std::make_unique<DirectSolver>(stage_operator.stage_matrix(tau));
    ++counters_.factorizations;
  }



  template <int dim>
  void
  StageSolver<dim>::compute_response(Factorization &factorization)
  {
    const unsigned int n = discretization.contact_nodes().size();
    factorization.response.reinit(n, n);
    std::vector<double> displacement(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        std::vector<double> unit_pressure(n, 0.);
        unit_pressure[j] = 1.;
        heat_rhs         = 0.;
        momentum_rhs     = 0.;
        stage_operator.subtract_pressure(unit_pressure,
                                         -factorization.tau,
                                         momentum_rhs);
        discretization.join(heat_rhs, momentum_rhs, system_rhs);
        Vector &unit_response =
          factorization.unit_responses.emplace_back(system_rhs);
        factorization.solver->solve(unit_response, system_rhs);
        ++counters_.responses;

        discretization.split(unit_response, heat_rhs, momentum_rhs);
        discretization.contact_values(1, momentum_rhs, displacement);
        for (unsigned int i = 0; i < n; ++i)
          factorization.response(i, j) = factorization.tau * displacement[i];
      }
  }



  template <int dim>
  void
  StageSolver<dim>::solve_contact(Factorization    &factorization,
                                  const State      &known,
                                  const ContactMode mode,
                                  StageRates       &rates)
  {
    const double tau = factorization.tau;
    discretization.contact_values(1, known.displacement, known_displacement);
    discretization.contact_values(1, rates.velocity, free_displacement);
    bool reaches_obstacle = false;
    for (unsigned int i = 0; i < free_displacement.size(); ++i)
      {
        free_displacement[i] =
          known_displacement[i] + tau * free_displacement[i];
        reaches_obstacle |= free_displacement[i] > law.gap;
      }
    if (mode == ContactMode::unilateral && !reaches_obstacle)
      return; // no node is pushed back: zero pressures solve (M.18)

    if (factorization.unit_responses.empty())
      compute_response(factorization);
    if (mode == ContactMode::closed)
      contact_solver.solve_closed(factorization.response,
                                  free_displacement,
                                  rates.pressure);
    else
      {
        std::copy(known.contact_pressure.begin(),
                  known.contact_pressure.end(),
                  rates.pressure.begin());
        rates.n_iterations = contact_solver.solve(factorization.response,
                                                  free_displacement,
                                                  rates.pressure);
      }
    for (unsigned int j = 0; j < rates.pressure.size(); ++j)
      if (rates.pressure[j] != 0.)
        system_rates.add(-rates.pressure[j], factorization.unit_responses[j]);
    discretization.split(system_rates, rates.temperature_rate, rates.velocity);
  }



  template <int dim>
  void
  StageSolver<dim>::solve(const State      &known,
                          const double      tau,
                          const Vector     &heat_load,
                          const Vector     &momentum_load,
                          const ContactMode mode,
                          StageRates       &rates)
  {
    provide_factorization(tau);
    Factorization &factorization = factorizations.front();

    stage_operator.stage_rhs(
      known, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    discretization.join(heat_rhs, momentum_rhs, system_rhs);
    factorization.solver->solve(system_rates, system_rhs);
    ++counters_.solves;
    discretization.split(system_rates, rates.temperature_rate, rates.velocity);

    rates.failure.clear();
    rates.n_iterations = 0;
    rates.pressure.assign(discretization.contact_nodes().size(), 0.);
    if (law.is_active && mode != ContactMode::open)
      solve_contact(factorization, known, mode, rates);
  }



  template class StageSolver<1>;
  template class StageSolver<2>;
  template class StageSolver<3>;
} // namespace ThermoContact
