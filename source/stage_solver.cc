// SPDX-License-Identifier: LGPL-2.1-or-later

#include "stage_solver.h"

#include <algorithm>

namespace ThermoContact
{
  template <int dim>
  StageSolver<dim>::StageSolver(
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &stage_operator,
    const ContactLaw                      &law)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , law(law)
    , contact_solver(law)
    , factorized_tau(0.)
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
  StageSolver<dim>::factorize(const double tau)
  {
    solver = std::make_unique<DirectSolver>(stage_operator.stage_matrix(tau));
    factorized_tau = tau;
    unit_responses.clear();
    ++counters_.factorizations;
  }



  template <int dim>
  void
  StageSolver<dim>::compute_response()
  {
    const unsigned int n = discretization.contact_nodes().size();
    response.reinit(n, n);
    std::vector<double> displacement(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        std::vector<double> unit_pressure(n, 0.);
        unit_pressure[j] = 1.;
        heat_rhs         = 0.;
        momentum_rhs     = 0.;
        stage_operator.subtract_pressure(unit_pressure,
                                         -factorized_tau,
                                         momentum_rhs);
        discretization.join(heat_rhs, momentum_rhs, system_rhs);
        unit_responses.emplace_back(system_rhs);
        solver->solve(unit_responses[j], system_rhs);
        ++counters_.responses;

        discretization.split(unit_responses[j], heat_rhs, momentum_rhs);
        discretization.contact_values(1, momentum_rhs, displacement);
        for (unsigned int i = 0; i < n; ++i)
          response(i, j) = factorized_tau * displacement[i];
      }
  }



  template <int dim>
  void
  StageSolver<dim>::solve(const State  &known,
                          const double  tau,
                          const Vector &heat_load,
                          const Vector &momentum_load,
                          StageRates   &rates)
  {
    if (tau != factorized_tau)
      factorize(tau);

    stage_operator.stage_rhs(
      known, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    discretization.join(heat_rhs, momentum_rhs, system_rhs);
    solver->solve(system_rates, system_rhs);
    ++counters_.solves;
    discretization.split(system_rates, rates.temperature_rate, rates.velocity);

    discretization.contact_values(1, known.displacement, known_displacement);
    discretization.contact_values(1, rates.velocity, free_displacement);
    bool reaches_obstacle = false;
    for (unsigned int i = 0; i < free_displacement.size(); ++i)
      {
        free_displacement[i] =
          known_displacement[i] + tau * free_displacement[i];
        reaches_obstacle |= free_displacement[i] > law.gap;
      }

    rates.failure.clear();
    rates.n_iterations = 0;
    rates.pressure.assign(free_displacement.size(), 0.);
    if (!law.is_active || !reaches_obstacle)
      return; // no node is pushed back: zero pressures solve (M.18)

    if (unit_responses.empty())
      compute_response();
    std::copy(known.contact_pressure.begin(),
              known.contact_pressure.end(),
              rates.pressure.begin());
    rates.n_iterations =
      contact_solver.solve(response, free_displacement, rates.pressure);
    for (unsigned int j = 0; j < rates.pressure.size(); ++j)
      if (rates.pressure[j] > 0.)
        system_rates.add(-rates.pressure[j], unit_responses[j]);
    discretization.split(system_rates, rates.temperature_rate, rates.velocity);
  }



  template class StageSolver<1>;
  template class StageSolver<2>;
  template class StageSolver<3>;
} // namespace ThermoContact
