// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/measurements.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <limits>

namespace ThermoContact
{
  template <int dim>
  Measurements<dim>::Measurements(
    const Discretization<dim>             &discretization,
    const ThermoviscoelasticOperator<dim> &stage_operator,
    const ContactLaw                      &law,
    const Parameters                      &parameters)
    : discretization(discretization)
    , law(law)
    , boundary(parameters.boundary)
    , has_no_initial_velocity(parameters.model.is_static())
    , mean_weights(discretization.make_vector(0))
  {
    if (discretization.has_field(1))
      find_mid_point(parameters.mesh.width);
    if (!discretization.has_field(0))
      return;
    Vector ones(mean_weights);
    ones = 1.;
    stage_operator.heat_mass().vmult(mean_weights, ones);
    mean_weights /= ones * mean_weights;
  }



  template <int dim>
  void
  Measurements<dim>::find_mid_point(const double width)
  {
    Point<dim> mid_point;
    for (unsigned int d = 0; d < dim; ++d)
      mid_point[d] = 0.5 * (d == 0 ? 1. : width);

    const FiniteElement<dim>            &fe = discretization.finite_element();
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    const MPI_Comm     communicator = discretization.communicator();
    const unsigned int this_rank =
      Utilities::MPI::this_mpi_process(communicator);

    auto found = discretization.dof_handler().end();
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() &&
          cell->bounding_box().point_inside(mid_point, 1e-10))
        {
          found = cell;
          break;
        }

    // The point may lie between cells of several ranks, and its degrees of
    // freedom may belong to a rank that does not own the cell.
    const bool         is_found = found != discretization.dof_handler().end();
    const unsigned int rank =
      Utilities::MPI::min(is_found ? this_rank :
                                     std::numeric_limits<unsigned int>::max(),
                          communicator);
    std::vector<std::pair<types::global_dof_index, double>> weights;
    if (rank == this_rank)
      {
        const Point<dim> unit_point =
          discretization.mapping().transform_real_to_unit_cell(found,
                                                               mid_point);
        found->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (fe.system_to_component_index(i).first ==
              discretization.first_component(1))
            weights.emplace_back(dofs[i] - discretization.n_temperature_dofs(),
                                 fe.shape_value(i, unit_point));
      }
    weights = Utilities::MPI::broadcast(communicator, weights, rank);

    const IndexSet &owned = discretization.owned_by_block()[1];
    for (const auto &[dof, weight] : weights)
      if (owned.is_element(dof))
        mid_weights.emplace_back(owned.index_within_set(dof), weight);
  }



  template <int dim>
  void
  Measurements<dim>::measure(const State      &state,
                             ProblemData<dim> &data,
                             StepRecord       &record)
  {
    data.set_time(state.time);
    record.time             = state.time;
    record.displacement_end = record.displacement_mid = record.velocity_end =
      record.stress_end = record.gap = record.temperature_end =
        record.heat_flux_end         = record.temperature_mean =
          std::numeric_limits<double>::quiet_NaN();
    record.penetration = record.contact_force = record.temperature_mean;
    record.in_contact                         = false;
    if (discretization.has_field(1))
      measure_displacement(state, data, record);
    if (discretization.has_field(0))
      measure_temperature(state, record);
  }



  template <int dim>
  void
  Measurements<dim>::measure_displacement(const State            &state,
                                          const ProblemData<dim> &data,
                                          StepRecord             &record)
  {
    discretization.contact_values(1, state.displacement, contact_values);
    record.displacement_end = discretization.contact_mean(contact_values);
    if (law.is_active)
      record.gap = law.gap - *std::max_element(contact_values.begin(),
                                               contact_values.end());

    if (!(has_no_initial_velocity && state.time == 0.))
      {
        discretization.contact_values(1, state.velocity, contact_values);
        record.velocity_end = discretization.contact_mean(contact_values);
      }

    const double largest_pressure =
      *std::max_element(state.contact_pressure.begin(),
                        state.contact_pressure.end());
    record.contact_force = discretization.contact_mean(state.contact_pressure);
    record.penetration   = law.compliance * largest_pressure;
    record.in_contact    = largest_pressure > 0.;

    double traction = 0.;
    if (data.end_traction() != nullptr)
      {
        for (unsigned int i = 0; i < contact_values.size(); ++i)
          contact_values[i] = data.end_traction()->value(
            discretization.contact_nodes()[i].position);
        traction = discretization.contact_mean(contact_values);
      }
    record.stress_end = traction - record.contact_force;

    double mid = 0.;
    for (const auto &[entry, weight] : mid_weights)
      mid += weight * state.displacement.begin()[entry];
    if (Utilities::MPI::n_mpi_processes(discretization.communicator()) > 1)
      mid = Utilities::MPI::sum(mid, discretization.communicator());
    record.displacement_mid = mid;
  }



  template <int dim>
  void
  Measurements<dim>::measure_temperature(const State &state, StepRecord &record)
  {
    discretization.contact_values(0, state.temperature, contact_values);
    record.temperature_end = discretization.contact_mean(contact_values);
    record.heat_flux_end =
      boundary.heat_exchange *
      (record.temperature_end - boundary.obstacle_temperature);
    record.temperature_mean = mean_weights * state.temperature;
  }



  template class Measurements<1>;
  template class Measurements<2>;
  template class Measurements<3>;
} // namespace ThermoContact
