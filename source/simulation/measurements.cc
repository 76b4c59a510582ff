// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/simulation/measurements.h>
#include <thermocontact/space/node_laws.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  template <int dim>
  Measurements<dim>::Measurements(Body<dim> &body)
    : body(body)
    , mean_weights(body.discretization.make_vector(Field::temperature))
  {
    if (body.scene.fields.has_displacement)
      mid_weights = find_weights(0.5);
    if (body.scene.has_midpoint_mass)
      last_cell_weights =
        find_weights(1. - 0.5 * body.scene.parameters.mesh.contact_spacing());
    if (!body.scene.fields.has_temperature)
      return;
    Vector ones(mean_weights);
    ones = 1.;
    body.equations.heat_mass().vmult(mean_weights, ones);
    mean_weights /= ones * mean_weights;
    if (!body.scene.heat.has_lateral_exchange())
      return;
    lateral_weights.reinit(mean_weights);
    body.equations.lateral_exchange().vmult(lateral_weights, ones);
    lateral_weights /= body.discretization.geometry().cross_section();
    lateral_sum = ones * lateral_weights;
  }



  template <int dim>
  std::vector<std::pair<types::global_dof_index, double>>
  Measurements<dim>::weights_at(
    const Point<dim>                                     &point,
    const typename DoFHandler<dim>::active_cell_iterator &cell) const
  {
    const Discretization<dim>           &space = body.discretization;
    const FiniteElement<dim>            &fe    = space.finite_element();
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    cell->get_dof_indices(dofs);
    const Point<dim> unit_point =
      space.mapping().transform_real_to_unit_cell(cell, point);
    std::vector<std::pair<types::global_dof_index, double>> weights;
    for (unsigned int i = 0; i < dofs.size(); ++i)
      if (fe.system_to_component_index(i).first ==
          space.first_component(Field::displacement))
        weights.emplace_back(dofs[i] - space.first_dof(Field::displacement),
                             fe.shape_value(i, unit_point));
    return weights;
  }



  template <int dim>
  typename Measurements<dim>::Weights
  Measurements<dim>::find_weights(const double position) const
  {
    const Discretization<dim> &space = body.discretization;
    const Point<dim>           point = space.geometry().on_axis(position);
    const MPI_Comm             communicator = space.communicator();
    const unsigned int         this_rank =
      Utilities::MPI::this_mpi_process(communicator);
    auto found = space.dof_handler().end();
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() &&
          cell->bounding_box().point_inside(point, Tolerances::in_cell))
        {
          found = cell;
          break;
        }

    // The point may lie between cells of several ranks, and its degrees of
    // freedom may belong to a rank that does not own the cell.
    const bool         is_found = found != space.dof_handler().end();
    const unsigned int rank =
      Utilities::MPI::min(is_found ? this_rank :
                                     std::numeric_limits<unsigned int>::max(),
                          communicator);
    std::vector<std::pair<types::global_dof_index, double>> weights;
    if (rank == this_rank)
      weights = weights_at(point, found);
    weights = Utilities::MPI::broadcast(communicator, weights, rank);

    const IndexSet &owned = space.owned_by_block()[Field::displacement];
    Weights         entries;
    for (const auto &[dof, weight] : weights)
      if (owned.is_element(dof))
        entries.emplace_back(owned.index_within_set(dof), weight);
    return entries;
  }



  template <int dim>
  void
  Measurements<dim>::measure(const State &state, StepRecord &record)
  {
    body.data.set_time(state.load_time);
    record.time             = state.time;
    record.displacement_end = record.displacement_mid = record.velocity_end =
      record.stress_end = record.gap = record.temperature_end =
        record.heat_flux_end         = record.temperature_mean =
          std::numeric_limits<double>::quiet_NaN();
    record.penetration = record.contact_force = record.temperature_mean;
    record.in_contact                         = false;
    if (body.scene.fields.has_displacement)
      measure_displacement(state, record);
    if (body.scene.fields.has_temperature)
      measure_temperature(state, record);
  }



  template <int dim>
  double
  Measurements<dim>::mean_traction()
  {
    const Function<dim> *const traction = body.data.end_traction();
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
    if (body.law().is_active())
      {
        get_node_laws(body, state, contact_laws, contact_values);
        record.gap = std::numeric_limits<double>::infinity();
        for (unsigned int i = 0; i < contact_laws.size(); ++i)
          record.gap =
            std::min(record.gap,
                     0. - contact_laws[i].penetration(contact_values[i]));
      }

    if (!(body.scene.material.is_static() && state.was_moved_at_once()))
      {
        end.get_values(Field::displacement, state.velocity, contact_values);
        record.velocity_end = end.mean(contact_values);
        if (body.scene.has_midpoint_mass)
          record.velocity_end = value(last_cell_weights, state.velocity);
      }

    const auto [smallest, largest] =
      std::minmax_element(state.contact_pressure.begin(),
                          state.contact_pressure.end());
    const double largest_pressure = std::max(*largest, 0. - *smallest);
    record.contact_force          = end.mean(state.contact_pressure);
    record.penetration            = body.law().penetration(largest_pressure);
    record.in_contact             = largest_pressure > 0.;
    if (body.law().damping() > 0.)
      {
        record.penetration = std::max(0., 0. - record.gap);
        record.in_contact  = record.penetration > 0.;
      }
    record.stress_end = mean_traction() - record.contact_force;

    if (dim > 1)
      measure_face(state, record);

    record.displacement_mid = value(mid_weights, state.displacement);
  }



  template <int dim>
  double
  Measurements<dim>::value(const Weights &weights, const Vector &vector) const
  {
    double sum = 0.;
    for (const auto &[entry, weight] : weights)
      sum += weight * vector.begin()[entry];
    const MPI_Comm communicator = body.discretization.communicator();
    return Utilities::MPI::n_mpi_processes(communicator) > 1 ?
             Utilities::MPI::sum(sum, communicator) :
             sum;
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
      if (const double p = state.contact_pressure[i]; p != 0.)
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
    for (unsigned int i = 0; i < contact_values.size(); ++i)
      contact_values[i] =
        body.scene.heat.flux(state.exchange_coefficient[i], contact_values[i]);
    if (const Function<dim> *warming = body.data.obstacle_warming())
      for (unsigned int i = 0; i < contact_values.size(); ++i)
        contact_values[i] -=
          state.exchange_coefficient[i] *
          warming->value(body.contact_end().nodes()[i].position);
    record.heat_flux_end    = body.contact_end().mean(contact_values);
    record.temperature_mean = mean_weights * state.temperature;
    if (body.scene.heat.has_lateral_exchange())
      record.lateral_heat_flux =
        lateral_weights * state.temperature -
        lateral_sum * body.scene.heat.ambient_temperature;
  }



  template class Measurements<1>;
  template class Measurements<2>;
  template class Measurements<3>;
} // namespace ThermoContact
