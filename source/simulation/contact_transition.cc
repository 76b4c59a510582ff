// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/contact_transition.h>

#include <algorithm>

namespace ThermoContact
{
  template <int dim>
  ContactTransition<dim>::ContactTransition(
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &stage_operator,
    const Energy<dim>                     &energy,
    const ContactLaw                      &law,
    const bool                             has_contact_mass)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , energy(energy)
    , law(law)
    , has_contact_mass(has_contact_mass)
  {}



  template <int dim>
  void
  ContactTransition<dim>::compute_impulse_responses()
  {
    mass_solver =
      std::make_unique<DirectSolver>(stage_operator.momentum_stage_matrix(0.));
    ++counters_.factorizations;

    const unsigned int n = discretization.contact_nodes().size();
    inverse_receptance.reinit(n, n);
    std::vector<double> velocity(n);
    Vector              load = discretization.make_vector(1);
    for (unsigned int j = 0; j < n; ++j)
      {
        std::vector<double> unit_impulse(n, 0.);
        unit_impulse[j] = 1.;
        load            = 0.;
        stage_operator.subtract_pressure(unit_impulse, -1., load);
        mass_solver->solve(impulse_responses.emplace_back(load), load);
        ++counters_.responses;
        discretization.contact_values(1, impulse_responses[j], velocity);
        for (unsigned int i = 0; i < n; ++i)
          inverse_receptance(i, j) = velocity[i];
      }
    inverse_receptance.gauss_jordan();
  }



  template <int dim>
  void
  ContactTransition<dim>::restore(const SolverCounters &counters)
  {
    if (counters.factorizations > 0 && !mass_solver)
      compute_impulse_responses();
    counters_ = counters;
  }



  template <int dim>
  double
  ContactTransition<dim>::stop_contact_nodes(Vector &velocity)
  {
    if (!mass_solver)
      compute_impulse_responses();
    std::vector<double> contact_velocity;
    discretization.contact_values(1, velocity, contact_velocity);
    std::vector<double> impulses(contact_velocity.size(), 0.);
    for (unsigned int i = 0; i < impulses.size(); ++i)
      for (unsigned int j = 0; j < impulses.size(); ++j)
        impulses[i] += inverse_receptance(i, j) * contact_velocity[j];
    for (unsigned int i = 0; i < impulses.size(); ++i)
      velocity.add(-impulses[i], impulse_responses[i]);
    return discretization.contact_mean(impulses);
  }



  template <int dim>
  void
  ContactTransition<dim>::impact(State       &state,
                                 EnergyTerms &energy_terms,
                                 double      &impulse,
                                 double      &numerical_dissipation)
  {
    if (has_contact_mass)
      impulse += stop_contact_nodes(state.velocity);
    for (const auto &[node, entry] : discretization.contact_entries(1))
      state.displacement.begin()[entry] = law.gap;
    const double old_energy = energy_terms.sum();
    energy_terms            = energy.energy(state);
    numerical_dissipation += old_energy - energy_terms.sum();
  }



  template <int dim>
  void
  ContactTransition<dim>::finish_pressure(const bool  begins_contact,
                                          StepResult &result)
  {
    std::vector<double> &pressure = result.state.contact_pressure;
    bool                 changed  = false;
    for (double &p : pressure)
      {
        changed |= p < 0.;
        p = std::max(p, 0.);
      }
    if (begins_contact && law.compliance > 0.)
      {
        changed = true;
        discretization.contact_values(1, result.state.displacement, pressure);
        for (double &p : pressure) // displacements so far
          p = law.pressure(p, 0.);
      }
    if (!changed)
      return;
    const double old_energy = result.energy.sum();
    result.energy           = energy.energy(result.state);
    result.numerical_dissipation += old_energy - result.energy.sum();
  }



  template class ContactTransition<1>;
  template class ContactTransition<2>;
  template class ContactTransition<3>;
} // namespace ThermoContact
