// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/time/stage_factorization.h>

#include <algorithm>

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
    , refused_growth(0.)
  {
    if (!stage_operator.is_eliminated_along_rod() ||
        !factorize_rod(*stage_operator.rod(), stage_operator.coefficients()))
      factorize_sparse();
  }



  template <int dim>
  bool
  StageFactorization<dim>::factorize_rod(const RodMatrices &matrices,
                                         const Material    &material)
  {
    using Block = RodFactors<1>::Block;
    const Block heat_block{{1., RodMatrices::heat_mass},
                           {tau_, RodMatrices::conduction}};
    const Block momentum_block{{material.inertia, RodMatrices::momentum_mass},
                               {tau_ * material.viscosity,
                                RodMatrices::viscous_stiffness},
                               {tau_ * tau_, RodMatrices::stiffness}};
    double      growth = 0.;
    if (stage_operator.is_coupled())
      {
        const Block heating{{material.heating, RodMatrices::divergence}};
        const Block stress{{-tau_ * tau_ * material.thermal_stress,
                            RodMatrices::thermal_stress}};
        rod_whole = std::make_unique<const RodFactors<2>>(
          matrices,
          RodFactors<2>::Blocks{
            {{{heat_block, heating}}, {{stress, momentum_block}}}});
        growth = rod_whole->growth();
      }
    else
      {
        if (discretization.has_field(Field::temperature))
          rod_heat = std::make_unique<const RodFactors<1>>(
            matrices, RodFactors<1>::Blocks{{{{heat_block}}}});
        if (discretization.has_field(Field::displacement))
          rod_momentum = std::make_unique<const RodFactors<1>>(
            matrices, RodFactors<1>::Blocks{{{{momentum_block}}}});
        growth = std::max(rod_heat ? rod_heat->growth() : 0.,
                          rod_momentum ? rod_momentum->growth() : 0.);
      }
    if (growth <= Tolerances::tolerated_cancellation)
      return true;
    refused_growth = growth;
    rod_whole.reset();
    rod_heat.reset();
    rod_momentum.reset();
    return false;
  }



  template <int dim>
  std::string
  StageFactorization<dim>::warning() const
  {
    if (refused_growth == 0.)
      return "";
    return text("Solver/Linear solver = automatic: the blocks of the stage "
                "matrix grow by ",
                significant(refused_growth, 2),
                " in a stage of length ",
                significant(tau_, 3),
                ", more digits than a result may lose: sparse factors (direct) "
                "where they do");
  }



  template <int dim>
  void
  StageFactorization<dim>::factorize_sparse()
  {
    if (stage_operator.is_coupled())
      {
        whole =
          std::make_unique<DirectSolver>(stage_operator.stage_matrix(tau_));
        system_rhs   = discretization.make_system_vector();
        system_rates = system_rhs;
        return;
      }
    if (discretization.has_field(Field::temperature))
      heat =
        std::make_unique<DirectSolver>(stage_operator.heat_stage_matrix(tau_));
    if (discretization.has_field(Field::displacement))
      momentum = std::make_unique<DirectSolver>(
        stage_operator.momentum_stage_matrix(tau_));
  }



  template <int dim>
  void
  StageFactorization<dim>::solve(Vector &heat_rhs,
                                 Vector &momentum_rhs,
                                 Vector &temperature_rate,
                                 Vector &velocity)
  {
    if (dim > 1 || !(whole || heat || momentum))
      {
        solve_once(heat_rhs, momentum_rhs, temperature_rate, velocity);
        return;
      }
    heat_residual       = heat_rhs;
    momentum_residual   = momentum_rhs;
    heat_correction     = heat_rhs;
    momentum_correction = momentum_rhs;
    solve_once(heat_rhs, momentum_rhs, temperature_rate, velocity);
    stage_operator.subtract_stage_product(
      tau_, temperature_rate, velocity, heat_residual, momentum_residual);
    solve_once(heat_residual,
               momentum_residual,
               heat_correction,
               momentum_correction);
    if (discretization.has_field(Field::temperature))
      temperature_rate += heat_correction;
    if (discretization.has_field(Field::displacement))
      velocity += momentum_correction;
  }



  template <int dim>
  void
  StageFactorization<dim>::solve_once(Vector &heat_rhs,
                                      Vector &momentum_rhs,
                                      Vector &temperature_rate,
                                      Vector &velocity)
  {
    if (rod_whole)
      {
        rod_whole->solve({{heat_rhs.begin(), momentum_rhs.begin()}},
                         {{temperature_rate.begin(), velocity.begin()}});
        return;
      }
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
        // prescribed rates are zero: pivots off the diagonal leave rounding of
        // the largest rates there, which adds up where nothing restores them
        stage_operator.zero_constrained(Field::temperature, temperature_rate);
        stage_operator.zero_constrained(Field::displacement, velocity);
        return;
      }
    if (rod_heat)
      rod_heat->solve({{heat_rhs.begin()}}, {{temperature_rate.begin()}});
    if (heat)
      heat->solve(temperature_rate, heat_rhs);
    if ((heat || rod_heat) && (momentum || rod_momentum))
      stage_operator.add_thermal_stress(temperature_rate,
                                        tau_ * tau_,
                                        momentum_rhs);
    if (rod_momentum)
      rod_momentum->solve({{momentum_rhs.begin()}}, {{velocity.begin()}});
    if (momentum)
      momentum->solve(velocity, momentum_rhs);
  }



  template class StageFactorization<1>;
  template class StageFactorization<2>;
  template class StageFactorization<3>;
} // namespace ThermoContact
