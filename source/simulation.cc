// SPDX-License-Identifier: LGPL-2.1-or-later

#include "simulation.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "exceptions.h"
#include "fixed_point_solver.h"
#include "h1_projection.h"
#include "stage_solver.h"

namespace ThermoContact
{
  namespace
  {
    ContactLaw
    make_contact_law(const ContactParameters &contact)
    {
      ContactLaw law;
      law.is_active = !contact.is_none();
      law.compliance =
        contact.is_none() || contact.is_rigid() ? 0. : contact.compliance;
      law.gap = contact.gap;
      return law;
    }



    template <int dim>
    std::unique_ptr<StepSolver>
    make_step_solver(const Discretization<dim>             &discretization,
                     const ThermoviscoelasticOperator<dim> &stage_operator,
                     const ContactLaw                      &law,
                     const Parameters                      &parameters)
    {
      if (parameters.solver.is_fixed_point())
        return std::make_unique<FixedPointSolver<dim>>(discretization,
                                                       stage_operator,
                                                       law,
                                                       parameters);
      return std::make_unique<StageSolver<dim>>(discretization,
                                                stage_operator,
                                                law);
    }
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const Parameters &parameters,
                              const MPI_Comm    communicator)
    : parameters_(parameters)
    , law(make_contact_law(parameters.contact))
    , data(parameters)
    , discretization_(parameters, communicator)
    , operator_(discretization_, parameters)
    , loads(discretization_, parameters, data)
    , energy_(discretization_, operator_, loads, law, parameters)
    , measurements(discretization_, operator_, law, parameters)
    , step_solver(make_step_solver(discretization_, operator_, law, parameters))
    , integrator(discretization_,
                 operator_,
                 energy_,
                 law,
                 butcher_tableau(parameters.time.scheme),
                 loads,
                 *step_solver)
    , controller(parameters)
    , max_energy_increase_(0.)
    , max_penetration_(0.)
    , max_contact_force_(0.)
  {
    set_initial_state();
  }



  template <int dim>
  void
  Simulation<dim>::set_initial_state()
  {
    state_ = discretization_.make_state();
    {
      H1Projection<dim> projection(discretization_);
      projection.project(data.initial_fields(),
                         state_.temperature,
                         state_.displacement);
      Vector unused(state_.temperature);
      projection.project(data.initial_velocity(), unused, state_.velocity);
    }
    check_initial_values();
    check_initial_contact();
    for (const unsigned int entry : discretization_.constrained_entries(0))
      state_.temperature.begin()[entry] =
        parameters_.boundary.fixed_end_temperature;

    std::vector<double> end_displacement;
    discretization_.contact_values(1, state_.displacement, end_displacement);
    if (law.compliance > 0.)
      for (unsigned int i = 0; i < end_displacement.size(); ++i)
        state_.contact_pressure[i] = law.pressure(end_displacement[i], 0.);

    data.set_time(0.);
    measurements.measure(state_, data, record_);
    record_.energy_terms = energy_.energy(state_);
    record_.energy       = record_.energy_terms.sum();
    if (!std::isfinite(record_.energy))
      throw InputError("Initial values: the energy of the initial state is " +
                       std::to_string(record_.energy) +
                       "\n  allowed: expressions that are finite, with their "
                       "gradients, in the whole body");
    events_.start(record_);
    max_penetration_   = record_.penetration;
    max_contact_force_ = record_.contact_force;
  }



  template <int dim>
  void
  Simulation<dim>::check_initial_values()
  {
    const MPI_Comm communicator = discretization_.communicator();
    const auto     largest      = [&](const Vector &field) {
      return field.linfty_norm();
    };
    const auto largest_constrained =
      [&](const unsigned int block, const Vector &field, const double value) {
        double result = 0.;
        for (const unsigned int e : discretization_.constrained_entries(block))
          result = std::max(result, std::abs(field.begin()[e] - value));
        return Utilities::MPI::max(result, communicator);
      };
    const double rounding = 1e-12;

    for (const auto &[name, expression, field] :
         {std::make_tuple("Displacement",
                          parameters_.initial_values.displacement,
                          &state_.displacement),
          std::make_tuple("Velocity",
                          parameters_.initial_values.velocity,
                          &state_.velocity)})
      if (largest_constrained(1, *field, 0.) > rounding * largest(*field))
        throw InputError(
          std::string("Initial values/") + name + " = " + expression +
          ": not zero at the fixed end x = 0 or normal to rollers\n  allowed: "
          "an expression that vanishes there, e.g. 20*x*(x-1)^2");

    const double theta_A  = parameters_.boundary.fixed_end_temperature;
    const double mismatch = largest_constrained(0, state_.temperature, theta_A);
    std::ostringstream message;
    if (mismatch >
        rounding * std::max(std::abs(theta_A), largest(state_.temperature)))
      {
        message << "Initial values/Temperature differs by " << mismatch
                << " from theta_A = " << theta_A
                << " at the fixed end: a corner layer starts there";
        warnings_.push_back(message.str());
      }
  }



  template <int dim>
  void
  Simulation<dim>::check_initial_contact()
  {
    if (!law.is_active)
      return;
    std::vector<double> displacement, velocity;
    discretization_.contact_values(1, state_.displacement, displacement);
    discretization_.contact_values(1, state_.velocity, velocity);
    const double reach =
      *std::max_element(displacement.begin(), displacement.end());

    std::ostringstream message;
    message << "Contact/Gap = " << law.gap << ": ";
    if (reach > law.gap && law.compliance > 0.)
      {
        message << "the body penetrates the obstacle at the start, end "
                << "displacement " << reach << ", initial pressure "
                << law.pressure(reach, 0.);
        warnings_.push_back(message.str());
      }
    if (law.compliance > 0.)
      return;

    if (reach > law.gap)
      {
        message << "the initial displacement " << reach
                << " of the end penetrates the rigid obstacle\n  remedy:  a "
                   "larger gap, another Initial values/Displacement, or "
                   "Contact/Condition = normal compliance";
        throw InputError(message.str());
      }
    if (parameters_.time.has_prescribed_start() && !controller.is_finished(0))
      for (unsigned int i = 0; i < velocity.size(); ++i)
        if (displacement[i] + controller.propose(0).size * velocity[i] >
            law.gap)
          {
            message << "the prescribed first step of the paper would "
                       "penetrate the rigid obstacle\n  remedy:  Time/Start = "
                       "consistent, or a smaller Time/Step size";
            throw InputError(message.str());
          }
  }



  template <int dim>
  void
  Simulation<dim>::add_observer(const Observer &observer)
  {
    observers.push_back(observer);
  }



  template <int dim>
  void
  Simulation<dim>::notify() const
  {
    for (const Observer &observer : observers)
      observer(*this);
  }



  template <int dim>
  void
  Simulation<dim>::run()
  {
    notify();
    StepResult result;
    while (!controller.is_finished(record_.step))
      {
        const TimeStep time_step = controller.propose(record_.step);
        compute_step(time_step, result);
        accept(time_step, result);
        notify();
      }
  }



  template <int dim>
  void
  Simulation<dim>::compute_step(const TimeStep &time_step, StepResult &result)
  {
    try
      {
        if (record_.step == 0 && parameters_.time.has_prescribed_start())
          integrator.prescribed_step(state_, time_step, result);
        else
          integrator.step(state_, time_step, result);
      }
    catch (const ComputationError &error)
      {
        result.failure = error.what();
      }
    if (result.failure.empty() && !std::isfinite(result.energy.sum()))
      result.failure = "the solution is not finite\n  remedy:  smaller initial "
                       "values and sources, or a smaller Time/Step size";
    if (result.failure.empty())
      return;

    std::ostringstream place;
    place << "step " << time_step.number << ", from t = " << state_.time
          << " to " << time_step.end << ": ";
    throw ComputationError(place.str() + result.failure);
  }



  template <int dim>
  void
  Simulation<dim>::accept(const TimeStep &time_step, StepResult &result)
  {
    const StepRecord old_record = record_;
    state_.swap(result.state);
    measurements.measure(state_, data, record_);
    record_.step         = time_step.number;
    record_.step_size    = time_step.size;
    record_.iterations   = result.n_iterations;
    record_.energy_terms = result.energy;
    record_.energy       = result.energy.sum();
    record_.work += result.work;
    record_.dissipation += result.dissipation;
    record_.numerical_dissipation += result.numerical_dissipation;
    record_.contact_impulse += result.impulse;

    events_.observe(old_record, record_);
    max_penetration_   = std::max(max_penetration_, record_.penetration);
    max_contact_force_ = std::max(max_contact_force_, record_.contact_force);
    if (!result.is_prescribed)
      max_energy_increase_ =
        std::max(max_energy_increase_,
                 record_.energy - old_record.energy - result.work);
  }



  template <int dim>
  SolverCounters
  Simulation<dim>::counters() const
  {
    SolverCounters sum = step_solver->counters();
    sum.factorizations += integrator.counters().factorizations;
    sum.solves += integrator.counters().solves;
    return sum;
  }



  template class Simulation<1>;
  template class Simulation<2>;
  template class Simulation<3>;
} // namespace ThermoContact
