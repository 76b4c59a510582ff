// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/writable_file.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/output/checkpoint.h>

#include <boost/crc.hpp>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

namespace ThermoContact
{
  namespace
  {
    const char *const newest_name   = "/checkpoint.bin";
    const char *const previous_name = "/checkpoint.previous.bin";

    const char *const damage = "it is damaged: size or checksum is wrong";



    /** Columns of contact.csv, all of which a Simulation saves. */
    std::vector<std::string>
    column_names()
    {
      std::vector<std::string> names;
      StepRecord::for_each_column(
        [&names](const char *name, const auto &...) { names.push_back(name); });
      return names;
    }



    /** Entries that a run may have otherwise when it goes on. */
    const std::set<std::string> changeable = {"Title",
                                              "Time/End time",
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



    // A file is a line that names the format, a line with the CRC-32 of the
    // next one, a line of JSON, with size and checksum of each part, then the
    // parts: the values that all ranks have in common, and the nodes of one
    // rank after the other, which may be as large as the disk allows.

    /**
     * Changes with every member that a Simulation saves, but for columns of
     * contact.csv: its archive does not say what is in it.
     */
    const std::string format = "thermocontact checkpoint 19";



    PartPlace
    describe(const std::string &bytes)
    {
      boost::crc_32_type crc;
      crc.process_bytes(bytes.data(), bytes.size());
      return {0, bytes.size(), crc.checksum()};
    }



    /** The lines before the parts. */
    std::string
    head_of(const Checkpoint &checkpoint, const std::vector<PartPlace> &parts)
    {
      nlohmann::ordered_json header = {{"time", checkpoint.time},
                                       {"step", checkpoint.step},
                                       {"ranks", checkpoint.n_ranks},
                                       {"version", checkpoint.version},
                                       {"parts", nlohmann::json::array()},
                                       {"parameters", checkpoint.parameters},
                                       {"sizes", checkpoint.output.sizes},
                                       {"snapshot_times",
                                        checkpoint.output.snapshot_times},
                                       {"columns", column_names()}};
      for (const PartPlace &part : parts)
        header["parts"].push_back(
          {{"size", part.size}, {"checksum", part.checksum}});
      const std::string line =
        header.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
      return text(format, '\n', describe(line).checksum, '\n', line, '\n');
    }



    /** Reads the lines before the parts. */
    Checkpoint
    read_head(std::istream &stream)
    {
      std::string line(format.size() + 1, '\0'), checksum;
      stream.read(line.data(), line.size());
      if (line != format + '\n')
        throw std::runtime_error("it does not begin with '" + format +
                                 "': not a checkpoint, or of another version "
                                 "of thermocontact");
      std::getline(stream, checksum);
      std::getline(stream, line);
      if (checksum != text(describe(line).checksum))
        throw std::runtime_error(damage);
      const auto header = nlohmann::json::parse(line);
      if (header.at("columns") != column_names())
        throw std::runtime_error(
          "its columns belong to another version of thermocontact");
      Checkpoint checkpoint;
      header.at("time").get_to(checkpoint.time);
      header.at("step").get_to(checkpoint.step);
      header.at("ranks").get_to(checkpoint.n_ranks);
      header.at("version").get_to(checkpoint.version);
      header.at("parameters").get_to(checkpoint.parameters);
      header.at("sizes").get_to(checkpoint.output.sizes);
      header.at("snapshot_times").get_to(checkpoint.output.snapshot_times);
      std::uint64_t begin = stream.tellg();
      for (const auto &part : header.at("parts"))
        {
          checkpoint.parts.push_back(
            {begin, part.at("size"), part.at("checksum")});
          begin += checkpoint.parts.back().size;
        }
      return checkpoint;
    }



    /** Reads a part and drops it; says whether it is as it was written. */
    bool
    is_whole(const PartPlace &part, std::istream &stream)
    {
      boost::crc_32_type crc;
      std::string        piece(1 << 16, '\0');
      std::uint64_t      n = 0;
      stream.seekg(part.begin);
      while (n < part.size && stream)
        {
          stream.read(piece.data(),
                      std::min<std::uint64_t>(piece.size(), part.size - n));
          crc.process_bytes(piece.data(), stream.gcount());
          n += stream.gcount();
        }
      return n == part.size && crc.checksum() == part.checksum;
    }



    std::ifstream
    open_file(const std::string &path)
    {
      std::ifstream stream(path, std::ios::binary);
      if (!stream)
        throw std::runtime_error(std::string("it cannot be opened: ") +
                                 std::strerror(errno));
      return stream;
    }



    std::string
    read_part(const PartPlace &part, std::istream &stream)
    {
      std::string bytes(part.size, '\0');
      stream.clear();
      stream.seekg(part.begin);
      stream.read(bytes.data(), bytes.size());
      if (!stream)
        throw std::runtime_error("it cannot be read to its end");
      return bytes;
    }



    /**
     * Reads a file without the nodes, and looks at all of it, to see that it is
     * whole.
     *
     * @param n_ranks,this_rank the share of the parts to look at
     * @throw std::exception with the fault
     */
    Checkpoint
    read_common(const std::string &path,
                const unsigned int n_ranks,
                const unsigned int this_rank)
    {
      std::ifstream    stream     = open_file(path);
      Checkpoint       checkpoint = read_head(stream);
      const PartPlace &first      = checkpoint.parts.at(0);
      const PartPlace &last       = checkpoint.parts.back();
      stream.seekg(0, std::ios::end);
      bool is_good =
        static_cast<std::uint64_t>(stream.tellg()) == last.begin + last.size &&
        is_whole(first, stream);
      for (std::size_t i = 1 + this_rank; i < checkpoint.parts.size();
           i += n_ranks)
        is_good = is_good && is_whole(checkpoint.parts[i], stream);
      if (!is_good)
        throw std::runtime_error(damage);
      checkpoint.path     = path;
      checkpoint.progress = read_part(first, stream);
      return checkpoint;
    }
  } // namespace



  void
  write_checkpoint(const std::string &directory,
                   const Checkpoint  &checkpoint,
                   const MPI_Comm     communicator)
  {
    const std::string      next = directory + "/checkpoint.next.bin";
    std::vector<PartPlace> parts =
      all_gather(communicator, describe(checkpoint.nodes));
    std::string before; // the parts of the ranks
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        parts.insert(parts.begin(), describe(checkpoint.progress));
        before = head_of(checkpoint, parts) + checkpoint.progress;
      }
    const bool  is_durable = true;
    std::string fault      = write_parallel_file(next,
                                            {before, checkpoint.nodes},
                                            communicator,
                                            is_durable);
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
        if (!broadcast(communicator, access(path.c_str(), F_OK) == 0))
          continue;
        Checkpoint  checkpoint;
        std::string fault;
        try
          {
            checkpoint =
              read_common(path,
                          Utilities::MPI::n_mpi_processes(communicator),
                          Utilities::MPI::this_mpi_process(communicator));
          }
        catch (const std::exception &error)
          {
            fault = error.what();
          }
        fault              = first_fault(fault, communicator);
        checkpoint.warning = faults;
        if (fault.empty())
          return checkpoint;
        faults += path + ": " + fault + "\n  ";
      }
    std::error_code error;
    if (!std::filesystem::exists(directory, error))
      throw InputError("--resume: there is no directory " + directory +
                       "\n  remedy:  the --output of the run that is to go on, "
                       "or run without --resume");
    if (std::filesystem::exists(directory + "/study.csv", error))
      throw InputError("--resume: " + directory +
                       " has a study, not a single run\n  remedy:  the "
                       "parameter file of the study, " +
                       directory + "/used.prm, or run without --resume");
    throw InputError("--resume: no checkpoint in " + directory + "\n  " +
                     faults +
                     "remedy:  run without --resume; set Output/Checkpoint "
                     "interval to have checkpoints");
  }



  std::string
  read_nodes(const Checkpoint &checkpoint, const unsigned int rank)
  {
    std::ifstream stream = open_file(checkpoint.path);
    return read_part(checkpoint.parts[1 + rank], stream);
  }



  void
  keep_as_newest(const std::string &directory, const Checkpoint &checkpoint)
  {
    // Else the next one would make the damaged one the previous.
    if (!checkpoint.warning.empty())
      std::rename((directory + previous_name).c_str(),
                  (directory + newest_name).c_str());
  }



  void
  check_compatibility(const Checkpoint                         &checkpoint,
                      const std::string                        &directory,
                      const std::map<std::string, std::string> &entries,
                      const Parameters                         &parameters,
                      const MPI_Comm                            communicator)
  {
    const auto &before = checkpoint.parameters;
    for (const auto &[path, value] : entries)
      if (const auto old = before.find(path);
          changeable.count(path) == 0 &&
          (old == before.end() || !equal_values(old->second, value)))
        throw InputError(
          path + " = " + value + ": the checkpoint has " +
          (old == before.end() ? "no such entry" : old->second) +
          "\n  allowed: with --resume, another Time/End time, intervals of the "
          "output\n  remedy:  the value of the checkpoint, or run without "
          "--resume");
    const double end_time = parameters.time.end_time;
    if (end_time < checkpoint.time)
      throw InputError(
        text("Time/End time = ",
             end_time,
             ": the checkpoint is at t = ",
             QuantityUnits(parameters).text_for_entry("time", checkpoint.time),
             "\n  allowed: with --resume, a time from there on"));

    std::string fault;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const auto &[name, size] : checkpoint.output.sizes)
        {
          std::error_code   error;
          const std::string path  = directory + "/" + name;
          const auto        found = std::filesystem::file_size(path, error);
          if (fault.empty() && size > 0 && (error || found < size))
            fault = path + ": " +
                    (error ? error.message() :
                             "is shorter than the checkpoint says") +
                    "\n  remedy:  put the file of the run back, or run "
                    "without --resume";
        }
    throw_everywhere<InputError>(fault, communicator);
  }
} // namespace ThermoContact
