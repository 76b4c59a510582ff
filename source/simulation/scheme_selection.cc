// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/butcher_tableau.h>
#include <thermocontact/simulation/scheme_selection.h>
#include <thermocontact/time/dirk_integrator.h>
#include <thermocontact/time/energy_conserving_integrator.h>
#include <thermocontact/time/fixed_point_solver.h>
#include <thermocontact/time/stage_solver.h>

namespace ThermoContact
{
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



  template <int dim>
  std::unique_ptr<TimeIntegrator>
  make_time_integrator(const Discretization<dim>             &discretization,
                       const ThermoviscoelasticOperator<dim> &stage_operator,
                       const Energy<dim>                     &energy,
                       const ContactLaw                      &law,
                       const Parameters                      &parameters,
                       Loads<dim>                            &loads,
                       StepSolver                            &step_solver)
  {
    if (parameters.time.is_energy_conserving())
      return std::make_unique<EnergyConservingIntegrator<dim>>(
        discretization,
        stage_operator,
        energy,
        law,
        loads,
        dynamic_cast<StageSolver<dim> &>(step_solver));
    return std::make_unique<DirkIntegrator<dim>>(discretization,
                                                 stage_operator,
                                                 energy,
                                                 law,
                                                 butcher_tableau(
                                                   parameters.time.scheme),
                                                 loads,
                                                 step_solver);
  }



  unsigned int
  order_of(const TimeParameters &time)
  {
    return time.is_energy_conserving() ? 2 : butcher_tableau(time.scheme).order;
  }



#define INSTANTIATE(dim)                                              \
  template std::unique_ptr<StepSolver> make_step_solver<dim>(         \
    const Discretization<dim> &,                                      \
    const ThermoviscoelasticOperator<dim> &,                          \
    const ContactLaw &,                                               \
    const Parameters &);                                              \
  template std::unique_ptr<TimeIntegrator> make_time_integrator<dim>( \
    const Discretization<dim> &,                                      \
    const ThermoviscoelasticOperator<dim> &,                          \
    const Energy<dim> &,                                              \
    const ContactLaw &,                                               \
    const Parameters &,                                               \
    Loads<dim> &,                                                     \
    StepSolver &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
