// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/simulation/initial_state.h>
#include <thermocontact/simulation/quasi_static_start.h>
#include <thermocontact/space/h1_projection.h>
#include <thermocontact/time/contact_equilibrium.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /** The fixed end must be fixed; warns of a corner layer. */
    template <int dim>
    void
    check_values(const Parameters          &parameters,
                 const Discretization<dim> &discretization,
                 const State               &state,
                 std::vector<std::string>  &warnings)
    {
      const MPI_Comm communicator = discretization.communicator();
      const auto     largest      = [&](const Vector &field) {
        return field.linfty_norm();
      };
      const auto largest_constrained =
        [&](const unsigned int block, const Vector &field, const double value) {
          double result = 0.;
          for (const unsigned int e : discretization.constrained_entries(block))
            result = std::max(result, std::abs(field.begin()[e] - value));
          return Utilities::MPI::max(result, communicator);
        };
      const double rounding = 1e-12;

      for (const auto &[name, expression, field] :
           {std::make_tuple("Displacement",
                            parameters.initial_values.displacement,
                            &state.displacement),
            std::make_tuple("Velocity",
                            parameters.initial_values.velocity,
                            &state.velocity)})
        if (largest_constrained(1, *field, 0.) > rounding * largest(*field))
          throw InputError(
            std::string("Initial values/") + name + " = " + expression +
            ": not zero at the fixed end x = 0 or normal to rollers\n  allowed: "
            "an expression that vanishes there, e.g. 20*x*(x-1)^2");

      if (!discretization.has_field(0))
        return;
      const double theta_A = parameters.boundary.fixed_end_temperature;
      const double mismatch =
        largest_constrained(0, state.temperature, theta_A);
      std::ostringstream message;
      if (mismatch >
          rounding * std::max(std::abs(theta_A), largest(state.temperature)))
        {
          message << "Initial values/Temperature differs by " << mismatch
                  << " from theta_A = " << theta_A
                  << " at the fixed end: a corner layer starts there";
          warnings.push_back(message.str());
        }
    }



    /** A rigid obstacle must not be penetrated. */
    template <int dim>
    void
    check_penetration(const Parameters          &parameters,
                      const Discretization<dim> &discretization,
                      const ContactLaw          &law,
                      const double               first_step_size,
                      const State               &state)
    {
      if (!law.is_active || law.compliance > 0. || parameters.model.is_static())
        return; // what is static is in equilibrium with the obstacle
      std::vector<double> displacement, velocity;
      discretization.contact_values(1, state.displacement, displacement);
      discretization.contact_values(1, state.velocity, velocity);
      const double reach =
        *std::max_element(displacement.begin(), displacement.end());

      std::ostringstream message;
      message << "Contact/Gap = " << law.gap << ": ";
      if (reach > law.gap)
        {
          message << "the initial displacement " << reach
                  << " of the end penetrates the rigid obstacle\n  remedy:  a "
                     "larger gap, another Initial values/Displacement, or "
                     "Contact/Condition = normal compliance";
          throw InputError(message.str());
        }
      if (parameters.has_prescribed_start() && parameters.time.end_time > 0.)
        for (unsigned int i = 0; i < velocity.size(); ++i)
          if (displacement[i] + first_step_size * velocity[i] > law.gap)
            {
              message
                << "the prescribed first step of the paper would "
                   "penetrate the rigid obstacle\n  remedy:  Time/Start = "
                   "consistent, or a smaller Time/Step size";
              throw InputError(message.str());
            }
    }



    /** Warns of a body that is in contact at the start, and of a preload. */
    template <int dim>
    void
    warn_of_contact(const Discretization<dim> &discretization,
                    const ContactLaw          &law,
                    const State               &state,
                    std::vector<std::string>  &warnings)
    {
      const double pressure = *std::max_element(state.contact_pressure.begin(),
                                                state.contact_pressure.end());
      if (!law.is_active || (law.gap >= 0. && pressure == 0.))
        return;
      std::vector<double> displacement;
      discretization.contact_values(1, state.displacement, displacement);
      std::ostringstream message;
      message << "Contact/Gap = " << law.gap << ": "
              << (law.gap < 0. ?
                    "negative, the undeformed body overlaps the obstacle "
                    "(preload)" :
                    "the body is in contact at the start")
              << ", end displacement "
              << *std::max_element(displacement.begin(), displacement.end())
              << ", initial pressure " << pressure;
      warnings.push_back(message.str());
    }
  } // namespace



  template <int dim>
  State
  initial_state(const Parameters                      &parameters,
                const ProblemData<dim>                &data,
                const Discretization<dim>             &discretization,
                const ThermoviscoelasticOperator<dim> &stage_operator,
                const ContactLaw                      &law,
                const double                           first_step_size,
                Loads<dim>                            &loads,
                std::vector<std::string>              &warnings)
  {
    State state = discretization.make_state();
    {
      H1Projection<dim> projection(discretization);
      projection.project(data.initial_fields(),
                         state.temperature,
                         state.displacement);
      Vector unused(state.temperature);
      projection.project(data.initial_velocity(), unused, state.velocity);
    }
    check_values(parameters, discretization, state, warnings);
    check_penetration(parameters, discretization, law, first_step_size, state);
    for (const unsigned int entry : discretization.constrained_entries(0))
      state.temperature.begin()[entry] =
        parameters.boundary.fixed_end_temperature;

    std::vector<double> end_displacement;
    discretization.contact_values(1, state.displacement, end_displacement);
    if (law.compliance > 0.)
      for (unsigned int i = 0; i < end_displacement.size(); ++i)
        state.contact_pressure[i] = law.pressure(end_displacement[i], 0.);
    if (parameters.model.has_displacement() && parameters.model.inertia == 0.)
      complete_quasi_static_state(
        parameters.model, discretization, stage_operator, law, loads, state);
    else if (parameters.has_contact_equilibrium())
      settle_contact_nodes(discretization, stage_operator, law, loads, state);
    warn_of_contact(discretization, law, state, warnings);
    return state;
  }



#define INSTANTIATE(dim)                                                \
  template State initial_state(const Parameters &,                      \
                               const ProblemData<dim> &,                \
                               const Discretization<dim> &,             \
                               const ThermoviscoelasticOperator<dim> &, \
                               const ContactLaw &,                      \
                               const double,                            \
                               Loads<dim> &,                            \
                               std::vector<std::string> &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
