// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/simulation/measurements.h>
#include <thermocontact/space/node_laws.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  template <int dim>
  Measurements<dim>::Measurements(Body<dim> &body)
    : body(body)
    , mean_weights(body.discretization.make_vector(Field::temperature))
  {
    if (body.scene.fields.has_displacement)
      {
        const auto    &geometry = body.discretization.geometry();
        const BodyRow &row      = body.scene.row;
        const auto     place_at = [&](const double x) {
          return Place<dim>{geometry.on_axis(x), geometry.on_axis(x)};
        };
        std::vector<Place<dim>> places;
        if (!row.is_given())
          places = {place_at(0.5)};
        else if (row.middle())
          places = {place_at(*row.middle())};
        on_axis = std::make_unique<PointValues<dim>>(body.scene,
                                                     body.discretization,
                                                     places);
        if (body.scene.parameters.boundary.right.is_clamped())
          at_right_end = std::make_unique<PointValues<dim>>(
            body.scene,
            body.discretization,
            std::vector<Place<dim>>{place_at(
              row.length() -
              // strains of linear cells are those of their middles
              (body.scene.has_midpoint_mass ?
                 0.5 * (row.is_given() ?
                          row.cells.back().size :
                          body.scene.parameters.mesh.contact_spacing()) :
                 0.))});
      }
    if (!body.scene.fields.has_temperature)
      return;
    Vector ones(mean_weights);
    ones = 1.;
    body.discretization.set_zero_in_gaps(Field::temperature, ones);
    body.equations.heat_mass.vmult(mean_weights, ones);
    mean_weights /= ones * mean_weights;
  }



  template <int dim>
  void
  Measurements<dim>::measure(const State &state, StepRecord &record)
  {
    body.data.set_time(state.load_time);
    record.time             = state.time;
    record.displacement_end = record.displacement_mid = record.velocity_end =
      record.stress_end = record.gap = record.temperature_end =
        record.heat_flux_end = record.temperature_mean = nan;
    record.penetration = record.contact_force = record.temperature_mean;
    record.in_contact                         = false;
    if (body.scene.fields.has_displacement)
      measure_displacement(state, record);
    if (body.scene.fields.has_temperature)
      measure_temperature(state, record);
    if (body.scene.row.is_given())
      measure_row(state, record);
  }



  template <int dim>
  void
  Measurements<dim>::measure_row(const State &state, StepRecord &record)
  {
    const ContactEnd<dim> &end    = body.contact_end();
    const SceneFields     &fields = body.scene.fields;
    const unsigned int     n      = end.n_nodes();
    record.contacts.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        ContactRecord &contact = record.contacts[i];
        contact.time           = state.time;
        contact.gap = contact.velocity = contact.heat_flux = nan;
        contact.contact_force = state.contact.pressure[i];
        contact.in_contact    = false;
      }
    if (fields.has_displacement)
      {
        const BodyRow &row = body.scene.row;
        get_contact_values(body, state, row_values);
        get_node_laws(body, state, contact_laws, contact_values);
        for (unsigned int i = 0; i < n; ++i)
          {
            ContactRecord &contact = record.contacts[i];
            contact.velocity       = row_values.front.velocity[i];
            if (row.n_contacts() == 0)
              continue; // an end that meets nothing
            contact.gap = 0. - contact_laws[i].penetration(contact_values[i]);
            contact.in_contact =
              contact_laws[i].is_in_contact(contact_values[i],
                                            state.contact.pressure[i]);
          }
        const unsigned int last =
          body.discretization.entry_of_right_end(Field::displacement);
        record.displacement_end = state.displacement.begin()[last];
        record.velocity_end     = state.velocity.begin()[last];
        const auto &right       = body.scene.parameters.boundary.right;
        if (right.is_clamped())
          record.velocity_end = 0.;
        // where nothing presses on a rod its nodes may alternate, (C6.13)
        else if (body.scene.has_midpoint_mass && !row.meets_obstacle &&
                 row.bodies.back().n_cells > 0)
          record.velocity_end =
            0.5 * (record.velocity_end + state.velocity.begin()[last - 1]);
        if (!at_right_end)
          record.stress_end = nan;
        double largest = 0.;
        for (const double p : state.contact.pressure)
          if (std::abs(p) > std::abs(largest))
            largest = p;
        record.contact_force = largest;
      }
    if (fields.has_temperature)
      {
        end.get_values(Field::temperature, state.temperature, contact_values);
        for (unsigned int i = 0; i < n; ++i)
          record.contacts[i].heat_flux =
            body.surroundings.flux(i,
                                   body.scene.heat.exchange->is_in_matrices() ?
                                     end.nodes()[i].own_exchange :
                                     state.contact.exchange_coefficient[i],
                                   contact_values[i],
                                   state.load_time);
        record.temperature_end =
          state.temperature.begin()[body.discretization.entry_of_right_end(
            Field::temperature)];
        const SceneHeat &heat = body.scene.heat;
        record.heat_flux_end =
          heat.right_temperature ?
            nan :
          heat.exchange->is_in_matrices() ?
            heat.linear_coefficient() *
              (record.temperature_end -
               body.surroundings.of_obstacle(state.load_time)) :
            record.contacts.back().heat_flux;
      }
  }



  template <int dim>
  double
  Measurements<dim>::mean_traction()
  {
    const Function<dim> *const traction = body.data.end_traction.get();
    if (traction == nullptr)
      return 0.;
    const auto &nodes = body.contact_end().nodes();
    for (unsigned int i = 0; i < nodes.size(); ++i)
      contact_values[i] = traction->value(nodes[i].position);
    return body.contact_end().mean(contact_values);
  }



  template <int dim>
  void
  Measurements<dim>::measure_displacement(const State &state,
                                          StepRecord  &record)
  {
    const ContactEnd<dim> &end = body.contact_end();
    end.get_values(Field::displacement, state.displacement, contact_values);
    record.displacement_end = end.mean(contact_values);
    if (body.scene.obstacle_mass)
      {
        record.obstacle_displacement =
          body.discretization.obstacle_value(Field::displacement,
                                             state.displacement);
        record.obstacle_velocity =
          body.discretization.obstacle_value(Field::displacement,
                                             state.velocity);
        record.displacement_end += record.obstacle_displacement;
      }
    record.in_contact = false;
    if (body.law().is_active())
      {
        get_node_laws(body, state, contact_laws, contact_values);
        record.gap = infinity;
        for (unsigned int i = 0; i < contact_laws.size(); ++i)
          {
            record.gap =
              std::min(record.gap,
                       0. - contact_laws[i].penetration(contact_values[i]));
            record.in_contact |=
              contact_laws[i].is_in_contact(contact_values[i],
                                            state.contact.pressure[i]);
          }
      }

    if (!(body.scene.material.is_static() && state.was_moved_at_once()))
      {
        end.get_values(Field::displacement, state.velocity, contact_values);
        record.velocity_end =
          end.mean(contact_values) + record.obstacle_velocity;
      }

    record.contact_force        = end.mean(state.contact.pressure);
    const SceneContact &contact = body.scene.contact;
    record.penetration =
      contact.is_damped() ? std::max(0., 0. - record.gap) : 0.;
    if (!contact.is_damped())
      for (unsigned int i = 0; i < state.contact.pressure.size(); ++i)
        record.penetration =
          std::max(record.penetration,
                   contact.penetration_under(state.contact.pressure[i], i));
    record.stress_end =
      (body.scene.obstacle_mass ? 0. : mean_traction()) - record.contact_force;
    if (const auto &right = body.scene.parameters.boundary.right;
        right.is_any() && !body.scene.obstacle_mass)
      record.stress_end -= right.mass > 0. ?
                             nan : // the mass has a part of the force
                             right.spring * record.displacement_end +
                               right.dashpot * record.velocity_end;

    if (dim > 1)
      measure_face(state, record);

    const std::vector<double> &middle =
      on_axis->evaluate_axial(state.displacement);
    record.displacement_mid = middle.empty() ? nan : middle[0];
    if (at_right_end) // the stress that holds it
      record.stress_end =
        at_right_end->evaluate(state)[PointValues<dim>::stress];
  }



  template <int dim>
  void
  Measurements<dim>::measure_face(const State &state, StepRecord &record)
  {
    const ContactEnd<dim> &end  = body.contact_end();
    const Point<dim>       axis = body.discretization.geometry().on_axis(1.);
    const bool is_axis_inside   = !body.scene.geometry->has_axis_at_side();
    record.contact_area = record.max_pressure = record.moment_y =
      record.moment_z                         = 0.;
    record.min_gap                            = record.gap;
    for (unsigned int i = 0; i < end.n_nodes(); ++i)
      if (const double p = state.contact.pressure[i]; p != 0.)
        {
          record.contact_area += end.share(i);
          record.max_pressure = std::max(record.max_pressure, std::abs(p));
          if (!is_axis_inside)
            continue;
          const Tensor<1, dim> arm = end.nodes()[i].position - axis;
          record.moment_y += end.share(i) * p * (dim > 1 ? arm[dim > 1] : 0.);
          record.moment_z += end.share(i) * p * (dim > 2 ? arm[dim - 1] : 0.);
        }
  }



  template <int dim>
  void
  Measurements<dim>::measure_temperature(const State &state, StepRecord &record)
  {
    body.contact_end().get_values(Field::temperature,
                                  state.temperature,
                                  contact_values);
    record.temperature_end = body.contact_end().mean(contact_values);
    if (body.scene.obstacle_mass)
      {
        record.obstacle_temperature =
          body.discretization.obstacle_value(Field::temperature,
                                             state.temperature);
        record.temperature_end += record.obstacle_temperature;
      }
    body.surroundings.to_fluxes(state, contact_values);
    record.heat_flux_end     = body.scene.heat.right_temperature ?
                                 nan : // from the state alone it is not known
                             body.contact_end().mean(contact_values);
    record.temperature_mean  = mean_weights * state.temperature;
    record.lateral_heat_flux = body.boundary_flows.lateral_heat_flux(state);
  }



  template class Measurements<1>;
  template class Measurements<2>;
  template class Measurements<3>;
} // namespace ThermoContact
