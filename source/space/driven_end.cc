// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/dealii_versions.h>
#include <thermocontact/base/local_sums.h>
#include <thermocontact/space/driven_end.h>

#include <deal.II/base/mpi.h>

#include <deal.II/numerics/vector_tools_boundary.h>

namespace ThermoContact
{
  template <int dim>
  std::vector<unsigned int>
  entries_of_fixed_end(const Discretization<dim> &space,
                       const Field::Block         field)
  {
    AffineConstraints<double> held =
      make_unconstrained(space.owned(), space.relevant());
    ComponentMask component(space.n_components(), false);
    component.set(space.first_component(field), true);
    VectorTools::interpolate_boundary_values(space.mapping(),
                                             space.dof_handler(),
                                             fixed_boundary_id,
                                             Functions::ZeroFunction<dim>(
                                               space.n_components()),
                                             held,
                                             component);
    std::vector<unsigned int> entries;
    const IndexSet           &owned = space.owned_by_block()[field];
    for (const types::global_dof_index dof : owned)
      if (held.is_constrained(dof + space.first_dof(field)))
        entries.push_back(owned.index_within_set(dof));
    return entries;
  }



  template <int dim>
  DrivenEnd<dim>::DrivenEnd(const Scene                           &scene,
                            const Discretization<dim>             &space,
                            const ThermoviscoelasticOperator<dim> &equations,
                            const Loads<dim>                      &loads,
                            const Energy<dim>                     &energy)
    : scene(scene)
    , discretization(space)
    , equations(equations)
    , loads(loads)
    , energy(energy)
    , entries_(2)
  {
    if (!is_active())
      return;
    if (scene.sources.has_driven_temperature)
      entries_[Field::temperature] =
        entries_of_fixed_end(space, Field::temperature);
    if (scene.sources.has_moving_end)
      entries_[Field::displacement] =
        entries_of_fixed_end(space, Field::displacement);
    heat_lift        = space.make_vector(Field::temperature);
    heat_product     = heat_lift;
    momentum_lift    = space.make_vector(Field::displacement);
    momentum_product = momentum_lift;
  }



  template <int dim>
  void
  DrivenEnd<dim>::set(const Field::Block         field,
                      const std::vector<double> &values,
                      Vector                    &vector) const
  {
    for (unsigned int i = 0; i < values.size(); ++i)
      vector.begin()[entries_[field][i]] = values[i];
  }



  template <int dim>
  void
  DrivenEnd<dim>::constrain(const PrescribedStage &temperature,
                            const PrescribedStage &displacement,
                            State                 &known,
                            Vector                &heat_load,
                            Vector                &momentum_load) const
  {
    const Material &material = scene.material;
    set(Field::temperature, temperature.values, known.temperature);
    set(Field::displacement, displacement.values, known.displacement);
    if (scene.sources.has_driven_temperature)
      {
        set(Field::temperature, temperature.rates, heat_lift);
        equations.heat_mass.add(-1., heat_lift, heat_load, heat_product);
      }
    if (!scene.sources.has_moving_end)
      return;
    if (material.has_inertia())
      {
        set(Field::displacement, displacement.accelerations, momentum_lift);
        equations.momentum_mass.add(-material.inertia,
                                    momentum_lift,
                                    momentum_load,
                                    momentum_product);
        // the known velocity of the end is in this term
        for (const unsigned int entry : entries_[Field::displacement])
          known.velocity.begin()[entry] = 0.;
      }
    set(Field::displacement, displacement.rates, momentum_lift);
    if (const double factor = material.viscous_factor(); factor > 0.)
      equations.viscous_stiffness.add(-factor,
                                      momentum_lift,
                                      momentum_load,
                                      momentum_product);
    if (material.has_heating())
      equations.divergence.add(-material.heating,
                               momentum_lift,
                               heat_load,
                               heat_product);
  }



  template <int dim>
  double
  DrivenEnd<dim>::power(const State  &state,
                        const Vector &temperature_rate,
                        const Vector &acceleration,
                        const Vector &heat_load,
                        const Vector &momentum_load) const
  {
    double sum = 0.;
    if (scene.sources.has_driven_temperature)
      sum += heat_power(state, temperature_rate, heat_load);
    if (scene.sources.has_moving_end)
      sum += force_power(state, acceleration, momentum_load);
    return Utilities::MPI::sum(sum, discretization.communicator()) /
           discretization.geometry().cross_section();
  }



  template <int dim>
  double
  DrivenEnd<dim>::heat_power(const State  &state,
                             const Vector &temperature_rate,
                             const Vector &heat_load) const
  {
    const std::vector<unsigned int> &end    = entries_[Field::temperature];
    Vector                           excess = state.temperature;
    excess -= energy.steady_profile();
    equations.heat_mass.vmult(heat_product, temperature_rate);
    double sum = product_at(end, heat_product, excess);
    equations.conduction.vmult(heat_product, excess);
    sum += product_at(end, heat_product, excess);
    if (scene.material.has_heating())
      {
        equations.divergence.vmult(heat_product, state.velocity);
        sum += scene.material.heating * product_at(end, heat_product, excess);
      }
    // the heat of the surroundings is part of the state of rest
    return sum - product_at(end, heat_load, excess) +
           product_at(end, loads.outer_heat(), excess);
  }



  template <int dim>
  double
  DrivenEnd<dim>::force_power(const State  &state,
                              const Vector &acceleration,
                              const Vector &momentum_load) const
  {
    equations.momentum_residual(
      state, &state.velocity, &acceleration, momentum_load, momentum_product);
    return -product_at(entries_[Field::displacement],
                       momentum_product,
                       state.velocity);
  }



  template <int dim>
  void
  DrivenEnd<dim>::set_velocity(const double time, Vector &velocity) const
  {
    if (!scene.sources.has_moving_end)
      return;
    const double rate = scene.fixed_end_motion->derivatives(time).first;
    for (const unsigned int entry : entries_[Field::displacement])
      velocity.begin()[entry] = rate;
  }



  template class DrivenEnd<1>;
  template class DrivenEnd<2>;
  template class DrivenEnd<3>;
} // namespace ThermoContact
