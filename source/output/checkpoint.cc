// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/atomic_file.h>
#include <thermocontact/base/collective_errors.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/output/checkpoint.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/crc.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

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



    // A file is a line that names the format, a line of JSON for readers, with
    // size and checksum of each part, then the parts: what all ranks have in
    // common, and the nodes of one rank after the other, which may be as large
    // as the disk allows.

    /**
     * Changes with every member that is saved, a column of contact.csv too: the
     * archive does not say what is in it.
     */
    const std::string format = "thermocontact checkpoint 11";



    PartPlace
    describe(const std::string &bytes)
    {
      boost::crc_32_type crc;
      crc.process_bytes(bytes.data(), bytes.size());
      return {0, bytes.size(), crc.checksum()};
    }



    /** All but the nodes. */
    template <class Archive, class AnyCheckpoint>
    void
    archive_common(Archive &archive, AnyCheckpoint &checkpoint)
    {
      archive &checkpoint.time &checkpoint.step &checkpoint.version &checkpoint
        .parameters &checkpoint.output &checkpoint.progress;
    }



    std::string
    to_bytes(const Checkpoint &checkpoint)
    {
      std::ostringstream              stream;
      boost::archive::binary_oarchive archive(stream,
                                              boost::archive::no_header);
      archive_common(archive, checkpoint);
      return stream.str();
    }



    /** @throw std::exception if @p bytes are not those of to_bytes() */
    Checkpoint
    from_bytes(const std::string &bytes)
    {
      Checkpoint                      checkpoint;
      std::istringstream              stream(bytes);
      boost::archive::binary_iarchive archive(stream,
                                              boost::archive::no_header);
      archive_common(archive, checkpoint);
      return checkpoint;
    }



    /** The lines before the parts. */
    std::string
    head_of(const Checkpoint &checkpoint, const std::vector<PartPlace> &parts)
    {
      nlohmann::ordered_json header = {{"time", checkpoint.time},
                                       {"step", checkpoint.step},
                                       {"ranks", checkpoint.n_ranks},
                                       {"version", checkpoint.version},
                                       {"parts", nlohmann::json::array()}};
      for (const PartPlace &part : parts)
        header["parts"].push_back(
          {{"size", part.size}, {"checksum", part.checksum}});
      return format + '\n' + header.dump() + '\n';
    }



    /** Reads the lines before the parts. */
    std::vector<PartPlace>
    read_head(std::istream &stream)
    {
      std::string line(format.size() + 1, '\0');
      stream.read(line.data(), line.size());
      if (line != format + '\n')
        throw std::runtime_error("it does not begin with '" + format +
                                 "': not a checkpoint, or of another version "
                                 "of thermocontact");
      std::getline(stream, line);
      const auto             header = nlohmann::json::parse(line);
      std::uint64_t          begin  = stream.tellg();
      std::vector<PartPlace> parts;
      for (const auto &part : header.at("parts"))
        {
          parts.push_back({begin, part.at("size"), part.at("checksum")});
          begin += parts.back().size;
        }
      return parts;
    }



    /** Reads a part and drops it; says whether it is as it was written. */
    bool
    is_whole(const PartPlace &part, std::istream &stream)
    {
      boost::crc_32_type crc;
      std::string        piece(1 << 16, '\0');
      std::uint64_t      n = 0;
      stream.clear();
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
     * Reads what all ranks have in common.
     *
     * @param n_ranks,this_rank the share of the other parts to look at
     * @throw std::exception saying what is wrong
     */
    Checkpoint
    read_common(const std::string &path,
                const unsigned int n_ranks,
                const unsigned int this_rank)
    {
      std::ifstream                stream  = open_file(path);
      const std::vector<PartPlace> parts   = read_head(stream);
      bool                         is_good = !parts.empty();
      if (is_good)
        {
          const PartPlace &last = parts.back();
          stream.seekg(0, std::ios::end);
          is_good = static_cast<std::uint64_t>(stream.tellg()) ==
                      last.begin + last.size &&
                    is_whole(parts.front(), stream);
        }
      for (unsigned int i = 1 + this_rank; i < parts.size(); i += n_ranks)
        is_good = is_good && is_whole(parts[i], stream);
      if (!is_good)
        throw std::runtime_error("it is damaged: size or checksum is wrong");
      Checkpoint checkpoint = from_bytes(read_part(parts.front(), stream));
      checkpoint.path       = path;
      checkpoint.parts.assign(parts.begin() + 1, parts.end());
      checkpoint.n_ranks = checkpoint.parts.size();
      return checkpoint;
    }



    /**
     * Reads a file without the nodes, and looks at all of it, to see that it is
     * whole. Collective; each rank reads its share.
     *
     * @param fault out: what is wrong, without the path, or nothing; on all
     *   ranks
     */
    Checkpoint
    read_checkpoint_file(const std::string &path,
                         std::string       &fault,
                         const MPI_Comm     communicator)
    {
      Checkpoint checkpoint;
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
      fault = first_fault(fault, communicator);
      return checkpoint;
    }



    /**
     * Writes a file and waits until it would survive a loss of power.
     * Collective; each rank writes its nodes.
     *
     * @return on all ranks, what is wrong, with the path, or nothing
     */
    std::string
    write_checkpoint_file(const std::string &path,
                          const Checkpoint  &checkpoint,
                          const MPI_Comm     communicator)
    {
      std::vector<PartPlace> parts =
        Utilities::MPI::gather(communicator, describe(checkpoint.nodes));
      std::string before; // the parts of the ranks
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        {
          const std::string common = to_bytes(checkpoint);
          parts.insert(parts.begin(), describe(common));
          before = head_of(checkpoint, parts) + common;
        }
      const bool is_durable = true;
      return write_parallel_file(path,
                                 {before, checkpoint.nodes},
                                 communicator,
                                 is_durable);
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



  std::string
  read_nodes(const Checkpoint &checkpoint, const unsigned int rank)
  {
    std::ifstream stream = open_file(checkpoint.path);
    return read_part(checkpoint.parts[rank], stream);
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
