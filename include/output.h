// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_h
#define thermocontact_output_h

#include <deal.II/base/timer.h>

#include <fstream>
#include <string>

#include "field_output.h"
#include "simulation.h"

namespace ThermoContact
{
  /**
   * The files of one run that grow with time: contact.csv, events.csv,
   * steps.csv and the snapshots. An observer of a Simulation. Rows and
   * snapshots are written at step ends.
   */
  template <int dim>
  class Output
  {
  public:
    /**
     * Opens the files in @p directory, which has been prepared.
     *
     * @throw ComputationError naming a file that cannot be opened
     */
    Output(const std::string &directory, const Simulation<dim> &simulation);

    /**
     * Writes what is due at the present state of @p simulation.
     *
     * @throw ComputationError naming a file that cannot be written; what was
     *   written before stays readable
     */
    void
    observe(const Simulation<dim> &simulation);

    /** Seconds spent in snapshots. */
    double
    output_seconds() const;

    /** Writes the attempts at the step that a run has failed at, if it can. */
    void
    observe_failure(const Simulation<dim> &simulation);

    /** Flushes all files; same exceptions as observe(). */
    void
    flush();

  private:
    const std::string      directory;
    const OutputParameters parameters;
    const double           end_time;
    const MPI_Comm         communicator;
    const bool             is_writer;
    FieldOutput<dim>       field_output;
    Timer                  field_timer;
    Timer                  since_flush;
    std::ofstream          contact_file;
    std::ofstream          events_file;
    std::ofstream          steps_file;
    const bool             has_attempts; ///< steps that can be rejected
    unsigned int           n_written_events;
    unsigned int           n_rows;
    double                 next_fields;  ///< in intervals
    double                 next_contact; ///< in intervals

    void
    open(std::ofstream     &file,
         const std::string &name,
         const std::string &title,
         const std::string &columns);

    void
    write_row(const StepRecord &record);

    void
    write_events(const std::vector<ContactEvent> &events);

    void
    write_attempts(const std::vector<StepAttempt> &attempts);

    bool
    is_due(const double interval, const double time, double &next) const;
  };
} // namespace ThermoContact

#endif
