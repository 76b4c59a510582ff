// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/multiples.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/output/output.h>

#include <filesystem>

namespace ThermoContact
{
  namespace
  {
    /** Rows after which a fault of the file is looked for on all ranks. */
    constexpr unsigned int rows_between_checks = 1000;



    template <int dim>
    std::vector<Place<dim>>
    probe_places(const Parameters &parameters)
    {
      std::vector<Place<dim>> places;
      for (const auto &coordinates : parameters.probe_positions())
        {
          Point<dim> position;
          for (unsigned int d = 0; d < dim; ++d)
            position[d] = coordinates[d];
          places.push_back({position, position});
        }
      return places;
    }



    /** The first of several faults is the one to tell. */
    void
    add_fault(std::string &fault, const std::string &next)
    {
      if (fault.empty())
        fault = next;
    }
  } // namespace



  template <int dim>
  Output<dim>::Output(const std::string     &directory,
                      const Simulation<dim> &simulation,
                      const OutputProgress  *progress)
    : directory(directory)
    , parameters(simulation.parameters().output)
    , end_time(simulation.parameters().time.end_time)
    , communicator(simulation.discretization().communicator())
    , is_writer(Utilities::MPI::this_mpi_process(communicator) == 0)
    , units(simulation.parameters())
    , field_output(directory, simulation.body())
    , probes(probe_places<dim>(simulation.parameters()))
    , probe_values(simulation.scene(), simulation.discretization(), probes)
    , contact_file("contact.csv", contact_columns(simulation.scene()), units)
    , poincare_file("poincare.csv",
                    contact_columns(simulation.scene()),
                    units,
                    contact_file.name)
    , boundaries_file("boundaries.csv",
                      boundary_columns(simulation.scene()),
                      units)
    , events_file("events.csv", event_columns(simulation.scene()), units)
    , steps_file("steps.csv", attempt_columns(), units)
    , probes_file("probes.csv", probe_columns(probes.size()), units)
    , of_fields{parameters.fields_interval}
    , of_contact{parameters.contact_interval}
    , of_space_time{parameters.space_time_interval}
    , of_period{parameters.period}
    , tables{{contact_file.name, &contact_file.file},
             {events_file.name, &events_file.file},
             {steps_file.name, &steps_file.file},
             {poincare_file.name, &poincare_file.file},
             {boundaries_file.name, &boundaries_file.file},
             {probes_file.name, &probes_file.file}}
  {
    field_timer.reset();
    if (simulation.scene().row.is_given())
      for (const std::string &name : simulation.scene().row.contact_names())
        {
          row_files.push_back(
            std::make_unique<CsvFile<ContactRecord>>("contacts/" + name +
                                                       ".csv",
                                                     columns_of_row_contact(),
                                                     units,
                                                     "contacts/*.csv"));
          tables[row_files.back()->name] = &row_files.back()->file;
        }
    if (progress)
      sizes = progress->sizes;
    if (parameters.space_time_interval > 0.)
      {
        space_time_output =
          std::make_unique<SpaceTimeOutput<dim>>(directory, simulation.body());
        tables["space-time.columns"] = &space_time_output->file();
      }
    if (is_writer)
      open_tables(simulation);
    flush();
    if (progress)
      restore(*progress, simulation);
  }



  template <int dim>
  bool
  Output<dim>::Multiples::are_reached(const double time)
  {
    if (interval == 0.)
      return false;
    const double count = whole_intervals(interval, time);
    if (count < next)
      return false;
    next = count + 1.;
    return true;
  }



  template <int dim>
  void
  Output<dim>::open_tables(const Simulation<dim> &simulation)
  {
    const TimeParameters &time = simulation.parameters().time;
    const std::string     head = csv_comments(simulation.parameters().title);
    const auto open = [&](auto &file, const std::string &places = "") {
      file.open(directory, head + places, sizes[file.name]);
    };
    open(contact_file);
    open(events_file);
    if (!row_files.empty())
      {
        std::error_code error; // a fault shows when a file is opened
        std::filesystem::create_directory(directory + "/contacts", error);
      }
    for (const auto &file : row_files)
      open(*file);
    if (time.has_error_control() || time.locates_contact_events())
      open(steps_file);
    if (parameters.period > 0.)
      open(poincare_file);
    if (parameters.boundaries)
      open(boundaries_file);
    if (!probes.empty())
      open(probes_file, probe_comments(simulation.parameters()));
    if (space_time_output)
      space_time_output->open(sizes["space-time.columns"]);
    if (parameters.fields_interval > 0.)
      {
        std::error_code error; // a fault shows when the first file is opened
        std::filesystem::create_directory(directory + "/fields", error);
      }
  }



  template <int dim>
  void
  Output<dim>::restore(const OutputProgress  &progress,
                       const Simulation<dim> &simulation)
  {
    n_written_events = simulation.events().size();
    if (is_writer)
      for (const char *name : {"summary.json", "space-time.vtu"})
        {
          std::error_code error; // they tell of the earlier end
          std::filesystem::remove(directory + "/" + name, error);
        }
    // The state that is restored has been seen: the next multiples are due.
    for (Multiples *multiples :
         {&of_fields, &of_contact, &of_space_time, &of_period})
      multiples->are_reached(simulation.record().time);
    field_output.restore(progress.snapshot_times);
  }



  template <int dim>
  bool
  Output<dim>::is_due(Multiples &multiples, const double time) const
  {
    return multiples.are_reached(time) || time >= end_time;
  }



  template <int dim>
  void
  Output<dim>::observe(const Simulation<dim> &simulation)
  {
    const StepRecord &record = simulation.record();
    if (parameters.contact_interval == 0. || is_due(of_contact, record.time))
      {
        contact_file.add(record);
        if (parameters.boundaries)
          boundaries_file.add(record);
        for (unsigned int i = 0; i < row_files.size(); ++i)
          row_files[i]->add(record.contacts[i]);
        if (!probes.empty())
          probes_file.add(
            {record.time, probe_values.evaluate(simulation.state())});
      }
    if (of_period.are_reached(record.time)) // steps end there: none is missed
      poincare_file.add(record);
    const auto &events           = simulation.events();
    const bool  is_first_contact = n_written_events == 0 && !events.empty();
    for (unsigned int &i = n_written_events; i < events.size(); ++i)
      events_file.add({events[i], duration_of_contact(events, i)});
    for (const StepAttempt &attempt : simulation.history().attempts)
      steps_file.add(attempt);
    if (space_time_output && is_due(of_space_time, record.time))
      space_time_output->write(simulation.state());

    if (parameters.fields_interval > 0. &&
        (is_due(of_fields, record.time) || is_first_contact))
      {
        field_timer.start();
        flush();
        field_output.write(simulation.state());
        field_timer.stop();
      }
    else if (++n_rows % rows_between_checks == 0)
      flush();
    else if (Utilities::MPI::n_mpi_processes(communicator) == 1 &&
             since_flush.wall_time() > 1.)
      flush();
    else if (is_writer && since_flush.wall_time() > 1.)
      {
        flush_tables(); // a fault shows when all ranks meet
        field_output.write_lists(true);
        since_flush.restart();
      }
  }



  template <int dim>
  void
  Output<dim>::observe_failure(const Simulation<dim> &simulation)
  {
    // attempts of a step that was accepted have been written
    const auto &attempts = simulation.history().attempts;
    if (!attempts.empty() && !attempts.back().is_accepted)
      for (const StepAttempt &attempt : attempts)
        steps_file.add(attempt);
    flush_tables();
    field_output.write_lists();
    if (is_writer && space_time_output)
      space_time_output->write_vtu(false);
  }



  template <int dim>
  void
  Output<dim>::finish()
  {
    flush();
    throw_everywhere<ComputationError>(field_output.write_lists(),
                                       communicator);
    if (!space_time_output)
      return;
    field_timer.start();
    throw_everywhere<ComputationError>(
      is_writer ? space_time_output->write_vtu(true) : "", communicator);
    field_timer.stop();
  }



  template <int dim>
  OutputProgress
  Output<dim>::sync()
  {
    OutputProgress progress;
    std::string    fault = field_output.sync();
    if (is_writer)
      {
        add_fault(fault, field_output.write_lists());
        for (const auto &[name, file] : tables)
          if (file->is_open())
            {
              add_fault(fault, file->sync());
              sizes[name] = file->size();
            }
        progress.sizes          = sizes;
        progress.snapshot_times = field_output.times();
      }
    throw_everywhere<ComputationError>(fault, communicator);
    return progress;
  }



  template <int dim>
  std::string
  Output<dim>::flush_tables()
  {
    std::string fault;
    for (const auto &[name, file] : tables)
      add_fault(fault, file->flush());
    return fault;
  }



  template <int dim>
  void
  Output<dim>::flush()
  {
    std::string fault;
    if (is_writer)
      {
        since_flush.restart();
        fault = flush_tables();
        add_fault(fault, field_output.write_lists(true));
      }
    throw_everywhere<ComputationError>(fault, communicator);
  }



  template class Output<1>;
  template class Output<2>;
  template class Output<3>;
} // namespace ThermoContact
