// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/interruption.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/study/study.h>
#include <thermocontact/sweep.h>

#include <filesystem>
#include <fstream>

namespace ThermoContact
{
  namespace
  {
    /** Entries that do not change what a row holds. */
    const std::set<std::string> free_entries = {"Title",
                                                "Output/Directory",
                                                "Study/Keep files",
                                                "Study/Target error"};



    /** Throws unless the study in @p directory is the one of @p prm. */
    void
    check_same_study(const std::string &directory, const ParameterHandler &prm)
    {
      const std::string file_name = directory + "/used.prm";
      std::ifstream     file(file_name);
      if (!file)
        throw InputError("--resume: no study in " + quote(directory) +
                         " (no used.prm)\n  remedy:  run without --resume");
      Parameters       used;
      ParameterHandler used_prm;
      used.add_parameters(used_prm);
      assign_entries(read_assignments(file, file_name), used_prm, used);
      if (!used.study.is_active())
        throw InputError("--resume: " + quote(directory) +
                         " has a single run, not a study\n  remedy:  run "
                         "without --resume");
      const auto before = entry_values(used_prm);
      for (const auto &[path, value] : entry_values(prm))
        if (free_entries.count(path) == 0 &&
            !equal_values(before.at(path), value))
          throw InputError(path + " = " + value + ": the study has " +
                           before.at(path) +
                           "\n  remedy:  the value of the study, or run "
                           "without --resume");
    }



    /**
     * Reads the rows that are there.
     *
     * @throw InputError if they are not those of the study of @p prm
     */
    void
    read_rows(const std::string      &directory,
              const ParameterHandler &prm,
              StudyTable             &table)
    {
      check_same_study(directory, prm);
      if (std::filesystem::exists(directory + "/study.csv"))
        table.read_on();
    }



    /** Makes the directory and study.csv ready, anew or to go on. */
    void
    prepare(const Request     &request,
            const std::string &directory,
            StudyTable        &table)
    {
      const MPI_Comm communicator = MPI_COMM_WORLD;
      const bool is_first = Utilities::MPI::this_mpi_process(communicator) == 0;
      std::string mismatch;
      if (!request.command.is_resumed)
        prepare_output_directory(directory, communicator);
      else if (is_first)
        try
          {
            read_rows(directory, request.prm, table);
          }
        catch (const InputError &error)
          {
            mismatch = error.what();
          }
      throw_everywhere<InputError>(mismatch, communicator);
      // an entry that one run cannot use another may, and each chooses its own
      write_used_parameters(
        directory, {}, request.prm, request.assignments, {}, communicator);
      throw_everywhere<ComputationError>(is_first ? table.sort() : "",
                                         communicator);
    }
  } // namespace



  void
  run_sweep(const Request &request, Log &log)
  {
    const MPI_Comm     communicator = MPI_COMM_WORLD;
    const Parameters  &parameters   = request.parameters;
    const CommandLine &command      = request.command;
    check_scales(parameters);
    check_error_bars(parameters);
    const StudyPlan   plan(request.assignments, parameters.study);
    const std::string directory = request.output_directory();
    StudyTable        table(plan, directory + "/study.csv", parameters);
    if (command.check_only)
      {
        if (command.is_resumed)
          read_rows(directory, request.prm, table);
        check_output_directory(directory, communicator);
        return check_study(table, parameters.study, log);
      }
    check_any_run(table);
    // before there is a directory, or with its rows, and kept for its log
    std::string memory;
    if (!command.is_resumed)
      memory = check_study_memory(table);
    const DirectoryLock lock(directory, command.is_resumed, communicator);
    prepare(request, directory, table);
    if (command.is_resumed)
      memory = check_study_memory(table);
    throw_everywhere<ComputationError>(log.open_file(directory + "/log.txt",
                                                     command.is_resumed),
                                       communicator);
    if (!parameters.title.empty())
      log.line(parameters.title);
    log.line("  study     " + std::to_string(plan.n_runs()) +
             " runs, reference: " + parameters.study.reference);
    if (command.is_resumed)
      log.line("  resumed   with the rows of " + std::to_string(table.size()) +
               " runs");
    if (!memory.empty())
      log.line(memory);
    try
      {
        run_study(parameters.study, directory, table, log);
      }
    catch (const Interruption &error)
      {
        log.failure(std::string("  interrupted:  ") + error.what());
        throw Interruption(error.what() + std::string("\n  resume:  ") +
                           request.resume_command(communicator));
      }
    write_study_tables(directory, parameters.title, table);
    log.line("  files     " + directory);
    report_study(table, parameters.study.target_error, log);
  }
} // namespace ThermoContact
