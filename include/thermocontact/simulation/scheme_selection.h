// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_scheme_selection_h
#define thermocontact_simulation_scheme_selection_h

#include <thermocontact/input/parameters.h>
#include <thermocontact/method/contact_law.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/energy.h>
#include <thermocontact/space/loads.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>
#include <thermocontact/time/step_solver.h>
#include <thermocontact/time/time_integrator.h>

#include <memory>

namespace ThermoContact
{
  /** The solver of stages that the parameters ask for. References as there. */
  template <int dim>
  std::unique_ptr<StepSolver>
  make_step_solver(const Discretization<dim>             &discretization,
                   const ThermoviscoelasticOperator<dim> &stage_operator,
                   const ContactLaw                      &law,
                   const Parameters                      &parameters);

  /**
   * The time integrator that the parameters ask for.
   *
   * @param step_solver of the same parameters
   */
  template <int dim>
  std::unique_ptr<TimeIntegrator>
  make_time_integrator(const Discretization<dim>             &discretization,
                       const ThermoviscoelasticOperator<dim> &stage_operator,
                       const Energy<dim>                     &energy,
                       const ContactLaw                      &law,
                       const Parameters                      &parameters,
                       Loads<dim>                            &loads,
                       StepSolver                            &step_solver);

  /** Order of the scheme of that name. */
  unsigned int
  order_of(const TimeParameters &time);
} // namespace ThermoContact

#endif
