// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/study/study.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Tells how far a study is, on rank 0: from the rows of its table. */
    class StudyProgress
    {
    public:
      StudyProgress(StudyTable &table, Log &log)
        : table(table)
        , log(log)
        , n_before(table.size())
      {}

      /** Reads on, and tells of the runs that have ended since. */
      void
      update()
      {
        const unsigned int n_runs  = table.plan.n_runs();
        const unsigned int n_known = table.size();
        for (const unsigned int run : table.read_on())
          if (const std::string failure = table.failure(run); !failure.empty())
            log.line("  " + table.plan.description(run) + ": " + failure);
        if (table.size() == n_known)
          return;
        const double left = since_start.wall_time() /
                            (table.size() - n_before) * (n_runs - table.size());
        const std::string line = text(
          "  run ", table.size(), '/', n_runs, "  ", clock_time(left), " left");
        log.live_line(line);
        if (10 * table.size() / n_runs != 10 * n_known / n_runs)
          log.milestone(line);
      }

    private:
      StudyTable        &table;
      Log               &log;
      const Timer        since_start;
      const unsigned int n_before;
    };



    /** Runs the reference on the last rank and hands it to all. */
    Trajectory
    run_reference(const StudyPlan &plan, StudyRunner &runner)
    {
      const MPI_Comm     communicator = MPI_COMM_WORLD;
      const unsigned int last =
        Utilities::MPI::n_mpi_processes(communicator) - 1;
      std::pair<std::string, Trajectory> result;
      if (Utilities::MPI::this_mpi_process(communicator) == last)
        try
          {
            StudyRun run = runner.execute(*plan.reference, 1, "");
            result       = {run.failure, std::move(run.trajectory)};
          }
        catch (const Interruption &)
          {} // all ranks ask for signals next
      result = broadcast(communicator, result, last);
      if (!result.first.empty())
        throw ComputationError("Study/Reference: the run failed: " +
                               result.first);
      return result.second;
    }



    /**
     * The fault that rows have been lost, as where several ranks append to a
     * file of another machine, or nothing.
     */
    std::string
    missing_rows(const StudyTable &table)
    {
      const unsigned int n_lost = table.plan.n_runs() - table.size();
      return n_lost == 0 ? "" :
                           text("study.csv: the rows of ",
                                n_lost,
                                " runs that have ended are not there\n  "
                                "remedy:  go on with --resume; on ranks that "
                                "share one machine, or with an "
                                "Output/Directory that locks its files");
    }
  } // namespace



  void
  run_study(const StudyParameters &parameters,
            const std::string     &directory,
            StudyTable            &table,
            Log                   &log)
  {
    const MPI_Comm     communicator = MPI_COMM_WORLD;
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const StudyPlan   &plan    = table.plan;
    const SignalWatch  signals;
    StudyRunner        runner(plan, signals);

    const std::vector<unsigned int> missing = table.missing_runs();
    Trajectory                      reference;
    if (plan.reference && !missing.empty())
      reference = run_reference(plan, runner);
    StudyProgress progress(table, log);

    std::string fault;
    const bool  has_begun =
      Utilities::MPI::max(signals.signal(), communicator) == 0;
    for (unsigned int i = rank; has_begun && i < missing.size() &&
                                fault.empty() && signals.signal() == 0;
         i += n_ranks)
      try
        {
          const unsigned int number = missing[i];
          StudyRun           run    = runner.execute(plan.overrides(number),
                                        parameters.repetitions,
                                        parameters.keep_files ?
                                                       text(directory, "/run-", number) :
                                                       "");
          if (plan.reference && run.failure.empty())
            run.error = run.trajectory.compare(reference);
          fault = table.append(number, run);
          if (rank == 0)
            progress.update();
        }
      catch (const Interruption &)
        {}
      catch (const InputError &error)
        {
          fault = error.what(); // of the table, changed by somebody else
        }

    fault            = first_fault(fault, communicator); // all rows are written
    const int signal = Utilities::MPI::max(signals.signal(), communicator);
    if (fault.empty() && rank == 0)
      try
        {
          progress.update();
          if (signal == 0)
            fault = missing_rows(table);
        }
      catch (const InputError &error)
        {
          fault = error.what();
        }
    fault = first_fault(fault, communicator);
    if (!fault.empty())
      throw ComputationError(fault);
    if (signal != 0)
      throw Interruption(text(name_of_signal(signal),
                              ": ",
                              broadcast(communicator, table.size()),
                              " of ",
                              plan.n_runs(),
                              " runs have ended and have their rows"));
    throw_everywhere<ComputationError>(rank == 0 ? table.sort() : "",
                                       communicator);
  }
} // namespace ThermoContact
