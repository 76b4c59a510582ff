// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/energy.h>

#include <deal.II/base/function_lib.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** $\theta_A - c(\theta_A-\theta_{obs})x$ in the first component. */
    template <int dim>
    class SteadyProfile : public Function<dim>
    {
    public:
      SteadyProfile(const unsigned int        n_components,
                    const BoundaryParameters &boundary)
        : Function<dim>(n_components)
        , left(boundary.fixed_end_temperature)
        , slope(
            -boundary.heat_exchange / (boundary.heat_exchange + 1.) *
            (boundary.fixed_end_temperature - boundary.obstacle_temperature))
      {}

      double
      value(const Point<dim> &point, const unsigned int c) const override
      {
        return c == 0 ? left + slope * point[0] : 0.;
      }

    private:
      const double left;
      const double slope;
    };
  } // namespace



  double
  EnergyTerms::magnitude() const
  {
    return thermal + kinetic + elastic + obstacle + std::abs(coupling);
  }



  template <int dim>
  Energy<dim>::Energy(const Discretization<dim>             &discretization,
                      const ThermoviscoelasticOperator<dim> &stage_operator,
                      const Loads<dim>                      &loads,
                      const ContactLaw                      &law,
                      const Parameters                      &parameters)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , loads(loads)
    , law(law)
    , model(parameters.model)
    , steady_profile_(discretization.make_vector(0))
    , steady_stress(discretization.make_vector(1))
    , heat_scratch(steady_profile_)
    , heat_product(steady_profile_)
    , momentum_scratch(steady_stress)
    , momentum_product(steady_stress)
  {
    if (!model.has_temperature())
      return;
    Vector system = discretization.make_system_vector();
    VectorTools::interpolate(discretization.mapping(),
                             discretization.dof_handler(),
                             SteadyProfile<dim>(discretization.n_components(),
                                                parameters.boundary),
                             system);
    discretization.split(system, steady_profile_, momentum_scratch);
    if (model.thermal_stress() != 0.)
      stage_operator.thermal_stress().vmult(steady_stress, steady_profile_);
  }



  template <int dim>
  double
  Energy<dim>::heat_form(const SparseMatrix &matrix, const Vector &vector) const
  {
    if (!model.has_temperature())
      return 0.;
    matrix.vmult(heat_product, vector);
    return vector * heat_product / discretization.cross_section();
  }



  template <int dim>
  double
  Energy<dim>::momentum_form(const SparseMatrix &matrix,
                             const Vector       &vector) const
  {
    if (!model.has_displacement())
      return 0.;
    matrix.vmult(momentum_product, vector);
    return vector * momentum_product / discretization.cross_section();
  }



  template <int dim>
  EnergyTerms
  Energy<dim>::energy(const State &state) const
  {
    heat_scratch = state.temperature;
    heat_scratch -= steady_profile_;

    EnergyTerms terms;
    terms.thermal = 0.5 * heat_form(stage_operator.heat_mass(), heat_scratch);
    if (model.inertia > 0.)
      terms.kinetic =
        0.5 * model.inertia *
        momentum_form(stage_operator.momentum_mass(), state.velocity);
    terms.elastic =
      0.5 * momentum_form(stage_operator.stiffness(), state.displacement);
    for (unsigned int i = 0; i < state.contact_pressure.size(); ++i)
      terms.obstacle += 0.5 * law.compliance *
                        discretization.contact_nodes()[i].weight /
                        discretization.cross_section() *
                        state.contact_pressure[i] * state.contact_pressure[i];
    if (model.thermal_stress() != 0.)
      terms.coupling = -model.thermal_stress() *
                       (steady_stress * state.displacement) /
                       discretization.cross_section();
    return terms;
  }



  template <int dim>
  EnergyTerms
  Energy<dim>::difference_energy(const State               &difference,
                                 const std::vector<double> &pressure) const
  {
    EnergyTerms terms;
    terms.thermal =
      0.5 * heat_form(stage_operator.heat_mass(), difference.temperature);
    if (model.inertia > 0.)
      terms.kinetic =
        0.5 * model.inertia *
        momentum_form(stage_operator.momentum_mass(), difference.velocity);
    terms.elastic =
      0.5 * momentum_form(stage_operator.stiffness(), difference.displacement);
    if (law.compliance == 0.)
      return terms;
    discretization.contact_values(1, difference.displacement, end_displacement);
    for (unsigned int i = 0; i < pressure.size(); ++i)
      if (pressure[i] > 0.)
        terms.obstacle += 0.5 / law.compliance *
                          discretization.contact_nodes()[i].weight /
                          discretization.cross_section() * end_displacement[i] *
                          end_displacement[i];
    return terms;
  }



  template <int dim>
  double
  Energy<dim>::dissipation_rate(const State &state) const
  {
    heat_scratch = state.temperature;
    heat_scratch -= steady_profile_;
    double rate = heat_form(stage_operator.conduction(), heat_scratch);
    if (model.viscosity > 0.)
      rate += model.viscosity *
              momentum_form(stage_operator.viscous_stiffness(), state.velocity);
    return rate;
  }



  template <int dim>
  double
  Energy<dim>::numerical_dissipation(const State &old_state,
                                     const State &state) const
  {
    heat_scratch = state.temperature;
    heat_scratch -= old_state.temperature;
    double sum = 0.5 * heat_form(stage_operator.heat_mass(), heat_scratch);

    if (model.inertia > 0.)
      {
        momentum_scratch = state.velocity;
        momentum_scratch -= old_state.velocity;
        sum += 0.5 * model.inertia *
               momentum_form(stage_operator.momentum_mass(), momentum_scratch);
      }

    momentum_scratch = state.displacement;
    momentum_scratch -= old_state.displacement;
    sum += 0.5 * momentum_form(stage_operator.stiffness(), momentum_scratch);

    return sum + contact_dissipation(old_state, state);
  }



  template <int dim>
  double
  Energy<dim>::contact_dissipation(const State &old_state,
                                   const State &state) const
  {
    discretization.contact_values(1, state.displacement, end_displacement);
    discretization.contact_values(1,
                                  old_state.displacement,
                                  old_end_displacement);
    double sum = 0.;
    for (unsigned int i = 0; i < state.contact_pressure.size(); ++i)
      {
        const double p     = state.contact_pressure[i];
        const double p_old = old_state.contact_pressure[i];
        const double term =
          law.compliance == 0. ?
            p * (law.gap - old_end_displacement[i]) :
            p * (end_displacement[i] - old_end_displacement[i]) -
              0.5 * law.compliance * (p * p - p_old * p_old);
        sum += discretization.contact_nodes()[i].weight /
               discretization.cross_section() * term;
      }
    return sum;
  }



  template <int dim>
  double
  Energy<dim>::work_rate(const Vector &heat_load,
                         const Vector &momentum_load,
                         const State  &state) const
  {
    double rate = 0.;
    if (model.has_temperature())
      {
        heat_scratch = state.temperature;
        heat_scratch -= steady_profile_;
        if (loads.has_sources())
          {
            heat_product = heat_load;
            heat_product -= loads.obstacle_heat();
            rate += heat_scratch * heat_product;
          }
        if (is_driven_by_heat())
          {
            stage_operator.divergence().vmult(heat_product, state.velocity);
            rate += model.thermal_stress() * (heat_scratch * heat_product);
          }
      }
    if (model.has_displacement() && loads.has_sources())
      rate += momentum_load * state.velocity;
    return rate / discretization.cross_section();
  }



  template <int dim>
  bool
  Energy<dim>::is_driven_by_heat() const
  {
    return model.thermal_stress() != 0. && !model.heating;
  }



  template <int dim>
  bool
  Energy<dim>::has_work() const
  {
    return loads.has_sources() || is_driven_by_heat();
  }



  template <int dim>
  const Vector &
  Energy<dim>::steady_profile() const
  {
    return steady_profile_;
  }



  template <int dim>
  double
  Energy<dim>::steady_profile_energy() const
  {
    return 0.5 * heat_form(stage_operator.heat_mass(), steady_profile_);
  }



  template class Energy<1>;
  template class Energy<2>;
  template class Energy<3>;
} // namespace ThermoContact
