// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/local_sums.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/energy.h>
#include <thermocontact/space/node_laws.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  double
  EnergyTerms::magnitude() const
  {
    return thermal + kinetic + elastic + obstacle + std::abs(coupling);
  }



  template <int dim>
  Energy<dim>::Energy(const Scene                           &scene,
                      const Discretization<dim>             &discretization,
                      const ThermoviscoelasticOperator<dim> &stage_operator,
                      const Loads<dim>                      &loads,
                      const Surroundings<dim>               &surroundings)
    : discretization(discretization)
    , stage_operator(stage_operator)
    , loads(loads)
    , surroundings(surroundings)
    , contact(scene.contact)
    , material(scene.material)
    , heat(scene.heat)
    , has_work_(scene.has_work())
    , steady_profile_(discretization.make_vector(Field::temperature))
    , steady_stress(discretization.make_vector(Field::displacement))
    , reference_coefficient(heat.reference_coefficient)
    , heat_scratch(steady_profile_)
    , heat_product(steady_profile_)
    , momentum_scratch(steady_stress)
    , momentum_product(steady_stress)
  {
    if (!discretization.has_field(Field::temperature))
      return;
    set_steady_profile();
    discretization.contact_end().get_values(Field::temperature,
                                            steady_profile_,
                                            steady_end);
    if (discretization.has_bodies())
      {
        unbalanced_heat = loads.outer_heat();
        stage_operator.conduction.add(-1.,
                                      steady_profile_,
                                      unbalanced_heat,
                                      heat_product);
        stage_operator.zero_constrained(Field::temperature, unbalanced_heat);
        reference_coefficient = 0.;
      }
    if (material.has_thermal_stress())
      stage_operator.thermal_stress.vmult(steady_stress, steady_profile_);
  }



  template <int dim>
  double
  Energy<dim>::thermal_energy(const Vector &temperature,
                              const Vector *subtracted) const
  {
    return 0.5 * form(Field::temperature,
                      stage_operator.heat_mass,
                      temperature,
                      subtracted);
  }



  template <int dim>
  double
  Energy<dim>::elastic_energy(const Vector &displacement,
                              const Vector *subtracted) const
  {
    return 0.5 * form(Field::displacement,
                      stage_operator.stiffness,
                      displacement,
                      subtracted);
  }



  template <int dim>
  double
  Energy<dim>::kinetic_energy(const Vector &velocity,
                              const Vector *subtracted) const
  {
    return material.has_inertia() ? 0.5 * material.inertia *
                                      form(Field::displacement,
                                           stage_operator.momentum_mass,
                                           velocity,
                                           subtracted) :
                                    0.;
  }



  template <int dim>
  double
  Energy<dim>::form(const Field::Block field,
                    const LinearMap   &map,
                    const Vector      &vector,
                    const Vector      *subtracted) const
  {
    if (!discretization.has_field(field))
      return 0.;
    const bool is_heat = field == Field::temperature;
    return map.form(vector,
                    subtracted,
                    is_heat ? heat_scratch : momentum_scratch,
                    is_heat ? heat_product : momentum_product) /
           discretization.geometry().cross_section();
  }



  template <int dim>
  EnergyTerms
  Energy<dim>::common(const EnergyTerms &terms) const
  {
    const MPI_Comm communicator = discretization.communicator();
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return terms;
    return broadcast(communicator, terms);
  }



  template <int dim>
  double
  Energy<dim>::obstacle_energy(const State &state) const
  {
    const std::vector<double> &pressure =
      elastic_pressures(state, end_pressure);
    double sum = 0.;
    for (unsigned int i = 0; i < pressure.size(); ++i)
      sum += discretization.contact_end().share(i) *
             contact.law_under(pressure[i], i).energy(pressure[i]);
    return sum;
  }



  template <int dim>
  EnergyTerms
  Energy<dim>::energy(const State &state) const
  {
    EnergyTerms terms;
    terms.thermal  = thermal_energy(state.temperature, &steady_profile_);
    terms.kinetic  = kinetic_energy(state.velocity);
    terms.elastic  = elastic_energy(state.displacement);
    terms.obstacle = obstacle_energy(state);
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
    terms.thermal              = thermal_energy(difference.temperature);
    terms.kinetic              = kinetic_energy(difference.velocity);
    terms.elastic              = elastic_energy(difference.displacement);
    const ContactEnd<dim> &end = discretization.contact_end();
    end.get_values(Field::displacement,
                   difference.displacement,
                   end_displacement);
    for (unsigned int i = 0; i < pressure.size(); ++i)
      if (const double tangent =
            contact.law_under(pressure[i], i).tangent(pressure[i]);
          pressure[i] != 0. && tangent > 0.)
        terms.obstacle += 0.5 / tangent * end.share(i) * end_displacement[i] *
                          end_displacement[i];
    return common(terms);
  }



  template <int dim>
  double
  Energy<dim>::dissipation_rate(const State &state) const
  {
    double rate = form(Field::temperature,
                       stage_operator.conduction,
                       state.temperature,
                       &steady_profile_);
    if (const double factor = material.viscous_factor(); factor > 0.)
      rate += factor * form(Field::displacement,
                            stage_operator.viscous_stiffness,
                            state.velocity);
    if (!heat.exchange->is_in_matrices())
      {
        set_equal(heat_scratch, state.temperature);
        heat_scratch -= steady_profile_;
        rate +=
          mean_of_end(heat_scratch,
                      [&](const unsigned int i, const double value) {
                        return state.contact.exchange_coefficient[i] * value;
                      });
      }
    return rate;
  }



  template <int dim>
  double
  Energy<dim>::lateral_dissipation_rate(const State &state) const
  {
    return heat.has_lateral_exchange() ? form(Field::temperature,
                                              stage_operator.lateral_exchange,
                                              state.temperature,
                                              &steady_profile_) :
                                         0.;
  }



  template <int dim>
  template <typename Power>
  double
  Energy<dim>::mean_of_end(const Vector &excess, const Power &power) const
  {
    const ContactEnd<dim> &end = discretization.contact_end();
    end.get_values(Field::temperature, excess, end_temperature);
    for (unsigned int i = 0; i < end_temperature.size(); ++i)
      end_temperature[i] *= power(i, end_temperature[i]);
    return end.mean(end_temperature);
  }



  template <int dim>
  double
  Energy<dim>::numerical_dissipation(const State &old_state,
                                     const State &state) const
  {
    return thermal_energy(state.temperature, &old_state.temperature) +
           kinetic_energy(state.velocity, &old_state.velocity) +
           elastic_energy(state.displacement, &old_state.displacement) +
           contact_dissipation(old_state, state);
  }



  template <int dim>
  double
  Energy<dim>::work_rate(const Vector &heat_load,
                         const Vector &momentum_load,
                         const State  &state) const
  {
    const double area = discretization.geometry().cross_section();
    double       rate = 0.;
    if (discretization.has_field(Field::temperature))
      {
        set_equal(heat_scratch, state.temperature);
        heat_scratch -= steady_profile_;
        if (loads.has_sources())
          {
            set_equal(heat_product, heat_load);
            heat_product -= loads.outer_heat();
            rate += heat_scratch * heat_product;
          }
        if (discretization.has_bodies())
          rate += heat_scratch * unbalanced_heat;
        if (!heat.exchange->is_in_matrices())
          rate +=
            area *
            mean_of_end(heat_scratch, [&](const unsigned int i, const double) {
              const double k = state.contact.exchange_coefficient[i];
              return k * (surroundings.temperature(i, state.load_time) -
                          surroundings.reference(i)) -
                     (k - reference_coefficient) *
                       (steady_end[i] - surroundings.reference(i));
            });
      }
    return rate / area + work_of_motion(momentum_load, state, state.velocity);
  }



  template <int dim>
  double
  Energy<dim>::work_of_motion(const Vector &momentum_load,
                              const State  &state,
                              const Vector &motion) const
  {
    double work = 0.;
    if (material.is_driven_by_heat())
      {
        set_equal(heat_scratch, state.temperature);
        heat_scratch -= steady_profile_;
        stage_operator.divergence.vmult(heat_product, motion);
        work += material.thermal_stress * (heat_scratch * heat_product);
      }
    if (discretization.has_field(Field::displacement) && loads.has_sources())
      work += momentum_load * motion;
    return work / discretization.geometry().cross_section();
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
    return thermal_energy(steady_profile_);
  }



  template <int dim>
  const std::vector<double> &
  Energy<dim>::elastic_pressures(const State         &state,
                                 std::vector<double> &scratch) const
  {
    if (!contact.is_damped())
      return state.contact.pressure;
    const ContactEnd<dim> &end = discretization.contact_end();
    end.get_values(Field::displacement, state.velocity, end_velocity);
    get_node_laws(contact, end, state, laws, position);
    const double rounding =
      Tolerances::rounding_of_penetration * state.displacement.linfty_norm();
    scratch.resize(laws.size());
    for (unsigned int i = 0; i < laws.size(); ++i)
      scratch[i] =
        // a motion at once has no velocity
        material.is_static() ?
          laws[i].elastic_pressure(position[i]) :
          laws[i].elastic_pressure(position[i],
                                   end_velocity[i],
                                   state.contact.pressure[i],
                                   rounding);
    return scratch;
  }



  template <int dim>
  double
  Energy<dim>::damping_rate(const State &state) const
  {
    if (!contact.is_damped())
      return 0.;
    const std::vector<double> &elastic = elastic_pressures(state, end_pressure);
    double                     rate    = 0.;
    for (unsigned int i = 0; i < elastic.size(); ++i)
      {
        const double p = state.contact.pressure[i];
        rate += discretization.contact_end().share(i) * (p - elastic[i]) *
                (end_velocity[i] - laws[i].rate_under(std::min(p, elastic[i])));
      }
    return rate;
  }



  template <int dim>
  double
  Energy<dim>::obstacle_power(const State &state) const
  {
    const ContactEnd<dim> &end = discretization.contact_end();
    get_node_laws(contact, end, state, laws, position);
    double power = 0.;
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        const double p = state.contact.pressure[i];
        power -= end.share(i) * p * laws[i].rate_under(p);
      }
    return power;
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
    const std::vector<double> &pressure =
      elastic_pressures(state, end_pressure);
    const std::vector<double> &old_pressure =
      elastic_pressures(old_state, old_end_pressure);
    get_node_laws(contact, end, old_state, laws, position);
    double sum = 0.;
    for (unsigned int i = 0; i < pressure.size(); ++i)
      sum += end.share(i) *
             laws[i].numerical_dissipation(position[i],
                                           end_displacement[i] -
                                             old_end_displacement[i],
                                           state.gap[i] - old_state.gap[i],
                                           old_pressure[i],
                                           pressure[i]);
    return sum;
  }



  template class Energy<1>;
  template class Energy<2>;
  template class Energy<3>;
} // namespace ThermoContact
