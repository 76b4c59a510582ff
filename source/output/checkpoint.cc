// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/atomic_file.h>
#include <thermocontact/base/collective_errors.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/output/checkpoint.h>
#include <thermocontact/output/checkpoint_file.h>
#include <thermocontact/output/output_directory.h>

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    const char *const newest_name   = "/checkpoint.bin";
    const char *const previous_name = "/checkpoint.previous.bin";

    /** What a run that goes on may have otherwise. */
    const std::set<std::string> changeable = {"Time/End time",
                                              "Output/Directory",
                                              "Output/Fields interval",
                                              "Output/Contact interval",
                                              "Output/Space-time interval",
                                              "Output/Checkpoint interval",
                                              "Output/Error bars"};



    /** Makes the file @p next the newest checkpoint; on one rank. */
    std::string
    make_newest(const std::string &next, const std::string &directory)
    {
      const std::string newest   = directory + newest_name;
      const std::string previous = directory + previous_name;
      // A second name, so that there is a newest one at any instant.
      const std::string second_name = previous + part_suffix;
      std::remove(second_name.c_str());
      if (link(newest.c_str(), second_name.c_str()) == 0)
        {
          if (std::rename(second_name.c_str(), previous.c_str()) != 0)
            return previous + ": cannot be replaced";
        }
      else // no earlier one, or a file system without second names
        std::rename(newest.c_str(), previous.c_str());
      if (std::rename(next.c_str(), newest.c_str()) != 0)
        return newest + ": cannot be replaced";
      sync_directory(directory);
      return "";
    }
  } // namespace



  void
  write_checkpoint(const std::string &directory,
                   const Checkpoint  &checkpoint,
                   const MPI_Comm     communicator)
  {
    const std::string next = directory + "/checkpoint.next.bin";
    std::string fault = write_checkpoint_file(next, checkpoint, communicator);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        if (fault.empty())
          fault = make_newest(next, directory);
        else
          std::remove(next.c_str());
      }
    throw_everywhere<ComputationError>(fault, communicator);
  }



  Checkpoint
  read_checkpoint(const std::string &directory, const MPI_Comm communicator)
  {
    std::string faults;
    for (const char *name : {newest_name, previous_name})
      {
        const std::string path = directory + name;
        if (!Utilities::MPI::broadcast(communicator,
                                       access(path.c_str(), F_OK) == 0))
          continue;
        std::string fault;
        Checkpoint checkpoint = read_checkpoint_file(path, fault, communicator);
        checkpoint.warning    = faults;
        if (fault.empty())
          return checkpoint;
        faults += path + ": " + fault + "\n  ";
      }
    throw InputError("--resume: no checkpoint in " + directory + "\n  " +
                     faults +
                     "remedy:  run without --resume; set Output/Checkpoint "
                     "interval to have checkpoints");
  }



  void
  keep_as_newest(const std::string &directory, const Checkpoint &checkpoint)
  {
    // Else the next one would make the damaged one the previous.
    if (!checkpoint.warning.empty())
      std::rename((directory + previous_name).c_str(),
                  (directory + newest_name).c_str());
  }



  std::string
  find_short_file(const std::string &directory, const OutputProgress &progress)
  {
    for (const auto &[name, size] : progress.sizes)
      {
        std::error_code   error;
        const std::string path  = directory + "/" + name;
        const auto        found = std::filesystem::file_size(path, error);
        if (size > 0 && (error || found < size))
          return path + ": " +
                 (error ? error.message() :
                          "is shorter than the checkpoint says") +
                 "\n  remedy:  put the file of the run back, or run without "
                 "--resume";
      }
    return "";
  }



  void
  check_compatibility(const Checkpoint                         &checkpoint,
                      const std::map<std::string, std::string> &parameters,
                      const double                              end_time,
                      const QuantityUnits                      &units)
  {
    for (const auto &[path, value] : parameters)
      {
        const auto old = checkpoint.parameters.find(path);
        if (changeable.count(path) == 0 &&
            (old == checkpoint.parameters.end() ||
             !equal_values(old->second, value)))
          throw InputError(
            path + " = " + value + ": the checkpoint has " +
            (old == checkpoint.parameters.end() ? "no such entry" :
                                                  old->second) +
            "\n  allowed: with --resume, another Time/End time, intervals of "
            "the output\n  remedy:  the value of the checkpoint, or run "
            "without --resume");
      }
    if (end_time < checkpoint.time)
      {
        throw InputError(text("Time/End time = ",
                              end_time,
                              ": the checkpoint is at t = ",
                              units.text_for_entry("time", checkpoint.time),
                              "\n  allowed: with --resume, a time from there "
                              "on"));
      }
  }
} // namespace ThermoContact
