// SPDX-License-Identifier: LGPL-2.1-or-later

#include "output_directory.h"

#include <filesystem>

#include "exceptions.h"

namespace ThermoContact
{
  namespace
  {
    namespace fs = std::filesystem;

    /** What a run leaves behind; other files are the user's and stay. */
    const char *const run_files[] = {"contact.csv",
                                     "events.csv",
                                     "fields.pvd",
                                     "log.txt",
                                     "summary.json"};

    void
    remove_earlier_run(const fs::path &directory)
    {
      for (const char *name : run_files)
        fs::remove(directory / name);
      if (fs::is_directory(directory / "fields"))
        {
          for (const auto &entry : fs::directory_iterator(directory / "fields"))
            if (entry.path().extension() == ".vtu")
              fs::remove(entry.path());
          if (fs::is_empty(directory / "fields"))
            fs::remove(directory / "fields");
        }
      // last, so that an interrupted clean-up is recognised as a run
      fs::remove(directory / "used.prm");
    }



    /** Returns what is wrong, or nothing. */
    std::string
    prepare_on_this_rank(const fs::path &directory)
    {
      try
        {
          if (!fs::exists(directory))
            fs::create_directories(directory);
          else if (!fs::is_directory(directory))
            return "is a file\n  remedy:  give another directory";
          else if (fs::exists(directory / "used.prm"))
            remove_earlier_run(directory);
          else if (!fs::is_empty(directory))
            return "holds files that are not from an earlier run (no used.prm)"
                   "\n  remedy:  give a new or an empty directory";
          return "";
        }
      catch (const fs::filesystem_error &error)
        {
          return error.code().message() +
                 "\n  remedy:  give a directory that can be written";
        }
    }
  } // namespace



  void
  prepare_output_directory(const std::string &directory,
                           const MPI_Comm     communicator)
  {
    std::string fault;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        fault = prepare_on_this_rank(directory);
        if (!fault.empty())
          fault = "Output/Directory = " + directory + ": " + fault;
      }
    throw_everywhere<InputError>(fault, communicator);
  }
} // namespace ThermoContact
