// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/local_sums.h>
#include <thermocontact/space/boundary_flows.h>
#include <thermocontact/space/driven_end.h>

#include <deal.II/base/mpi.h>

namespace ThermoContact
{
  template <int dim>
  BoundaryFlows<dim>::BoundaryFlows(
    const Scene                           &scene,
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &equations,
    const Surroundings<dim>               &surroundings,
    Loads<dim>                            &loads)
    : scene(scene)
    , discretization(discretization)
    , equations(equations)
    , surroundings(surroundings)
    , loads(loads)
  {
    if (scene.fields.has_temperature && scene.heat.has_lateral_exchange())
      {
        Vector ones = discretization.make_vector(Field::temperature);
        ones        = 1.;
        discretization.set_zero_in_gaps(Field::temperature, ones);
        sides.reinit(ones);
        equations.lateral_exchange.vmult(sides, ones);
        sides /= discretization.geometry().cross_section();
        sum_of_sides = ones * sides;
      }
    if (!is_active())
      return;
    for (const types::boundary_id part :
         {fixed_boundary_id, contact_boundary_id})
      ends.push_back(make_end(part));
    heat_of_end       = discretization.make_vector(Field::temperature);
    heat_residual     = heat_of_end;
    heat_product      = heat_of_end;
    momentum_of_end   = discretization.make_vector(Field::displacement);
    momentum_residual = momentum_of_end;
  }



  template <int dim>
  typename BoundaryFlows<dim>::End
  BoundaryFlows<dim>::make_end(const types::boundary_id part)
  {
    const bool                is_left  = part == fixed_boundary_id;
    const SceneHeat          &heat     = scene.heat;
    const BoundaryParameters &boundary = scene.parameters.boundary;
    const SceneFields        &fields   = scene.fields;
    const auto               &left     = boundary.left;
    const auto               &right    = boundary.right;
    const bool                has_given_temperature =
      is_left ? heat.has_given_temperature : bool(heat.right_temperature);
    const bool is_held = is_left ? !scene.has_free_end : right.is_clamped();
    const bool has_exchange = fields.has_temperature && !has_given_temperature;
    const bool has_force    = fields.has_displacement && !is_held;
    const bool is_mass      = !is_left && scene.obstacle_mass.has_value();
    const bool has_springs  = has_force && (dim == 1 || is_mass);
    const std::array<bool, 2> is_given  = {{has_given_temperature, is_held}},
                              has_field = {{fields.has_temperature,
                                            fields.has_displacement}};
    End end{part,
            std::vector<Vector>(2),
            std::vector<std::vector<unsigned int>>(2),
            !has_exchange ? 0. :
            is_left       ? heat.left_exchange :
                            heat.linear_coefficient(),
            is_left ? heat.fixed_end_temperature : heat.obstacle_temperature,
            !has_springs ? 0. :
            is_left      ? left.spring :
                           right.spring,
            !has_springs ? 0. :
            is_left      ? left.dashpot :
                           right.dashpot,
            is_left ? &BoundarySums::heat_left : &BoundarySums::heat_right,
            is_left ? &BoundarySums::impulse_left :
                      &BoundarySums::impulse_right,
            is_left ? &BoundarySums::work_left : &BoundarySums::work_right};
    for (const Field::Block field : {Field::temperature, Field::displacement})
      if (has_field[field])
        {
          end.weights[field] = loads.weights_of_end(part, field);
          if (is_mass && field == Field::displacement)
            {
              end.weights[field] = 0.;
              if (const auto entry =
                    discretization.obstacle_entry(Field::displacement))
                end.weights[field].begin()[*entry] =
                  discretization.geometry().cross_section();
            }
          if (is_given[field] && is_left)
            end.given[field] = entries_of_fixed_end(discretization, field);
          else if (is_given[field])
            end.given[field] = {discretization.entry_of_right_end(field)};
        }
    return end;
  }



  template <int dim>
  double
  BoundaryFlows<dim>::lateral_heat_flux(const State &state) const
  {
    return sides.size() == 0 ? 0. :
                               sides * state.temperature -
                                 sum_of_sides * scene.heat.ambient_temperature;
  }



  template <int dim>
  double
  BoundaryFlows<dim>::heat_by_law(const State &state) const
  {
    if (scene.heat.exchange->is_in_matrices() || scene.heat.right_temperature)
      return 0.;
    const ContactEnd<dim> &end = discretization.contact_end();
    std::vector<double>    flux;
    end.get_values(Field::temperature, state.temperature, flux);
    surroundings.to_fluxes(state, flux);
    double sum = 0.;
    for (unsigned int i = 0; i < flux.size(); ++i)
      if (!end.nodes()[i].has_partner(Field::temperature))
        sum -= end.share(i) * flux[i];
    return sum;
  }



  template <int dim>
  BoundarySums
  BoundaryFlows<dim>::rates(const State             &state,
                            const Vector            &temperature_rate,
                            const Vector            &acceleration,
                            const Vector            &heat_load,
                            const Vector            &momentum_load,
                            const MeanOfTimes *const load_times)
  {
    const bool   has_heat    = scene.fields.has_temperature;
    const bool   has_motion  = scene.fields.has_displacement;
    const bool   has_inertia = scene.material.has_inertia();
    BoundarySums own;
    if (has_heat)
      equations.heat_residual(state,
                              temperature_rate,
                              heat_load,
                              heat_residual);
    if (has_motion)
      equations.momentum_residual(state,
                                  &state.velocity,
                                  has_inertia ? &acceleration : nullptr,
                                  momentum_load,
                                  momentum_residual);
    for (const End &end : ends)
      {
        if (load_times != nullptr)
          loads.assemble_end(end.part,
                             *load_times,
                             heat_of_end,
                             momentum_of_end);
        else
          loads.assemble_end(end.part,
                             state.load_time,
                             heat_of_end,
                             momentum_of_end);
        if (has_heat)
          {
            const Vector &weights = end.weights[Field::temperature];
            own.*end.heat =
              sum_at(end.given[Field::temperature], heat_residual) +
              end.exchange * (end.outside * local_sum(weights) -
                              local_product(weights, state.temperature)) +
              (end.given[Field::temperature].empty() ? local_sum(heat_of_end) :
                                                       0.);
          }
        if (!has_motion)
          continue;
        const Vector &weights = end.weights[Field::displacement];
        const auto   &held    = end.given[Field::displacement];
        const double  v       = local_product(weights, state.velocity);
        const double  attached =
          end.spring * local_product(weights, state.displacement) +
          end.dashpot * v;
        own.*end.impulse = -sum_at(held, momentum_residual) - attached;
        own.*end.work =
          -product_at(held, momentum_residual, state.velocity) -
          attached * v / discretization.geometry().cross_section();
        if (held.empty())
          {
            own.*end.impulse += local_sum(momentum_of_end);
            own.*end.work += local_product(momentum_of_end, state.velocity);
          }
      }
    BoundarySums sums = sum_of_all(own);
    sums.heat_sides   = 0. - lateral_heat_flux(state);
    if (has_heat)
      sums.heat_right += heat_by_law(state);
    return sums;
  }



  template <int dim>
  BoundarySums
  BoundaryFlows<dim>::jump(const Vector &old_temperature,
                           const Vector &old_displacement,
                           const State  &state)
  {
    BoundarySums own;
    Vector       motion(state.displacement);
    if (scene.fields.has_displacement)
      motion -= old_displacement;
    if (scene.fields.has_temperature)
      {
        Vector change(state.temperature);
        change -= old_temperature;
        equations.heat_mass.vmult(heat_residual, change);
        if (scene.material.has_heating())
          equations.divergence.add(scene.material.heating,
                                   motion,
                                   heat_residual,
                                   heat_product);
        for (const End &end : ends)
          own.*end.heat = sum_at(end.given[Field::temperature], heat_residual);
      }
    if (scene.fields.has_displacement)
      {
        for (const End &end : ends)
          {
            loads.assemble_end(end.part,
                               state.load_time,
                               heat_of_end,
                               momentum_of_end);
            const Vector &weights = end.weights[Field::displacement];
            const double  way     = local_product(weights, motion);
            own.*end.work =
              local_product(momentum_of_end, motion) -
              end.spring *
                (local_product(weights, state.displacement) - 0.5 * way) * way /
                discretization.geometry().cross_section();
          }
      }
    return sum_of_all(own);
  }



  template <int dim>
  BoundarySums
  BoundaryFlows<dim>::impact(const Vector &change, const Vector &velocity)
  {
    BoundarySums own;
    equations.momentum_mass.vmult(momentum_residual, change);
    momentum_residual *= scene.material.inertia;
    for (const End &end : ends)
      {
        const auto &held = end.given[Field::displacement];
        own.*end.impulse = sum_at(held, momentum_residual);
        own.*end.work    = product_at(held, momentum_residual, velocity);
      }
    return sum_of_all(own);
  }



  template <int dim>
  BoundarySums
  BoundaryFlows<dim>::sum_of_all(const BoundarySums &own) const
  {
    BoundarySums sums;
    BoundarySums::for_each_column([&](const char *, const auto member) {
      sums.*member =
        Utilities::MPI::sum(own.*member, discretization.communicator()) /
        discretization.geometry().cross_section();
    });
    return sums;
  }



  template class BoundaryFlows<1>;
  template class BoundaryFlows<2>;
  template class BoundaryFlows<3>;
} // namespace ThermoContact
