// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/interruption.h>
#include <thermocontact/base/log.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/types.h>
#include <thermocontact/base/version.h>
#include <thermocontact/input/command_line.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/output/output_page.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/scene/scheme_choice.h>
#include <thermocontact/sweep.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /** On the standard output of rank 0. */
    void
    print_parameters(const Request &request)
    {
      const std::string         &format  = request.command.print_parameters;
      std::vector<DeclaredEntry> entries = declared_entries(request.prm);
      const bool                 is_si   = is_in_si(request.assignments);
      if (is_si && format != "prm")
        throw InputError("--print-parameters=" + format +
                         ": the file has section Rod\n  allowed: prm");
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
        return;
      if (is_si)
        {
          add_units(request.assignments, entries);
          return write_entries(entries, {}, std::cout);
        }
      if (format == "markdown")
        return write_parameter_reference(request.prm, std::cout);
      const auto style = format == "json" ? ParameterHandler::JSON :
                                            (format == "description" ?
                                               ParameterHandler::Description :
                                               ParameterHandler::PRM);
      request.prm.print_parameters(std::cout,
                                   style |
                                     ParameterHandler::KeepDeclarationOrder);
    }



    /**
     * The statements of the parameter file, then those of the command line.
     * Rank 0 reads the file, so that all ranks see the same or fail together.
     */
    std::vector<Assignment>
    all_assignments(const CommandLine &command)
    {
      std::vector<Assignment> assignments;
      std::string             fault;
      if (!command.file_name.empty() &&
          Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        try
          {
            assignments = read_parameter_file(command.file_name);
          }
        catch (const InputError &error)
          {
            fault = error.what();
          }
      throw_everywhere<InputError>(fault, MPI_COMM_WORLD);
      assignments = broadcast(MPI_COMM_WORLD, assignments);
      assignments.insert(assignments.end(),
                         command.overrides.begin(),
                         command.overrides.end());
      add_scales_of_masses(assignments);
      return assignments;
    }



    /** Prints the scene of a file in SI units without them. */
    void
    print_scene(const Request &request)
    {
      std::vector<DeclaredEntry> entries = declared_entries(request.prm);
      if (!is_in_si(request.assignments))
        throw InputError(std::string(command_line_place) +
                         ": --units: the file has no section Rod, and no units"
                         "\n  remedy:  run it without --units");
      remove_units(request.assignments, entries);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        write_entries(entries, {}, std::cout);
    }



    /**
     * Without mpirun, Open MPI looks for networks, starts a daemon and has
     * hwloc explore the machine, display and buses included: a single process
     * has no use for any of it, and it is most of its time to start. Without a
     * daemon all processes of a user would make and remove the same directory,
     * and fail if two start at once. Variables that the user has set stay. To
     * be called before MPI_Init.
     *
     * @return variables of the environment to unset after it, since others than
     *   MPI read them, too
     */
    std::vector<const char *>
    declare_single_process()
    {
      std::vector<const char *> names;
      for (const char *const by_launcher :
           {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
        if (std::getenv(by_launcher) != nullptr)
          return names;
      const int keep = 0;
      setenv("OMPI_MCA_pml", "ob1", keep);
      setenv("OMPI_MCA_btl", "self", keep);
      setenv("OMPI_MCA_ess_singleton_isolated", "1", keep);
      setenv("OMPI_MCA_orte_create_session_dirs", "0", keep);
      for (const auto &[name, value] :
           {std::pair("HWLOC_PLUGINS_PATH", "/nonexistent"),
            std::pair("HWLOC_SYNTHETIC", "pu:1")})
        if (std::getenv(name) == nullptr && setenv(name, value, keep) == 0)
          names.push_back(name);
      return names;
    }



    void
    check_processor()
    {
#if THERMOCONTACT_LANE_BYTES > 16
      const bool  wide         = THERMOCONTACT_LANE_BYTES > 32;
      const char *instructions = wide ? "AVX-512" : "AVX2";
      if (!(wide ? __builtin_cpu_supports("avx512vl") :
                   __builtin_cpu_supports("avx2")))
        throw ComputationError(
          "this program was compiled for a processor with " +
          std::string(instructions) +
          " instructions, and this one has none\n  remedy:  build it here, or "
          "with cmake -DTHERMOCONTACT_LANE_BYTES=16");
#endif
    }



    /** What to do if memory is not enough, perhaps on this rank alone. */
    [[noreturn]] void
    refuse_size(const Parameters &written)
    {
      const Parameters   parameters = choose_scheme(written).parameters;
      const unsigned int dim        = parameters.dimension;
      const std::string  message =
        text("not enough memory for a mesh of ",
             significant(parameters.mesh.n_nodes(dim), 3),
             " nodes with ",
             dim + 1,
             " unknowns each\n  remedy:  fewer Mesh/Cells, a lower Mesh/Degree",
             dim > 1 ? ", Solver/Linear solver = iterative" : "");
      if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
        throw ComputationError(message);
      std::cerr << "thermocontact: " << message << std::endl;
      MPI_Abort(MPI_COMM_WORLD, 1); // the others wait
      std::exit(1);
    }



    void
    run(const CommandLine &command, const Timer &since_start, Log &log)
    {
      check_processor();
      if (command.show_help || command.show_version)
        {
          log.line(command.show_help ?
                     help_text() :
                     std::string("thermocontact ") + version());
          return;
        }
      if (command.show_output)
        {
          if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
            std::cout << output_page;
          return;
        }

      if (command.file_name.empty() && command.print_parameters.empty())
        throw InputError("no parameter file is given\n  remedy:  thermocontact "
                         "FILE.prm, e.g. prm/paper/experiment-1.prm");

      const Request     request(command, all_assignments(command));
      const Parameters &parameters = request.parameters;
      if (!command.print_parameters.empty())
        return print_parameters(request);

      try
        {
          if (parameters.study.is_active() && !command.prints_scene)
            return run_sweep(request, log);
          const Scene scene(parameters);
          check_unused_entries(scene, request.assignments, request.prm);
          check_scene(scene);
          if (command.prints_scene)
            return print_scene(request);
          run_scene(request, scene, since_start, log);
        }
      catch (const InputError &error)
        {
          throw InputError(
            complete_message(error.what(), request.assignments, request.prm));
        }
      catch (const std::bad_alloc &)
        {
          refuse_size(parameters);
        }
    }
  } // namespace
} // namespace ThermoContact



int
main(int argc, char **argv)
{
  using namespace ThermoContact;

  std::signal(SIGXFSZ, SIG_IGN); // a file at its limit is an error like others
  std::signal(SIGPIPE, SIG_IGN); // nor does a run end with who looks at it

  const Timer since_start;
  const auto  ignored  = ignored_signals();
  const auto  to_unset = declare_single_process();
  // The arguments are ours alone: PETSc, which deal.II starts too, obeys those
  // that it knows and, in Debian 13, prints those that it does not.
  int                              n_arguments    = 1;
  char                            *program_name[] = {argv[0], nullptr};
  char                           **arguments      = program_name;
  Utilities::MPI::MPI_InitFinalize mpi(n_arguments, arguments, 1);
  for (const char *const name : to_unset)
    unsetenv(name);
  for (const int signal : ignored)
    std::signal(signal, SIG_IGN);
  const bool is_first_rank =
    Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const auto print_error = [is_first_rank](const std::string &message) {
    if (is_first_rank)
      std::cerr << "thermocontact: " << message << std::endl;
  };

  try
    {
      const CommandLine command = parse_command_line(argc, argv);
      Log               log(is_first_rank, command.is_quiet);
      run(command, since_start, log);
      return 0;
    }
  catch (const InputError &error)
    {
      print_error(error.what());
      return 2;
    }
  catch (const ComputationError &error)
    {
      print_error(error.what());
      return 1;
    }
  catch (const std::exception &error)
    {
      // Not foreseen, perhaps on this rank alone: the others must not wait.
      std::cerr << "thermocontact: unexpected error\n"
                << error.what() << std::endl;
      if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        MPI_Abort(MPI_COMM_WORLD, 1);
      return 1;
    }
}
