// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/stage_factorization.h>

namespace ThermoContact
{
  template <int dim>
  StageFactorization<dim>::StageFactorization(
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &stage_operator,
    const double                           tau)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , tau_(tau)
  {
    if (stage_operator.is_coupled())
      {
        whole =
          std::make_unique<DirectSolver>(stage_operator.stage_matrix(tau));
        system_rhs   = discretization.make_system_vector();
        system_rates = system_rhs;
        return;
      }
    if (discretization.has_field(Field::temperature))
      heat =
        std::make_unique<DirectSolver>(stage_operator.heat_stage_matrix(tau));
    if (discretization.has_field(Field::displacement))
      momentum = std::make_unique<DirectSolver>(
        stage_operator.momentum_stage_matrix(tau));
  }



  template <int dim>
  void
  StageFactorization<dim>::solve(Vector &heat_rhs,
                                 Vector &momentum_rhs,
                                 Vector &temperature_rate,
                                 Vector &velocity)
  {
    if (whole)
      {
        // The unknowns of the whole matrix are tau theta' and v: pivots that
        // mix rows would otherwise lose v beside the large theta' of short
        // steps.
        heat_rhs *= tau_;
        discretization.join(heat_rhs, momentum_rhs, system_rhs);
        whole->solve(system_rates, system_rhs);
        discretization.split(system_rates, temperature_rate, velocity);
        temperature_rate /= tau_;
        return;
      }
    if (heat)
      heat->solve(temperature_rate, heat_rhs);
    if (heat && momentum)
      stage_operator.add_thermal_stress(temperature_rate,
                                        tau_ * tau_,
                                        momentum_rhs);
    if (momentum)
      momentum->solve(velocity, momentum_rhs);
  }



  template class StageFactorization<1>;
  template class StageFactorization<2>;
  template class StageFactorization<3>;
} // namespace ThermoContact
