// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/box_integrator.h>
#include <thermocontact/time/dirk_integrator.h>
#include <thermocontact/time/energy_conserving_integrator.h>
#include <thermocontact/time/time_integrator.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace ThermoContact
{
  void
  StepResult::agree(const MPI_Comm communicator)
  {
    using namespace Utilities::MPI;
    if (n_mpi_processes(communicator) == 1)
      return;
    if (max(failure.empty() ? 0 : 1, communicator) == 1 && failure.empty())
      failure = "another rank has failed";
    std::vector<double> values;
    for_each_number(
      [&](double S::*const number) { values.push_back(this->*number); });
    values      = broadcast(communicator, values);
    auto agreed = values.begin();
    for_each_number(
      [&](double S::*const number) { this->*number = *agreed++; });
  }



  template <int dim>
  std::unique_ptr<TimeIntegrator>
  make_integrator(Body<dim> &body)
  {
    switch (body.scene.scheme.integrator)
      {
        case IntegratorKind::energy_conserving:
          return std::make_unique<EnergyConservingIntegrator<dim>>(body);
        case IntegratorKind::box:
          if constexpr (dim == 1)
            return std::make_unique<BoxIntegrator>(body);
          AssertThrow(false, ExcInternalError()); // is refused
          return nullptr;
        default:
          return std::make_unique<DirkIntegrator<dim>>(body);
      }
  }



  template std::unique_ptr<TimeIntegrator>
  make_integrator(Body<1> &);
  template std::unique_ptr<TimeIntegrator>
  make_integrator(Body<2> &);
  template std::unique_ptr<TimeIntegrator>
  make_integrator(Body<3> &);
} // namespace ThermoContact
