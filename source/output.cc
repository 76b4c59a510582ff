// SPDX-License-Identifier: LGPL-2.1-or-later

#include "output.h"

#include <deal.II/base/revision.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "exceptions.h"
#include "output_directory.h"
#include "version.h"

namespace ThermoContact
{
  namespace
  {
    const char *const contact_columns =
      "step,time,step_size,displacement_end,displacement_mid,velocity_end,"
      "stress_end,gap,penetration,contact_force,contact_impulse,"
      "temperature_end,heat_flux_end,energy,dissipation,numerical_dissipation,"
      "in_contact,iterations,work,temperature_mean";

    const char *const step_columns =
      "time,step_size,error,accepted,reason,wall_seconds";

    const char *const event_columns = "time,kind,velocity";

    /** Rows after which a fault of the file is looked for on all ranks. */
    constexpr unsigned int rows_between_checks = 1000;
  } // namespace



  template <int dim>
  Output<dim>::Output(const std::string     &directory,
                      const Simulation<dim> &simulation)
    : directory(directory)
    , parameters(simulation.parameters().output)
    , end_time(simulation.parameters().time.end_time)
    , communicator(simulation.discretization().communicator())
    , is_writer(Utilities::MPI::this_mpi_process(communicator) == 0)
    , field_output(directory,
                   simulation.parameters(),
                   simulation.discretization())
    , has_attempts(simulation.parameters().time.has_error_control() ||
                   simulation.parameters().time.locates_contact_events())
    , n_written_events(0)
    , n_rows(0)
    , next_fields(0.)
    , next_contact(0.)
  {
    field_timer.reset();
    const std::string &title = simulation.parameters().title;
    open(contact_file, "contact.csv", title, contact_columns);
    open(events_file, "events.csv", title, event_columns);
    if (has_attempts)
      open(steps_file, "steps.csv", title, step_columns);
    if (is_writer && parameters.fields_interval > 0.)
      {
        std::error_code error; // a fault shows when the first file is opened
        std::filesystem::create_directory(directory + "/fields", error);
      }
    flush();
  }



  template <int dim>
  void
  Output<dim>::open(std::ofstream     &file,
                    const std::string &name,
                    const std::string &title,
                    const std::string &columns)
  {
    if (!is_writer)
      return;
    file.open(directory + "/" + name);
    file << "# " << title << "\n# thermocontact " << version() << ", deal.II "
         << DEAL_II_PACKAGE_VERSION << '\n'
         << columns << '\n';
  }



  template <int dim>
  bool
  Output<dim>::is_due(const double interval,
                      const double time,
                      double      &next) const
  {
    // Times are multiples of the step up to rounding, so that a multiple of
    // the interval may be missed by a hair.
    const double slack = 1e-9 + 4e-16 * time / interval;
    const double count = std::floor(time / interval + slack);
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
      write_row(record);
    write_events(simulation.events());
    write_attempts(simulation.attempts());

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
    else if (is_writer && since_flush.wall_time() > 1.)
      {
        contact_file.flush();
        events_file.flush();
        steps_file.flush();
        since_flush.restart();
      }
  }



  template <int dim>
  void
  Output<dim>::write_row(const StepRecord &r)
  {
    if (!is_writer)
      return;
    char      row[640];
    const int length = std::snprintf(
      row,
      sizeof(row),
      "%u,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,"
      "%.17g,%.17g,%.17g,%.17g,%d,%u,%.17g,%.17g\n",
      r.step,
      r.time,
      r.step_size,
      r.displacement_end,
      r.displacement_mid,
      r.velocity_end,
      r.stress_end,
      r.gap,
      r.penetration,
      r.contact_force,
      r.contact_impulse,
      r.temperature_end,
      r.heat_flux_end,
      r.energy,
      r.dissipation,
      r.numerical_dissipation,
      r.in_contact ? 1 : 0,
      r.iterations,
      r.work,
      r.temperature_mean);
    contact_file.write(row, length);
  }



  template <int dim>
  void
  Output<dim>::write_events(const std::vector<ContactEvent> &events)
  {
    for (; n_written_events < events.size(); ++n_written_events)
      if (is_writer)
        {
          const ContactEvent &event = events[n_written_events];
          char                row[80];
          std::snprintf(row,
                        sizeof(row),
                        "%.17g,%s,%.17g\n",
                        event.time,
                        event.kind == ContactEvent::begin ? "begin" : "end",
                        event.velocity);
          events_file << row;
        }
  }



  template <int dim>
  void
  Output<dim>::write_attempts(const std::vector<StepAttempt> &attempts)
  {
    if (!is_writer || !has_attempts)
      return;
    for (const StepAttempt &a : attempts)
      {
        char      row[160];
        const int length = std::snprintf(row,
                                         sizeof(row),
                                         "%.17g,%.17g,%.6g,%d,%s,%.6g\n",
                                         a.time,
                                         a.size,
                                         a.error,
                                         a.is_accepted ? 1 : 0,
                                         a.reason,
                                         a.wall_seconds);
        steps_file.write(row, length);
      }
  }



  template <int dim>
  void
  Output<dim>::observe_failure(const Simulation<dim> &simulation)
  {
    write_attempts(simulation.attempts());
    contact_file.flush();
    events_file.flush();
    steps_file.flush();
  }



  template <int dim>
  double
  Output<dim>::output_seconds() const
  {
    return field_timer.wall_time();
  }



  template <int dim>
  void
  Output<dim>::flush()
  {
    std::string fault;
    if (is_writer)
      {
        contact_file.flush();
        events_file.flush();
        steps_file.flush();
        since_flush.restart();
        for (const auto &[file, name] :
             {std::make_pair(&contact_file, "contact.csv"),
              std::make_pair(&events_file, "events.csv"),
              std::make_pair(&steps_file, "steps.csv")})
          if (file->is_open() && !*file)
            fault = directory + "/" + name +
                    ": cannot be written\n  remedy:  check free space and "
                    "rights, or give another Output/Directory";
      }
    throw_everywhere<ComputationError>(fault, communicator);
  }



  template class Output<1>;
  template class Output<2>;
  template class Output<3>;
} // namespace ThermoContact
