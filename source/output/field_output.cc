// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/base/writable_file.h>
#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/output/field_output.h>
#include <thermocontact/output/vtu_cells.h>
#include <thermocontact/space/shown_fields.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /**
     * Temperature, displacement, velocity and stress of a state as this rank's
     * part of a VTU file, without header and footer: pieces of some cells each,
     * since patches need several times the memory of the fields. Cells of
     * degree p are cut into p parts along each direction, or are Lagrange
     * cells. If dim > 1 the stress is a tensor in space.
     *
     * @param cycle number of the snapshot
     * @throw InputError on all ranks if a coefficient has a value at a node
     * that is not allowed
     */
    template <int dim>
    std::vector<std::string>
    snapshot_pieces(const Body<dim>   &body,
                    const State       &state,
                    const unsigned int cycle,
                    const OutputUnits &units)
    {
      const Discretization<dim> &space  = body.discretization;
      const SceneFields         &fields = body.scene.fields;
      constexpr unsigned int     n_rows = dim == 1 ? 1 : 3; // of the stress

      std::vector<std::string> names(fields.has_temperature, "temperature");
      const unsigned int       first = names.size();
      if (fields.has_displacement)
        {
          names.insert(names.end(), dim, "displacement");
          names.insert(names.end(), dim, "velocity");
          names.insert(names.end(), n_rows * n_rows, "stress");
        }
      VtuCells<dim> cells("fields/fields-*.vtu", names, units);
      cells.flags.time  = units.of("time")(state.time);
      cells.flags.cycle = cycle;
      cells.flags.write_higher_order_cells =
        dim > 1 && body.scene.parameters.output.fields_cells == "Lagrange";
      if (fields.has_displacement)
        {
          cells.join(first, first + dim - 1);
          cells.join(first + dim, first + 2 * dim - 1);
          if (dim > 1)
            cells.join(first + 2 * dim, names.size() - 1);
        }

      const ShownFields<dim>      shown(body.scene, space, state);
      const unsigned int          degree = space.degree();
      FEValues<dim>               values(space.mapping(),
                           space.finite_element(),
                           QIterated<dim>(QTrapezoid<1>(), degree),
                           update_values | update_gradients |
                             update_quadrature_points);
      const unsigned int          n_points = values.n_quadrature_points;
      std::vector<double>         temperature(n_points); // or zeros
      std::vector<Tensor<1, dim>> displacement(n_points), velocity(n_points);
      std::vector<Tensor<2, dim>> gradient(n_points), gradient_rate(n_points);
      std::vector<SymmetricTensor<2, 3>> stress(n_points);

      const auto component = [&](unsigned int row, const unsigned int point) {
        if (row < first)
          return temperature[point];
        row -= first;
        if (row < 2 * dim)
          return row < dim ? displacement[point][row] :
                             velocity[point][row - dim];
        row -= 2 * dim;
        return stress[point][row / n_rows][row % n_rows];
      };

      constexpr double         max_points = 50000.;
      const unsigned int       n_at_once  = std::max(1., max_points / n_points);
      std::vector<std::string> pieces;

      CollectedErrors<InputError> errors;
      for (const auto &cell : space.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && !space.is_gap(cell))
          {
            values.reinit(cell);
            if (fields.has_temperature)
              values[space.temperature_extractor()].get_function_values(
                shown.values(), temperature);
            if (fields.has_displacement)
              {
                const auto &of_fields = values[space.displacement_extractor()];
                of_fields.get_function_values(shown.values(), displacement);
                of_fields.get_function_values(shown.velocities(), velocity);
                of_fields.get_function_gradients(shown.values(), gradient);
                of_fields.get_function_gradients(shown.velocities(),
                                                 gradient_rate);
                for (unsigned int q = 0; q < n_points; ++q)
                  {
                    const Point<dim> &place     = values.quadrature_point(q);
                    const Elasticity elasticity = space.elasticity(cell, place);
                    const auto elastic = [&](const Tensor<2, dim> &of_gradient,
                                             const Tensor<1, dim> &of_value) {
                      return elastic_stress(elasticity,
                                            space.geometry().strain(of_gradient,
                                                                    of_value,
                                                                    place));
                    };
                    errors.collect([&]() {
                      stress[q] =
                        shown.stress(cell,
                                     place,
                                     temperature[q],
                                     temperature[q] *
                                       unit_symmetric_tensor<3>(),
                                     elastic(gradient[q], displacement[q]),
                                     elastic(gradient_rate[q], velocity[q]));
                    });
                  }
              }
            const double length = units.of("position").factor;
            cells.add(
              degree,
              [&](const unsigned int i) { return length * cell->vertex(i); },
              component);
            if (cells.cells().size() == n_at_once)
              pieces.push_back(cells.take_piece());
          }
      errors.throw_on_all_ranks(space.communicator());
      // ParaView does not read a file that starts with a piece without cells
      if (!cells.cells().empty())
        pieces.push_back(cells.take_piece());
      return pieces;
    }
  } // namespace



  template <int dim>
  FieldOutput<dim>::FieldOutput(const std::string &directory,
                                const Body<dim>   &body)
    : directory(directory)
    , body(body)
    , discretization(body.discretization)
    , is_writer(
        Utilities::MPI::this_mpi_process(discretization.communicator()) == 0)
    , units(body.scene.parameters)
    , fields(directory, "fields", units.of("time"))
    , gap(contact_gap<dim>(body.scene))
  {
    if (dim > 1 && (body.obstacle.is_active() || body.scene.obstacle_mass))
      obstacle.emplace(directory, "obstacle", units.of("time"));
    if (dim > 1 && body.law().is_active())
      contact_face.emplace(directory, "contact", units.of("time"));
  }



  template <int dim>
  void
  FieldOutput<dim>::write(const State &state)
  {
    std::string fault = write_fields(state);
    if (fault.empty())
      fault = write_others(state);
    throw_everywhere<ComputationError>(fault, discretization.communicator());
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_fields(const State &state)
  {
    const MPI_Comm                 communicator = discretization.communicator();
    const std::vector<std::string> pieces =
      snapshot_pieces(body, state, times().size(), units);
    const std::string head = VtuCells<dim>::head(),
                      foot = VtuCells<dim>::foot();
    std::vector<std::string_view> part(pieces.begin(), pieces.end());
    if (is_writer)
      part.insert(part.begin(), head);
    if (Utilities::MPI::this_mpi_process(communicator) + 1 ==
        Utilities::MPI::n_mpi_processes(communicator))
      part.push_back(foot);
    return write_parallel_file_atomically(fields.next_path(),
                                          part,
                                          communicator);
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_others(const State &state)
  {
    std::string fault;
    if constexpr (dim > 1)
      {
        const double moved =
          body.scene.obstacle_mass ?
            discretization.obstacle_value(Field::displacement,
                                          state.displacement) :
            0.;
        const auto write = [&](const std::string &path, auto cells) {
          if (is_writer && fault.empty())
            fault = write_atomically(path, cells.file());
        };
        if (obstacle)
          {
            gap->set_time(state.time);
            write(obstacle->next_path(),
                  obstacle_shape(body, units, *gap, moved));
          }
        else if (times().empty() && !body.scene.contact.has_uniform_gap())
          write(directory + "/obstacle.vtu",
                obstacle_shape(body, units, *gap, moved));
        if (contact_face)
          {
            auto face        = ThermoContact::contact_face(body, state, units);
            face.flags.time  = units.of("time")(state.time);
            face.flags.cycle = times().size();
            write(contact_face->next_path(), face);
          }
      }
    for (SnapshotSeries *series : all_series())
      series->add(state.time);
    return fault.empty() ? write_lists(fields.times().size() > 1) : fault;
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_lists(const bool only_due)
  {
    if (!is_writer || (only_due && since_lists.wall_time() < 1.))
      return "";
    since_lists.restart();
    std::string fault;
    for (SnapshotSeries *series : all_series())
      if (fault.empty())
        fault = series->write_pvd();
    return fault;
  }



  template <int dim>
  std::vector<SnapshotSeries *>
  FieldOutput<dim>::all_series()
  {
    std::vector<SnapshotSeries *> all = {&fields};
    if (contact_face)
      all.push_back(&*contact_face);
    if (obstacle)
      all.push_back(&*obstacle);
    return all;
  }



  template <int dim>
  void
  FieldOutput<dim>::restore(const std::vector<double> &times)
  {
    std::string fault;
    for (SnapshotSeries *series : all_series())
      {
        series->restore(times);
        if (is_writer && fault.empty())
          fault = series->remove_later(); // it will be written again
      }
    throw_everywhere<ComputationError>(fault, discretization.communicator());
  }



  template <int dim>
  std::string
  FieldOutput<dim>::sync()
  {
    std::string fault = fields.sync();
    for (SnapshotSeries *series : all_series())
      if (series != &fields && is_writer && fault.empty())
        fault = series->sync();
    return first_fault(fault, discretization.communicator());
  }



  template class FieldOutput<1>;
  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace ThermoContact
