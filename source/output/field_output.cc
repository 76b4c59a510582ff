// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/base/writable_file.h>
#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/output/field_output.h>
#include <thermocontact/output/snapshot.h>

namespace ThermoContact
{
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
    if (dim > 1 && body.obstacle.is_active())
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
        const auto write = [&](const std::string &path, auto cells) {
          if (is_writer && fault.empty())
            fault = write_atomically(path, cells.file());
        };
        const double rear_gap = body.scene.contact.rear_gap;
        if (obstacle)
          {
            gap->set_time(state.time);
            write(
              obstacle->next_path(),
              obstacle_shape(body.contact_end(), units, rear_gap, gap.get()));
          }
        else if (times().empty() && !body.scene.contact.has_uniform_gap())
          write(directory + "/obstacle.vtu",
                obstacle_shape(body.contact_end(), units, rear_gap));
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
    const auto now = std::chrono::steady_clock::now();
    if (!is_writer || (only_due && now - last_lists < std::chrono::seconds(1)))
      return "";
    last_lists = now;
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
