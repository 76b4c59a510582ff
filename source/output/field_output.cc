// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/atomic_file.h>
#include <thermocontact/base/collective_errors.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/output/field_output.h>
#include <thermocontact/output/patch_units.h>
#include <thermocontact/output/snapshot.h>

#include <sstream>

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
    if constexpr (dim == 1)
      if (RodSnapshot::is_for(body) && !units.is_si())
        rod_snapshot.emplace(body);
  }



  template <int dim>
  void
  FieldOutput<dim>::write(const State &state)
  {
    DataOutBase::VtkFlags flags;
    flags.time  = units.of("time")(state.time);
    flags.cycle = times().size();
    flags.physical_units =
      units_of_arrays({"temperature", "displacement", "velocity", "stress"},
                      "fields/fields-*.vtu",
                      units);
    flags.print_date_and_time = false;
    flags.compression_level   = DataOutBase::VtkFlags::best_speed;

    std::string fault =
      rod_snapshot ?
        write_atomically(fields.next_path(),
                         rod_snapshot->file(state, flags.cycle)) :
        write_fields(snapshot_pieces(body, state, flags, units), flags);
    if (fault.empty())
      fault = write_others(state, flags);
    throw_everywhere<ComputationError>(fault, discretization.communicator());
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_fields(const std::vector<std::string> &pieces,
                                 const DataOutBase::VtkFlags    &flags) const
  {
    const MPI_Comm     communicator = discretization.communicator();
    std::ostringstream header, footer;
    if (is_writer)
      DataOutBase::write_vtu_header(header, flags);
    if (Utilities::MPI::this_mpi_process(communicator) + 1 ==
        Utilities::MPI::n_mpi_processes(communicator))
      DataOutBase::write_vtu_footer(footer);
    const std::string             first = header.str(), last = footer.str();
    std::vector<std::string_view> part(pieces.begin(), pieces.end());
    part.insert(part.begin(), first);
    part.push_back(last);
    return write_parallel_file_atomically(fields.next_path(),
                                          part,
                                          communicator);
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_others(const State                 &state,
                                 const DataOutBase::VtkFlags &flags)
  {
    std::string fault;
    const auto  write = [&](const std::string &path, const std::string &text) {
      if (is_writer && fault.empty())
        fault = write_atomically(path, text);
    };
    if (obstacle)
      {
        gap->set_time(state.time);
        write(obstacle->next_path(),
              obstacle_file(body.contact_end(),
                            units,
                            body.scene.contact.rear_gap,
                            gap.get()));
      }
    else if (fields.times().empty() && !body.scene.contact.has_uniform_gap())
      write(directory + "/obstacle.vtu",
            obstacle_file(body.contact_end(),
                          units,
                          body.scene.contact.rear_gap));
    if constexpr (dim > 1)
      if (contact_face)
        write(contact_face->next_path(),
              contact_face_file(body, state, flags, units));
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
