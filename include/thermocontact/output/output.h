// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_output_h
#define thermocontact_output_output_h

#include <thermocontact/base/csv_columns.h>
#include <thermocontact/base/table_file.h>
#include <thermocontact/output/field_output.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/output/probe_output.h>
#include <thermocontact/output/space_time_output.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/timer.h>

#include <string>

namespace ThermoContact
{
  struct EventRow;

  /** How far the files of a run have been written; for checkpoints. */
  struct OutputProgress
  {
    /** Lengths in bytes of the tables; 0 for one that there is not. */
    std::uint64_t contact_size    = 0;
    std::uint64_t events_size     = 0;
    std::uint64_t steps_size      = 0;
    std::uint64_t probes_size     = 0;
    std::uint64_t space_time_size = 0;
    std::uint64_t poincare_size   = 0;

    std::vector<double> snapshot_times;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &contact_size &events_size &steps_size &probes_size
        &space_time_size &poincare_size &snapshot_times;
    }
  };



  /**
   * The files of one run that grow with time: contact.csv, events.csv,
   * steps.csv, probes.csv, poincare.csv, the snapshots and the space-time file.
   * An observer of a Simulation. Rows and snapshots are written at step ends.
   */
  template <int dim>
  class Output
  {
  public:
    /**
     * Opens the files in @p directory, which has been prepared; or goes on with
     * those of an earlier run, from where they were for @p progress, and cuts off
     * what they hold beyond. @p simulation is restored then.
     *
     * @throw ComputationError naming a file that cannot be opened
     */
    Output(const std::string     &directory,
           const Simulation<dim> &simulation,
           const OutputProgress  *progress = nullptr);

    /**
     * Writes what is due at the present state of @p simulation.
     *
     * @throw ComputationError naming a file that cannot be written; what was
     *   written before stays readable
     */
    void
    observe(const Simulation<dim> &simulation);

    /** Seconds spent in snapshots and in space-time.vtu. */
    double
    output_seconds() const;

    /**
     * Completes the files of a run that is done, among them space-time.vtu.
     * Same exceptions as observe().
     */
    void
    finish();

    /**
     * Writes the attempts at the step that a run has failed at, and
     * space-time.vtu up to there, if it can.
     */
    void
    observe_failure(const Simulation<dim> &simulation);

    /** Flushes all files; same exceptions as observe(). */
    void
    flush();

    /**
     * Makes what is written survive a loss of power and tells how far that is;
     * on rank 0. Collective, same exceptions as observe().
     */
    OutputProgress
    sync();

  private:
    const std::string            directory;
    const OutputParameters       parameters;
    const double                 end_time;
    const MPI_Comm               communicator;
    const bool                   is_writer;
    const OutputUnits            units;
    const CsvColumns<StepRecord> columns;       ///< of contact.csv
    const Conversions            contact_units; ///< of its columns
    const CsvColumns<EventRow>  &event_table;   ///< of events.csv
    const Conversions            event_units;
    const Conversions            attempt_units;
    FieldOutput<dim>             field_output;
    Timer                        field_timer;
    Timer                        since_flush;
    TableFile                    contact_file;
    TableFile                    events_file;
    TableFile                    steps_file;
    TableFile                    poincare_file;
    const bool                   has_attempts; ///< steps that can be rejected
    unsigned int                 n_written_events;

    /** Of columns that an earlier part of the run has left, for a later one. */
    std::uint64_t unused_space_time_size = 0;
    std::uint64_t unused_poincare_size   = 0;
    unsigned int  n_rows;
    double        next_fields;  ///< in intervals
    double        next_contact; ///< in intervals
    double        next_space_time;
    double        next_period;

    std::unique_ptr<ProbeOutput<dim>>     probe_output; ///< if asked for
    std::unique_ptr<SpaceTimeOutput<dim>> space_time_output;

    /** All tables of the run; those of other ranks are not open. */
    std::vector<TableFile *>
    tables();

    /** Opens what is written on request. */
    void
    open_optional(const OutputProgress  &sizes,
                  const Simulation<dim> &simulation);

    /**
     * Opens a table.
     *
     * @param head what it begins with
     * @param size of the file so far if a run goes on, else 0
     */
    void
    open(TableFile          &file,
         const std::string  &name,
         const std::string  &head,
         const std::uint64_t size);

    void
    restore(const OutputProgress &progress, const Simulation<dim> &simulation);

    void
    write_events(const std::vector<ContactEvent> &events);

    void
    write_attempts(const std::vector<StepAttempt> &attempts);

    /** The row of poincare.csv, if @p record is at a multiple of the period. */
    void
    write_period(const StepRecord &record);

    bool
    is_due(const double interval, const double time, double &next) const;
  };
} // namespace ThermoContact

#endif
