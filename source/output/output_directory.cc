// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/version.h>
#include <thermocontact/base/writable_file.h>
#include <thermocontact/input/measured_table.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/output/output_directory.h>

#include <fcntl.h>
#include <fnmatch.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Files that a run or a study leaves behind; others are the user's. */
    const char *const run_files[] = {
      "checkpoint?(.next|.previous).bin",
      "@(contact|fields|obstacle).pvd",
      "contacts/*.csv",
      "fields/@(contact|fields|obstacle)-+([0-9])"
      ".vtu",
      "@(boundaries|contact|events|poincare|"
      "probes|steps|study).csv",
      "log.txt",
      "obstacle.vtu",
      "space-time.@(columns|vtu)",
      "study.@(md|txt)",
      "summary.json"};



    /** Matches the name of a file, which may still be written. */
    bool
    matches(const std::string &name, const char *const pattern)
    {
      const std::string whole = "@(" + std::string(pattern) + ")?(.part)";
      return fnmatch(whole.c_str(), name.c_str(), FNM_EXTMATCH) == 0;
    }



    /** True if an earlier run was here, perhaps killed at its start. */
    bool
    holds_run(const fs::path &directory)
    {
      return fs::exists(directory / "used.prm") ||
             fs::exists(directory / "used.prm.part");
    }



    /** Throws if files cannot be created or removed in an existing directory.
     */
    void
    check_rights(const fs::path &directory)
    {
      if (fs::is_directory(directory) &&
          access(directory.c_str(), W_OK | X_OK) != 0)
        throw fs::filesystem_error(
          "access", directory, std::error_code(errno, std::generic_category()));
    }



    void
    remove_earlier_run(const fs::path &directory)
    {
      const auto remove_if_empty = [](const fs::path &folder) {
        if (fs::is_directory(folder) && fs::is_empty(folder))
          fs::remove(folder);
      };
      for (const fs::path &folder :
           {directory / "fields", directory / "contacts", directory})
        if (fs::is_directory(folder))
          for (const auto &entry : fs::directory_iterator(folder))
            {
              const std::string name =
                entry.path().lexically_relative(directory).string();
              if (std::any_of(std::begin(run_files),
                              std::end(run_files),
                              [&name](const char *const pattern) {
                                return matches(name, pattern);
                              }))
                fs::remove(entry.path());
              else if (matches(name, "run-+([0-9])") && holds_run(entry.path()))
                {
                  remove_earlier_run(entry.path()); // of a study
                  remove_if_empty(entry.path());
                }
            }
      remove_if_empty(directory / "fields");
      remove_if_empty(directory / "contacts");
      // last, so that an interrupted clean-up is recognised as a run
      fs::remove(directory / "used.prm.part");
      fs::remove(directory / "used.prm");
    }



    /** Returns the fault, or nothing; changes nothing. */
    std::string
    find_fault(const fs::path &directory)
    {
      if (!fs::exists(directory))
        return "";
      if (!fs::is_directory(directory))
        return "is a file\n  remedy:  give another directory";
      check_rights(directory);
      check_rights(directory / "fields");
      check_rights(directory / "contacts");
      if (!holds_run(directory) && !fs::is_empty(directory))
        return "holds files that are not from an earlier run (no used.prm)"
               "\n  remedy:  give a new or an empty directory";
      return "";
    }



    /** Calls @p action on rank 0, which returns or throws a fault. */
    template <typename Action>
    void
    on_first_rank(const std::string &directory,
                  const MPI_Comm     communicator,
                  const Action      &action)
    {
      std::string fault;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        try
          {
            fault = action();
          }
        catch (const fs::filesystem_error &error)
          {
            fault = error.code().message() +
                    "\n  remedy:  give a directory that can be written";
          }
      if (!fault.empty())
        fault = "Output/Directory = " + quote(directory) + ": " + fault;
      throw_everywhere<InputError>(fault, communicator);
    }
  } // namespace



  void
  check_output_directory(const std::string &directory,
                         const MPI_Comm     communicator)
  {
    on_first_rank(directory, communicator, [&]() {
      return find_fault(directory);
    });
  }



  void
  prepare_output_directory(const std::string &directory,
                           const MPI_Comm     communicator)
  {
    on_first_rank(directory, communicator, [&]() {
      const std::string fault = find_fault(directory);
      if (fault.empty() && fs::exists(directory))
        remove_earlier_run(directory);
      else if (fault.empty())
        fs::create_directories(directory);
      return fault;
    });
  }



  DirectoryLock::DirectoryLock(const std::string &directory,
                               const bool         must_exist,
                               const MPI_Comm     communicator)
  {
    on_first_rank(directory, communicator, [&]() -> std::string {
      if (!must_exist)
        fs::create_directories(directory);
      descriptor = open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (descriptor < 0 && !(must_exist && errno == ENOENT))
        return std::string(std::strerror(errno)) +
               "\n  remedy:  give a directory that can be read and written";
      if (descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) != 0 &&
          errno == EWOULDBLOCK)
        return "another run is writing into it\n  remedy:  wait for its end, "
               "or give another directory";
      return "";
    });
  }



  DirectoryLock::~DirectoryLock()
  {
    if (descriptor >= 0)
      close(descriptor); // ends the lock
  }



  void
  write_used_parameters(const std::string             &directory,
                        const std::set<std::string>   &omit,
                        const ParameterHandler        &prm,
                        const std::vector<Assignment> &assignments,
                        const SchemeChoice            &choice,
                        const MPI_Comm                 communicator)
  {
    std::string fault;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::vector<DeclaredEntry> entries = declared_entries(prm);
        add_units(assignments, entries);
        for (DeclaredEntry &entry : entries)
          if (const std::string *const chosen = choice.find(entry.path))
            {
              entry.value  = *chosen;
              entry.remark = "automatic";
              if (entry.path == "Time/Scheme")
                entry.remark += ", since " + choice.reason;
            }
          else if (entry.path == "Output/Directory")
            {
              entry.value = directory;
              entry.remark.clear();
            }

        const fs::path folder = folder_of_tables(assignments);
        for (const Assignment &assignment : assignments)
          for (const std::string &file : table_files(assignment.value))
            if (const fs::path copy = fs::path(directory) / file;
                !fs::path(file).is_absolute() &&
                fs::absolute(copy) != fs::absolute(folder / file))
              {
                std::error_code failure;
                fs::create_directories(copy.parent_path(), failure);
                fs::copy_file(folder / file,
                              copy,
                              fs::copy_options::overwrite_existing,
                              failure);
                if (failure)
                  fault = copy.string() + ": " + failure.message();
              }

        const std::string  path = directory + "/used.prm";
        std::ostringstream text;
        text << "# thermocontact " << version() << ": every entry as used\n";
        write_entries(entries, omit, text);
        if (fault.empty())
          fault = write_atomically(path, text.str());
      }
    throw_everywhere<ComputationError>(fault, communicator);
  }
} // namespace ThermoContact
