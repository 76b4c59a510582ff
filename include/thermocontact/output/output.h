// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_output_h
#define thermocontact_output_output_h

#include <thermocontact/output/csv_file.h>
#include <thermocontact/output/csv_rows.h>
#include <thermocontact/output/field_output.h>
#include <thermocontact/output/space_time_output.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/timer.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** How far the files of a run have been written; for checkpoints. */
  struct OutputProgress
  {
    std::map<std::string, std::uint64_t> sizes; ///< of tables by name, in bytes
    std::vector<double>                  snapshot_times;
  };



  /**
   * The files of one run that grow with time: contact.csv, events.csv,
   * steps.csv, probes.csv, poincare.csv, the snapshots and the space-time file.
   * An observer of a Simulation. Rows and snapshots are written at step ends, a
   * snapshot also at the first contact.
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
     * Writes the rows and files that are due at the present state of @p simulation.
     *
     * @throw ComputationError naming a file that cannot be written; earlier
     *   files stay readable
     */
    void
    observe(const Simulation<dim> &simulation);

    /** Seconds spent in snapshots and in space-time.vtu. */
    double
    output_seconds() const
    {
      return field_timer.wall_time();
    }

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
     * Makes all that is written survive a loss of power and tells how far that
     * is; on rank 0. Collective, same exceptions as observe().
     */
    OutputProgress
    sync();

  private:
    /** The multiples of an interval, at which something is written. */
    struct Multiples
    {
      const double interval;  ///< 0: there are none
      double       next = 0.; ///< in intervals

      /** True if @p time is the first one at or after the next multiple. */
      bool
      are_reached(const double time);
    };

    const std::string                                    directory;
    const OutputParameters                               parameters;
    const double                                         end_time;
    const MPI_Comm                                       communicator;
    const bool                                           is_writer;
    const OutputUnits                                    units;
    FieldOutput<dim>                                     field_output;
    Timer                                                field_timer;
    Timer                                                since_flush;
    const std::vector<Place<dim>>                        probes;
    PointValues<dim>                                     probe_values;
    CsvFile<StepRecord>                                  contact_file;
    CsvFile<StepRecord>                                  poincare_file;
    CsvFile<StepRecord>                                  boundaries_file;
    CsvFile<EventRow>                                    events_file;
    CsvFile<StepAttempt>                                 steps_file;
    CsvFile<ProbeRow>                                    probes_file;
    std::vector<std::unique_ptr<CsvFile<ContactRecord>>> row_files;
    std::unique_ptr<SpaceTimeOutput<dim>> space_time_output; ///< if asked for
    unsigned int                          n_written_events = 0;
    unsigned int                          n_rows           = 0;
    Multiples                             of_fields;
    Multiples                             of_contact;
    Multiples                             of_space_time;
    Multiples                             of_period;

    /** All tables of the run by name; not open if they are not asked for. */
    std::map<std::string, TableFile *> tables;

    /**
     * As in OutputProgress; also of tables that an earlier part of the run has
     * left and that this one does not write.
     */
    std::map<std::string, std::uint64_t> sizes;

    /** Opens the tables that are asked for; on one rank. */
    void
    open_tables(const Simulation<dim> &simulation);

    void
    restore(const OutputProgress &progress, const Simulation<dim> &simulation);

    /** On one rank; returns the first fault, or nothing. */
    std::string
    flush_tables();

    bool
    is_due(Multiples &multiples, const double time) const;
  };
} // namespace ThermoContact

#endif
