// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/energy.h>

#include <deal.II/base/function_lib.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** $\theta_s$ in the first component. */
    template <int dim>
    class SteadyProfile : public Function<dim>
    {
    public:
      SteadyProfile(const unsigned int n_components, const HeatExchange &heat)
        : Function<dim>(n_components)
        , heat(heat)
      {}

      double
      value(const Point<dim> &point, const unsigned int c) const override
      {
        return c == 0 ? heat.steady_temperature(point[0]) : 0.;
      }

    private:
      const HeatExchange heat;
    };
  } // namespace



  double
  EnergyTerms::magnitude() const
  {
    return thermal + kinetic + elastic + obstacle + std::abs(coupling);
  }



  template <int dim>
  Energy<dim>::Energy(const Scene                           &scene,
                      const Discretization<dim>             &discretization,
                      const ThermoviscoelasticOperator<dim> &stage_operator,
                      const Loads<dim>                      &loads)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , loads(loads)
    , law(*scene.contact.law)
    , material(scene.material)
    , has_work_(scene.has_work())
    , steady_profile_(discretization.make_vector(Field::temperature))
    , steady_stress(discretization.make_vector(Field::displacement))
    , heat_scratch(steady_profile_)
    , heat_product(steady_profile_)
    , momentum_scratch(steady_stress)
    , momentum_product(steady_stress)
  {
    if (!discretization.has_field(Field::temperature))
      return;
    SystemVector system = discretization.make_system_vector();
    VectorTools::interpolate(discretization.mapping(),
                             discretization.dof_handler(),
                             SteadyProfile<dim>(discretization.n_components(),
                                                scene.heat),
                             system);
    discretization.split(system, steady_profile_, momentum_scratch);
    if (material.has_thermal_stress())
      stage_operator.thermal_stress().vmult(steady_stress, steady_profile_);
  }



  template <int dim>
  double
  Energy<dim>::kinetic_energy(const Vector &velocity) const
  {
    return material.has_inertia() ?
             0.5 * material.inertia *
               momentum_form(stage_operator.momentum_mass(), velocity) :
             0.;
  }



  template <int dim>
  double
  Energy<dim>::heat_form(const LinearMap &map, const Vector &vector) const
  {
    if (!discretization.has_field(Field::temperature))
      return 0.;
    map.vmult(heat_product, vector);
    return vector * heat_product / discretization.geometry().cross_section();
  }



  template <int dim>
  double
  Energy<dim>::momentum_form(const LinearMap &map, const Vector &vector) const
  {
    if (!discretization.has_field(Field::displacement))
      return 0.;
    map.vmult(momentum_product, vector);
    return vector * momentum_product /
           discretization.geometry().cross_section();
  }



  template <int dim>
  EnergyTerms
  Energy<dim>::common(const EnergyTerms &terms) const
  {
    const MPI_Comm communicator = discretization.communicator();
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return terms;
    const std::vector<double> values =
      Utilities::MPI::broadcast(communicator,
                                std::vector<double>{terms.thermal,
                                                    terms.kinetic,
                                                    terms.elastic,
                                                    terms.obstacle,
                                                    terms.coupling});
    return {values[0], values[1], values[2], values[3], values[4]};
  }



  template <int dim>
  EnergyTerms
  Energy<dim>::energy(const State &state) const
  {
    heat_scratch = state.temperature;
    heat_scratch -= steady_profile_;

    EnergyTerms terms;
    terms.thermal = 0.5 * heat_form(stage_operator.heat_mass(), heat_scratch);
    terms.kinetic = kinetic_energy(state.velocity);
    terms.elastic =
      0.5 * momentum_form(stage_operator.stiffness(), state.displacement);
    for (unsigned int i = 0; i < state.contact_pressure.size(); ++i)
      terms.obstacle += discretization.contact_end().share(i) *
                        law.energy(state.contact_pressure[i]);
    if (material.has_thermal_stress())
      terms.coupling = -material.thermal_stress *
                       (steady_stress * state.displacement) /
                       discretization.geometry().cross_section();
    return common(terms);
  }



  template <int dim>
  EnergyTerms
  Energy<dim>::difference_energy(const State               &difference,
                                 const std::vector<double> &pressure) const
  {
    EnergyTerms terms;
    terms.thermal =
      0.5 * heat_form(stage_operator.heat_mass(), difference.temperature);
    terms.kinetic = kinetic_energy(difference.velocity);
    terms.elastic =
      0.5 * momentum_form(stage_operator.stiffness(), difference.displacement);
    const ContactEnd<dim> &end = discretization.contact_end();
    end.get_values(Field::displacement,
                   difference.displacement,
                   end_displacement);
    for (unsigned int i = 0; i < pressure.size(); ++i)
      if (const double tangent = law.tangent(pressure[i]);
          pressure[i] > 0. && tangent > 0.)
        terms.obstacle += 0.5 / tangent * end.share(i) * end_displacement[i] *
                          end_displacement[i];
    return common(terms);
  }



  template <int dim>
  double
  Energy<dim>::dissipation_rate(const State &state) const
  {
    heat_scratch = state.temperature;
    heat_scratch -= steady_profile_;
    double rate = heat_form(stage_operator.conduction(), heat_scratch);
    if (material.has_viscosity())
      rate += material.viscosity *
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

    momentum_scratch = state.velocity;
    momentum_scratch -= old_state.velocity;
    sum += kinetic_energy(momentum_scratch);

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
    const ContactEnd<dim> &end = discretization.contact_end();
    end.get_values(Field::displacement, state.displacement, end_displacement);
    end.get_values(Field::displacement,
                   old_state.displacement,
                   old_end_displacement);
    end.get_penetrations(old_state.displacement, old_penetration);
    double sum = 0.;
    for (unsigned int i = 0; i < state.contact_pressure.size(); ++i)
      sum +=
        end.share(i) *
        law.numerical_dissipation(end_displacement[i] - old_end_displacement[i],
                                  old_penetration[i],
                                  old_state.contact_pressure[i],
                                  state.contact_pressure[i]);
    return sum;
  }



  template <int dim>
  double
  Energy<dim>::work_rate(const Vector &heat_load,
                         const Vector &momentum_load,
                         const State  &state) const
  {
    double rate = 0.;
    if (discretization.has_field(Field::temperature))
      {
        heat_scratch = state.temperature;
        heat_scratch -= steady_profile_;
        if (loads.has_sources())
          {
            heat_product = heat_load;
            heat_product -= loads.obstacle_heat();
            rate += heat_scratch * heat_product;
          }
        if (material.is_driven_by_heat())
          {
            stage_operator.divergence().vmult(heat_product, state.velocity);
            rate += material.thermal_stress * (heat_scratch * heat_product);
          }
      }
    if (discretization.has_field(Field::displacement) && loads.has_sources())
      rate += momentum_load * state.velocity;
    return rate / discretization.geometry().cross_section();
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
