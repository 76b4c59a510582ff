// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/time/newton_stage.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    constexpr unsigned int max_iterations = 25;
  } // namespace



  template <int dim>
  NewtonStage<dim>::NewtonStage(const Body<dim> &body)
    : body(body)
    , linear(body)
    , end(body.make_state())
    , heat(body.discretization.make_vector(Field::temperature))
    , momentum(body.discretization.make_vector(Field::displacement))
    , heat_product(heat)
    , momentum_product(momentum)
    , last_rate(heat)
    , last_velocity(momentum)
  {}



  template <int dim>
  void
  NewtonStage<dim>::set_end(const unsigned int     i,
                            const double           tau,
                            const DrivenStep<dim> &driven,
                            const State           &known,
                            const StageRates      &stage)
  {
    end.advance(known, tau, stage);
    // the known values of a driven end are those at the end of the stage
    full = stage;
    driven.complete(i, full);
  }



  template <int dim>
  void
  NewtonStage<dim>::linearize(const double tau, const StageRates &stage)
  {
    auto       tangents = body.nonlinear->linearize(end, full, heat, momentum);
    const auto add_product = [&](const double                           sign,
                                 const ThermoviscoelasticOperator<dim> &by) {
      by.product(stage_coefficients(tau),
                 stage.temperature_rate,
                 stage.velocity,
                 heat_product,
                 momentum_product);
      heat.add(sign, heat_product);
      if (body.scene.fields.has_displacement)
        momentum.add(sign / tau, momentum_product);
    };
    add_product(1., *tangents);
    add_product(-1., body.equations);
    linear.factorize(tau, std::move(tangents));
  }



  template <int dim>
  double
  NewtonStage<dim>::change(const double      tau,
                           const State      &known,
                           const StageRates &stage) const
  {
    struct Part
    {
      double change = 0., size = 0.;
    };
    const auto part = [&](const Vector &values,
                          const Vector &rate,
                          const Vector &last) {
      Part result;
      for (unsigned int i = 0; i < rate.locally_owned_size(); ++i)
        {
          const double moved = tau * rate.local_element(i);
          result.change =
            std::max(result.change,
                     std::abs(moved - tau * last.local_element(i)));
          result.size = std::max(
            {result.size, std::abs(values.local_element(i)), std::abs(moved)});
        }
      // all ranks go on alike
      const MPI_Comm communicator = body.discretization.communicator();
      result.change = Utilities::MPI::max(result.change, communicator);
      result.size   = Utilities::MPI::max(result.size, communicator);
      return result;
    };
    const Part heat =
      part(known.temperature, stage.temperature_rate, last_rate);
    const Part motion = part(known.displacement, stage.velocity, last_velocity);
    // a change that the other field could make alone may be its rounding
    const Material &material = body.scene.material;
    const double    length   = body.scene.row.length();
    const auto      over     = [](const Part &one, const double of_other) {
      return one.change > 0. ? one.change / std::max(one.size, of_other) : 0.;
    };
    return std::max(
      over(heat, std::abs(material.heating) * motion.size / length),
      over(motion, std::abs(material.thermal_stress) * heat.size * length));
  }



  template <int dim>
  void
  NewtonStage<dim>::solve(const unsigned int i,
                          const double       tau,
                          const ContactMode  mode,
                          DrivenStep<dim>   &driven,
                          State             &known,
                          Vector            &heat_load,
                          Vector            &momentum_load,
                          StageRates        &stage)
  {
    driven.constrain(i, {heat_load, momentum_load}, known);
    set_zero(stage.temperature_rate);
    set_equal(stage.velocity, known.velocity);
    if (body.scene.fields.has_displacement)
      body.equations.zero_constrained(Field::displacement, stage.velocity);
    double last_change = 1.;
    try
      {
        for (unsigned int n = 0; n < max_iterations; ++n)
          {
            set_end(i, tau, driven, known, stage);
            set_equal(heat, heat_load);
            set_equal(momentum, momentum_load);
            linearize(tau, stage);
            set_equal(last_rate, stage.temperature_rate);
            set_equal(last_velocity, stage.velocity);
            const auto loads = driven.constrain(i, {heat, momentum}, known);
            linear.solve(known, tau, loads.heat, loads.momentum, mode, stage);
            if (!stage.failure.empty())
              return;
            const double now = change(tau, known, stage);
            // the next change falls at least by the factor of this one
            if (now * std::min(1., now / last_change) <=
                Tolerances::rounding_of_sum)
              {
                set_end(i, tau, driven, known, stage);
                body.nonlinear->subtract(end, full, heat_load, momentum_load);
                return;
              }
            last_change = now;
          }
        stage.failure =
          text("coefficients of the temperature did not settle in ",
               max_iterations,
               " iterations of Newton's method");
      }
    catch (const InputError &error)
      {
        stage.failure =
          text(error.what(),
               "; where a mesh swings since an end jumps: Mesh/Degree = 1 with "
               "Mesh/Mass matrix = lumped, or an end that changes in time");
      }
  }



  template class NewtonStage<1>;
  template class NewtonStage<2>;
  template class NewtonStage<3>;
} // namespace ThermoContact
