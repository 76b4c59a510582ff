// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective_errors.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/multiples.h>
#include <thermocontact/output/csv_rows.h>
#include <thermocontact/output/output.h>
#include <thermocontact/output/output_directory.h>

#include <filesystem>

namespace ThermoContact
{
  namespace
  {
    /** Rows after which a fault of the file is looked for on all ranks. */
    constexpr unsigned int rows_between_checks = 1000;
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
    , columns(contact_columns(simulation.scene()))
    , contact_units(units.of_columns("contact.csv", columns))
    , event_table(event_columns(simulation.scene().contact.is_two_sided()))
    , event_units(units.of_columns("events.csv", event_table))
    , attempt_units(units.of_columns("steps.csv", attempt_columns()))
    , field_output(directory, simulation.body())
    , has_attempts(simulation.parameters().time.has_error_control() ||
                   simulation.parameters().time.locates_contact_events())
    , n_written_events(0)
    , n_rows(0)
    , next_fields(0.)
    , next_contact(0.)
    , next_space_time(0.)
    , next_period(0.)
  {
    field_timer.reset();
    const OutputProgress sizes = progress ? *progress : OutputProgress();
    const std::string    head  = csv_comments(simulation.parameters().title);
    open(contact_file,
         "contact.csv",
         head + csv_head(columns, contact_units),
         sizes.contact_size);
    open(events_file,
         "events.csv",
         head + csv_head(event_table, event_units),
         sizes.events_size);
    if (has_attempts)
      open(steps_file,
           "steps.csv",
           head + csv_head(attempt_columns(), attempt_units),
           sizes.steps_size);
    if (is_writer && parameters.fields_interval > 0.)
      {
        std::error_code error; // a fault shows when the first file is opened
        std::filesystem::create_directory(directory + "/fields", error);
      }
    open_optional(sizes, simulation);
    flush();
    if (progress)
      restore(*progress, simulation);
  }



  template <int dim>
  void
  Output<dim>::open(TableFile          &file,
                    const std::string  &name,
                    const std::string  &head,
                    const std::uint64_t size)
  {
    if (!is_writer)
      return;
    if (size > 0)
      return file.reopen(directory + "/" + name, size);
    file.open(directory + "/" + name);
    file.write_row(head);
  }



  template <int dim>
  void
  Output<dim>::open_optional(const OutputProgress  &sizes,
                             const Simulation<dim> &simulation)
  {
    const Body<dim> &body = simulation.body();
    if (!Utilities::trim(parameters.probes).empty())
      {
        probe_output = std::make_unique<ProbeOutput<dim>>(directory, body);
        probe_output->open(csv_comments(simulation.parameters().title),
                           sizes.probes_size);
      }
    if (parameters.space_time_interval > 0.)
      {
        space_time_output =
          std::make_unique<SpaceTimeOutput<dim>>(directory, body);
        space_time_output->open(sizes.space_time_size);
      }
    else
      unused_space_time_size = sizes.space_time_size;
    if (parameters.period > 0.)
      open(poincare_file,
           "poincare.csv",
           csv_comments(simulation.parameters().title) +
             csv_head(columns, contact_units),
           sizes.poincare_size);
    else
      unused_poincare_size = sizes.poincare_size;
  }



  template <int dim>
  std::vector<TableFile *>
  Output<dim>::tables()
  {
    std::vector<TableFile *> files = {&contact_file,
                                      &events_file,
                                      &steps_file,
                                      &poincare_file};
    if (probe_output)
      files.push_back(&probe_output->file());
    if (space_time_output)
      files.push_back(&space_time_output->file());
    return files;
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
    const double                      time        = simulation.record().time;
    const std::pair<double, double *> multiples[] = {
      {parameters.fields_interval, &next_fields},
      {parameters.contact_interval, &next_contact},
      {parameters.space_time_interval, &next_space_time},
      {parameters.period, &next_period}};
    for (const auto &[interval, next] : multiples)
      if (interval > 0.)
        *next = whole_intervals(interval, time) + 1.;
    field_output.restore(progress.snapshot_times);
  }



  template <int dim>
  bool
  Output<dim>::is_due(const double interval,
                      const double time,
                      double      &next) const
  {
    const double count = whole_intervals(interval, time);
    if (count < next && time < end_time)
      return false;
    next = count + 1.;
    return true;
  }



  template <int dim>
  void
  Output<dim>::observe(const Simulation<dim> &simulation)
  {
    const StepRecord &record = simulation.record();
    if (parameters.contact_interval == 0. ||
        is_due(parameters.contact_interval, record.time, next_contact))
      {
        if (is_writer)
          add_row(columns, record, contact_file, contact_units);
        if (probe_output)
          probe_output->write(simulation.state());
      }
    write_period(record);
    write_events(simulation.events());
    write_attempts(simulation.history().attempts);
    if (space_time_output &&
        is_due(parameters.space_time_interval, record.time, next_space_time))
      space_time_output->write(simulation.state());

    if (parameters.fields_interval > 0. &&
        is_due(parameters.fields_interval, record.time, next_fields))
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
        for (TableFile *file : tables())
          file->flush(); // a fault shows when all ranks meet
        field_output.write_lists(true);
        since_flush.restart();
      }
  }



  template <int dim>
  void
  Output<dim>::write_events(const std::vector<ContactEvent> &events)
  {
    for (; n_written_events < events.size(); ++n_written_events)
      add_row(event_table,
              EventRow(events[n_written_events],
                       n_written_events > 0 ? &events[n_written_events - 1] :
                                              nullptr),
              events_file,
              event_units);
  }



  template <int dim>
  void
  Output<dim>::write_period(const StepRecord &record)
  {
    if (parameters.period == 0.)
      return;
    const double count = whole_intervals(parameters.period, record.time);
    if (count < next_period)
      return;
    next_period = count + 1.; // steps end there: none is missed
    if (is_writer)
      add_row(columns, record, poincare_file, contact_units);
  }



  template <int dim>
  void
  Output<dim>::write_attempts(const std::vector<StepAttempt> &attempts)
  {
    if (!is_writer || !has_attempts)
      return; // do not format what goes nowhere
    for (const StepAttempt &attempt : attempts)
      add_row(attempt_columns(), attempt, steps_file, attempt_units);
  }



  template <int dim>
  void
  Output<dim>::observe_failure(const Simulation<dim> &simulation)
  {
    // those of a step that was accepted have been written
    if (!simulation.history().attempts.empty() &&
        !simulation.history().attempts.back().is_accepted)
      write_attempts(simulation.history().attempts);
    for (TableFile *file : tables())
      file->flush();
    field_output.write_lists();
    if (space_time_output)
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
    throw_everywhere<ComputationError>(space_time_output->write_vtu(true),
                                       communicator);
    field_timer.stop();
  }



  template <int dim>
  double
  Output<dim>::output_seconds() const
  {
    return field_timer.wall_time();
  }



  template <int dim>
  OutputProgress
  Output<dim>::sync()
  {
    OutputProgress progress;
    std::string    fault = field_output.sync();
    if (is_writer)
      {
        if (const std::string message = field_output.write_lists();
            fault.empty())
          fault = message;
        for (TableFile *file : tables())
          if (const std::string message = file->sync(); fault.empty())
            fault = message;
        progress.contact_size = contact_file.size();
        progress.events_size  = events_file.size();
        progress.steps_size   = steps_file.size();
        if (probe_output)
          progress.probes_size = probe_output->file().size();
        progress.space_time_size = space_time_output ?
                                     space_time_output->file().size() :
                                     unused_space_time_size;
        progress.poincare_size =
          parameters.period > 0. ? poincare_file.size() : unused_poincare_size;
        progress.snapshot_times = field_output.times();
      }
    throw_everywhere<ComputationError>(fault, communicator);
    return progress;
  }



  template <int dim>
  void
  Output<dim>::flush()
  {
    std::string fault;
    if (is_writer)
      {
        since_flush.restart();
        for (TableFile *file : tables())
          if (const std::string message = file->flush(); fault.empty())
            fault = message;
        if (const std::string message = field_output.write_lists(true);
            fault.empty())
          fault = message;
      }
    throw_everywhere<ComputationError>(fault, communicator);
  }



  template class Output<1>;
  template class Output<2>;
  template class Output<3>;
} // namespace ThermoContact
