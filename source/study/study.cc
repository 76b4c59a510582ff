// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/study/study.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** "run 3: Contact/Gap = 0.1, Mesh/Cells = 4" */
    std::string
    describe_run(const StudyPlan &plan, const unsigned int run)
    {
      std::string line  = text("run ", run, ": ");
      const char *comma = "";
      for (const auto &[path, value] : plan.overrides(run))
        {
          line += comma + path + " = " + value;
          comma = ", ";
        }
      return line;
    }



    /** Tells how far a study is, on rank 0: from the rows of its table. */
    class StudyProgress
    {
    public:
      StudyProgress(StudyTable &table, Log &log)
        : table(table)
        , log(log)
        , start(std::chrono::steady_clock::now())
        , n_before(table.size())
      {}

      /** Reads on, and tells of the runs that have ended since. */
      void
      update()
      {
        const unsigned int n_runs  = table.plan().n_runs();
        const unsigned int n_known = table.size();
        for (const unsigned int run : table.read_on())
          if (const std::string failure = table.failure(run); !failure.empty())
            log.line("  " + describe_run(table.plan(), run) + ": " + failure);
        if (table.size() == n_known)
          return;
        const double seconds = std::chrono::duration<double>(
                                 std::chrono::steady_clock::now() - start)
                                 .count();
        const double left =
          seconds / (table.size() - n_before) * (n_runs - table.size());
        const std::string line = text(
          "  run ", table.size(), '/', n_runs, "  ", clock_time(left), " left");
        if (log.has_live_line())
          log.live_line(line);
        if (10 * table.size() / n_runs == 10 * n_known / n_runs)
          return;
        if (log.has_live_line())
          log.file_line(line);
        else
          log.line(line);
      }

    private:
      StudyTable                                 &table;
      Log                                        &log;
      const std::chrono::steady_clock::time_point start;
      const unsigned int                          n_before;
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
            StudyRun run = runner.execute(*plan.reference(), 1, "");
            result       = {run.failure, std::move(run.trajectory)};
          }
        catch (const Interruption &)
          {} // all ranks ask for signals next
      result = Utilities::MPI::broadcast(communicator, result, last);
      if (!result.first.empty())
        throw ComputationError("Study/Reference: the run failed: " +
                               result.first);
      return result.second;
    }



    /** The runs that have no row yet, the same on all ranks. */
    std::vector<unsigned int>
    missing_runs(const StudyTable &table)
    {
      std::vector<unsigned int> runs;
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        for (unsigned int run = 0; run < table.plan().n_runs(); ++run)
          if (!table.has(run))
            runs.push_back(run);
      return Utilities::MPI::broadcast(MPI_COMM_WORLD, runs);
    }



    /** The first message that is not empty, of all ranks. */
    std::string
    first_fault(const std::string &fault)
    {
      for (const std::string &any :
           Utilities::MPI::all_gather(MPI_COMM_WORLD, fault))
        if (!any.empty())
          return any;
      return "";
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
    const StudyPlan   &plan    = table.plan();
    const SignalWatch  signals;
    StudyRunner        runner(plan, signals);
    StudyProgress      progress(table, log);

    const std::vector<unsigned int> missing = missing_runs(table);
    Trajectory                      reference;
    if (plan.reference() && !missing.empty())
      reference = run_reference(plan, runner);

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
          if (plan.reference() && run.failure.empty())
            run.error = run.trajectory.compare(reference);
          fault = table.append(number, run);
          if (rank == 0)
            progress.update();
        }
      catch (const Interruption &)
        {}

    fault            = first_fault(fault); // all rows are written then
    const int signal = Utilities::MPI::max(signals.signal(), communicator);
    if (rank == 0)
      progress.update();
    if (!fault.empty())
      throw ComputationError(fault);
    if (signal != 0)
      throw Interruption(
        text(name_of_signal(signal),
             ": ",
             Utilities::MPI::broadcast(communicator, table.size()),
             " of ",
             plan.n_runs(),
             " runs have ended and have their rows"));
    throw_everywhere<ComputationError>(rank == 0 ? table.sort() : "",
                                       communicator);
  }



  void
  check_study(const StudyPlan       &plan,
              const StudyParameters &parameters,
              Log                   &log)
  {
    log.line(text("  study     ",
                  plan.n_runs(),
                  " runs, reference: ",
                  parameters.reference));
    SceneReader        reader(plan.scene_assignments());
    const unsigned int n_checked = std::min(plan.n_runs(), 2000u);
    unsigned int       n_refused = 0, n_known = 0;
    std::string        refused;
    double             steps = 0.;
    for (unsigned int run = 0; run < n_checked; ++run)
      try
        {
          plan.read_scene(plan.overrides(run), reader);
          const Parameters &scene = reader.scene();
          if (const auto cost = expected_cost(Scene(scene), scene.mesh.cells))
            {
              steps += cost->steps;
              ++n_known;
            }
        }
      catch (const InputError &error)
        {
          if (++n_refused <= 3)
            refused += "\n  " + describe_run(plan, run) + ": " + error.what();
        }
    if (n_known > 0)
      log.line(text(
        "  expected  ",
        significant(round_to_digits(steps * parameters.repetitions, 2), 12),
        " steps, about, of ",
        n_known,
        " runs"));
    if (n_checked < plan.n_runs())
      log.line(text("  checked   the first ", n_checked, " runs"));
    if (n_refused > 0)
      throw InputError(text("Study/Vary: ",
                            n_refused,
                            " of ",
                            n_checked,
                            " runs cannot be run",
                            refused,
                            n_refused > 3 ? "\n  and others" : "",
                            "\n  remedy:  leave them out, in sets of their own "
                            "between ';;'"));
  }
} // namespace ThermoContact
