// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/stop_watch.h>
#include <thermocontact/time/stage_solver.h>

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
    , contact_solver({law.is_active, law.compliance, 0.})
    , max_factorizations(cache_size(discretization.dof_handler().n_dofs()))
    , heat_rhs(discretization.make_vector(0))
    , momentum_rhs(discretization.make_vector(1))
  {}



  template <int dim>
  types::global_dof_index
  StageSolver<dim>::n_factorized_unknowns() const
  {
    return StageFactorization<dim>::is_coupled(stage_operator) ?
             discretization.dof_handler().n_dofs() :
             std::max(discretization.n_temperature_dofs(),
                      discretization.n_displacement_dofs());
  }



  template <int dim>
  void
  StageSolver<dim>::provide_factorization(const double tau)
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
      {StageFactorization<dim>(discretization, stage_operator, tau),
       {},
       FullMatrix<double>()});
    counters_.factorizations +=
      factorizations.front().matrix.n_factorizations();
  }



  template <int dim>
  void
  StageSolver<dim>::compute_response(Factorization &factorization)
  {
    const unsigned int  n   = discretization.contact_nodes().size();
    const double        tau = factorization.matrix.tau();
    std::vector<double> displacement(n);
    factorization.response.reinit(n, n);
    for (unsigned int j = 0; j < n; ++j)
      {
        std::vector<double> unit_pressure(n, 0.);
        unit_pressure[j] = 1.;
        heat_rhs         = 0.;
        momentum_rhs     = 0.;
        stage_operator.subtract_pressure(unit_pressure, -tau, momentum_rhs);
        factorization.unit_responses.push_back({heat_rhs, momentum_rhs});
        UnitResponse &unit_response = factorization.unit_responses.back();
        factorization.matrix.solve(heat_rhs,
                                   momentum_rhs,
                                   unit_response.temperature_rate,
                                   unit_response.velocity);
        ++counters_.responses;

        discretization.contact_values(1, unit_response.velocity, displacement);
        for (unsigned int i = 0; i < n; ++i)
          factorization.response(i, j) = tau * displacement[i];
      }
  }



  template <int dim>
  SolverMemory
  StageSolver<dim>::memory() const
  {
    SolverMemory memory;
    memory.counters = counters_;
    for (const Factorization &factorization : factorizations)
      {
        memory.taus.push_back(factorization.matrix.tau());
        memory.has_response.push_back(!factorization.unit_responses.empty());
      }
    return memory;
  }



  template <int dim>
  void
  StageSolver<dim>::restore(const SolverMemory &memory)
  {
    factorizations.clear();
    for (unsigned int i = memory.taus.size(); i-- > 0;)
      {
        provide_factorization(memory.taus[i]);
        if (memory.has_response[i])
          compute_response(factorizations.front());
      }
    counters_ = memory.counters;
  }



  template <int dim>
  const FullMatrix<double> &
  StageSolver<dim>::response()
  {
    Factorization &factorization = factorizations.front();
    if (factorization.unit_responses.empty())
      compute_response(factorization);
    return factorization.response;
  }



  template <int dim>
  void
  StageSolver<dim>::apply_pressure(StageRates &rates) const
  {
    const Factorization &factorization = factorizations.front();
    for (unsigned int j = 0; j < rates.pressure.size(); ++j)
      if (const double p = rates.pressure[j]; p != 0.)
        {
          const UnitResponse &unit_response = factorization.unit_responses[j];
          rates.velocity.add(-p, unit_response.velocity);
          if (StageFactorization<dim>::is_coupled(stage_operator))
            rates.temperature_rate.add(-p, unit_response.temperature_rate);
        }
  }



  template <int dim>
  void
  StageSolver<dim>::solve_contact(const State      &known,
                                  const ContactMode mode,
                                  StageRates       &rates)
  {
    const StopWatch watch(counters_.contact_seconds);
    const double    tau = factorizations.front().matrix.tau();
    discretization.contact_values(1, known.displacement, known_displacement);
    discretization.contact_values(1, rates.velocity, free_displacement);
    bool reaches_obstacle = false;
    for (unsigned int i = 0; i < free_displacement.size(); ++i)
      {
        // from the obstacle on: in contact the first term is small or zero,
        // and the sum keeps the digits of the second in short stages
        free_displacement[i] =
          (known_displacement[i] - law.gap) + tau * free_displacement[i];
        reaches_obstacle |= free_displacement[i] > 0.;
      }
    if (mode == ContactMode::unilateral && !reaches_obstacle)
      return; // no node is pushed back: zero pressures solve (M.18)

    if (mode == ContactMode::closed)
      contact_solver.solve_closed(response(),
                                  free_displacement,
                                  rates.pressure);
    else
      {
        std::copy(known.contact_pressure.begin(),
                  known.contact_pressure.end(),
                  rates.pressure.begin());
        rates.n_iterations =
          contact_solver.solve(response(), free_displacement, rates.pressure);
      }
    apply_pressure(rates);
  }



  template <int dim>
  void
  StageSolver<dim>::solve_without_contact(const State  &known,
                                          const double  tau,
                                          const Vector &heat_load,
                                          const Vector &momentum_load,
                                          StageRates   &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    provide_factorization(tau);
    stage_operator.stage_rhs(
      known, tau, heat_load, momentum_load, heat_rhs, momentum_rhs);
    factorizations.front().matrix.solve(heat_rhs,
                                        momentum_rhs,
                                        rates.temperature_rate,
                                        rates.velocity);
    ++counters_.solves;

    rates.failure.clear();
    rates.n_iterations = 0;
    rates.pressure.assign(discretization.contact_nodes().size(), 0.);
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
    solve_without_contact(known, tau, heat_load, momentum_load, rates);
    if (law.is_active && mode != ContactMode::open)
      solve_contact(known, mode, rates);
  }



  template class StageSolver<1>;
  template class StageSolver<2>;
  template class StageSolver<3>;
} // namespace ThermoContact
