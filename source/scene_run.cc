// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/interruption.h>
#include <thermocontact/base/machine_memory.h>
#include <thermocontact/base/serial_section.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/version.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/output/checkpoint.h>
#include <thermocontact/output/checkpointer.h>
#include <thermocontact/output/output.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/report/progress.h>
#include <thermocontact/report/result_report.h>
#include <thermocontact/report/scene_report.h>
#include <thermocontact/report/summary.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/scene_run.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/load_scan.h>
#include <thermocontact/space/problem_data.h>
#include <thermocontact/study/error_bars.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

namespace ThermoContact
{
  namespace
  {
    /** @param n_ranks that share the body, of those that are there */
    void
    report_program(const unsigned int n_ranks, Log &log)
    {
      log.line(text("thermocontact ",
                    version(),
                    ", deal.II ",
                    DEAL_II_PACKAGE_VERSION,
                    ", ranks: ",
                    n_ranks));
      if (const unsigned int n =
            Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
          n_ranks < n)
        log.line(text("  ranks     of ",
                      n,
                      " one computes, since more do not help a rod"));
    }



    /** Says where a run goes on. */
    void
    report_resumption(const Checkpoint &checkpoint,
                      const Parameters &parameters,
                      Log              &log)
    {
      log.line(text("  resumed   at t = ",
                    QuantityUnits(parameters).text("time", checkpoint.time),
                    ", step ",
                    checkpoint.step));
      if (!checkpoint.warning.empty())
        log.line("  warning:  " + checkpoint.warning);
      if (checkpoint.version != version())
        log.line("  warning:  the checkpoint is of thermocontact " +
                 checkpoint.version + ": later steps may differ in rounding");
    }



    /** A word that the shell leaves as it is. */
    std::string
    for_shell(const std::string &word)
    {
      if (word.find_first_not_of("abcdefghijklmnopqrstuvwxyz"
                                 "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                 "0123456789_./=+,:@%-") == std::string::npos)
        return word;
      std::string quoted = "'";
      for (const char letter : word)
        quoted +=
          letter == '\'' ? std::string("'\\''") : std::string(1, letter);
      return quoted + "'";
    }



    /** Goes on from a checkpoint, of as many ranks or not. */
    template <int dim>
    void
    restore(Simulation<dim> &simulation, const Checkpoint &checkpoint)
    {
      const MPI_Comm communicator = simulation.discretization().communicator();
      const unsigned int n_ranks  = checkpoint.n_ranks;
      const bool         is_same =
        n_ranks == Utilities::MPI::n_mpi_processes(communicator);
      unsigned int rank =
        is_same ? Utilities::MPI::this_mpi_process(communicator) : 0;
      const unsigned int end = is_same ? rank + 1 : n_ranks;
      simulation.restore(checkpoint.progress, n_ranks, [&](std::string &nodes) {
        if (rank == end)
          return false;
        nodes = read_nodes(checkpoint, rank++);
        return true;
      });
    }



    /**
     * Left on the disk of a directory that may have to be made; infinite where
     * that is not known, as in /proc.
     */
    double
    free_bytes(std::filesystem::path directory)
    {
      std::error_code fault;
      directory = std::filesystem::absolute(directory, fault);
      while (!std::filesystem::exists(directory, fault) &&
             directory.has_relative_path())
        directory = directory.parent_path();
      const auto space = std::filesystem::space(directory, fault);
      return fault || space.capacity == 0 ? infinity : space.available;
    }



    /**
     * Runs a scene that is set up, with all that observes it.
     *
     * @param written of the files if the run goes on from a checkpoint
     */
    template <int dim>
    void
    run_observed(Simulation<dim>                          &simulation,
                 const Forecast                           &forecast,
                 const std::string                        &directory,
                 const std::map<std::string, std::string> &entries,
                 const OutputProgress                     *written,
                 const Timer                              &since_start,
                 Log                                      &log)
    {
      const Scene      &scene   = simulation.scene();
      const RunHistory &history = simulation.history();
      Output<dim>       output(directory, simulation, written);
      Checkpointer<dim> checkpointer(directory, entries, simulation, output);
      Progress          progress(scene, history, log);
      unsigned int      n_reported     = history.warnings.size();
      const double      initial_energy = starting_energy(history.record);

      RunTimes times;
      times.set_up            = since_start.wall_time();
      const auto finish_times = [&]() {
        times.output = output.output_seconds() + checkpointer.seconds();
        times.wall   = since_start.wall_time();
        times.loop   = times.wall - times.set_up - times.output - times.repeats;
      };
      const auto write_end_summary = [&](const std::string &status,
                                         const KeyErrors   *errors = nullptr) {
        write_summary(directory + "/summary.json",
                      status,
                      simulation,
                      forecast,
                      times,
                      errors);
      };
      std::optional<KeyErrors> errors;
      try
        {
          simulation.run(
            {[&](const Simulation<dim> &s) { output.observe(s); },
             [&](const Simulation<dim> &) {
               n_reported = report_warnings(history.warnings, n_reported, log);
               progress.observe(history);
               for (const StepAttempt &attempt : history.attempts)
                 times.steps += attempt.wall_seconds;
             },
             [&](const Simulation<dim> &s) { checkpointer.observe(s); }});
          output.finish();
          if (scene.parameters.output.has_error_bars)
            {
              // a summary if the repeats come to nothing
              finish_times();
              write_end_summary("done");
              const StopWatch watch(times.repeats);
              errors = error_bars<dim>(
                simulation,
                [&]() { checkpointer.observe_signal(simulation); },
                log);
            }
        }
      catch (const ComputationError &error)
        {
          finish_times();
          output.observe_failure(simulation);
          const std::string status =
            dynamic_cast<const Interruption *>(&error) != nullptr ?
              "interrupted" :
              "failed";
          log.failure("  " + status + ":  " + error.what());
          try
            {
              write_end_summary(status + ": " + error.what());
            }
          catch (const ComputationError &)
            {} // the first fault is the one to tell, e.g. a full disk
          throw;
        }
      finish_times();
      report_result(scene,
                    forecast,
                    history,
                    simulation.counters(),
                    times,
                    initial_energy,
                    log);
      if (errors)
        report_errors(scene, history, *errors, log);
      write_end_summary("done", errors ? &*errors : nullptr);
    }



    /**
     * A body of more unknowns is not set up by --check: that takes seconds, and
     * its expressions are tried without.
     */
    constexpr double most_unknowns_of_check = 2e4;



    /**
     * Prints the scene and its forecasts before anything is set up.
     *
     * @param is_set_up it will be
     */
    template <int dim>
    Forecast
    report_plan(const Request &request,
                const Scene   &scene,
                const bool     is_set_up,
                const MPI_Comm communicator,
                Log           &log)
    {
      const ProblemData<dim> data(scene); // whose expressions have to be right
      std::vector<std::string> warnings;  // of loads
      const LoadHistory        loads = load_history(scene, data, warnings);
      const Forecast           forecast(scene, loads);
      report_scene(
        scene, loads, forecast, request.assignments, communicator, log);
      if (!is_set_up) // which gives them
        {
          report_warnings(warnings, 0, log);
          log.line("  check     so large a body is not set up: its initial "
                   "state is not checked");
        }
      const bool depends_on_x_alone =
        (!scene.fields.has_displacement || scene.has_rollers) &&
        scene.heat.has_linear_profile() &&
        (!scene.contact.law->is_active() || scene.contact.has_uniform_gap()) &&
        data.is_along_axis() && !scene.has_bodies();
      if (dim > 1 && depends_on_x_alone)
        log.line("  rod       Dimension = 1 has the same solution: nothing "
                 "depends on y or z");
      for (const std::string &doubt : implausible_numbers(request.assignments))
        log.line("  doubt     " + doubt);
      check_cost(forecast.cost,
                 free_bytes(request.output_directory()),
                 request.command.is_forced,
                 log);
      return forecast;
    }
  } // namespace



  Request::Request(const CommandLine             &command,
                   const std::vector<Assignment> &assignments)
    : command(command)
    , assignments(assignments)
  {
    parameters.add_parameters(prm);
    assign_entries(assignments, prm, parameters);
  }



  std::string
  Request::output_directory() const
  {
    if (!parameters.output.directory.empty())
      return parameters.output.directory;
    return command.file_name == "-" ?
             "results/standard-input" :
             "results/" +
               std::filesystem::path(command.file_name).stem().string();
  }



  namespace
  {
    /**
     * The words that started the ranks, with a blank behind them: the words
     * before the program on the command line of the parent process, if that is
     * an mpirun, with the options that the machine needs, as the leave of root.
     */
    std::string
    launcher(const std::string &program, const unsigned int n_ranks)
    {
      std::ifstream file(text("/proc/", getppid(), "/cmdline"));
      std::string   words, first;
      for (std::string word; std::getline(file, word, '\0');)
        {
          if (first.empty())
            first = std::filesystem::path(word).filename();
          if (word == program &&
              (begins_with(first, "mpirun") || begins_with(first, "mpiexec") ||
               begins_with(first, "prterun")))
            return words;
          words += for_shell(word) + ' ';
        }
      return text("mpirun -n ", n_ranks, ' ');
    }
  } // namespace



  std::string
  Request::resume_command(const MPI_Comm communicator) const
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    return (n_ranks > 1 ? launcher(command.program_name, n_ranks) : "") +
           for_shell(command.program_name) + " --resume " +
           for_shell(output_directory() + "/used.prm");
  }



  namespace
  {
    template <int dim>
    void
    run_in(const Request &request,
           const Scene   &scene,
           const Timer   &since_start,
           Log           &log)
    {
      const Parameters  &parameters = request.parameters;
      const CommandLine &command    = request.command;
      const MPI_Comm     communicator =
        DimensionTraits<dim>::communicator(MPI_COMM_WORLD);
      const std::string directory = request.output_directory();
      auto              entries   = entry_values(request.prm);
      for (const ChosenEntry &entry : scene.scheme_choice.entries)
        entries[entry.path] = entry.value;

      std::optional<DirectoryLock> lock;
      std::optional<Checkpoint>    checkpoint;
      if (command.is_resumed)
        {
          lock.emplace(directory, true, communicator);
          checkpoint = read_checkpoint(directory, communicator);
          check_compatibility(
            *checkpoint, directory, entries, parameters, communicator);
        }
      if (dim > 1)
        {
          // all ranks refuse, or none
          const SharedMemory memory = scarcest_memory(communicator);
          check_memory(scene,
                       Utilities::MPI::n_mpi_processes(communicator),
                       memory.bytes,
                       memory.share);
        }
      if (!checkpoint)
        check_output_directory(directory, communicator);
      if (!command.check_only)
        {
          report_program(Utilities::MPI::n_mpi_processes(communicator), log);
          if (checkpoint)
            report_resumption(*checkpoint, parameters, log);
        }
      const bool is_set_up = !command.check_only || dim == 1 ||
                             scene.n_unknowns() <= most_unknowns_of_check;
      const Forecast forecast =
        report_plan<dim>(request, scene, is_set_up, communicator, log);
      if (!is_set_up)
        return;
      Simulation<dim> simulation(scene, communicator);
      if (checkpoint)
        restore(simulation, *checkpoint);
      report_set_up(simulation, since_start.wall_time(), log);
      if (command.check_only)
        return;

      if (!checkpoint)
        {
          lock.emplace(directory, false, communicator);
          prepare_output_directory(directory, communicator);
        }
      else if (Utilities::MPI::this_mpi_process(communicator) == 0)
        keep_as_newest(directory, *checkpoint);
      write_used_parameters(directory,
                            unused_paths(scene),
                            request.prm,
                            request.assignments,
                            scene.scheme_choice,
                            communicator);
      throw_everywhere<ComputationError>(log.open_file(directory + "/log.txt",
                                                       checkpoint.has_value()),
                                         communicator);
      try
        {
          run_observed(simulation,
                       forecast,
                       directory,
                       entries,
                       checkpoint ? &checkpoint->output : nullptr,
                       since_start,
                       log);
        }
      catch (const Interruption &error)
        {
          throw Interruption(error.what() + std::string("\n  resume:  ") +
                             request.resume_command(communicator));
        }
      log.line("  files     " + directory);
    }
  } // namespace



  void
  run_scene(const Request &request,
            const Scene   &scene,
            const Timer   &since_start,
            Log           &log)
  {
    switch (request.parameters.dimension)
      {
        case 1:
          return serial_section(
            [&]() { run_in<1>(request, scene, since_start, log); },
            MPI_COMM_WORLD);
        case 2:
          return run_in<2>(request, scene, since_start, log);
        default:
          return run_in<3>(request, scene, since_start, log);
      }
  }
} // namespace ThermoContact
