// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective_errors.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/output/checkpoint_file.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/crc.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace ThermoContact
{
  namespace
  {
    /** Changes whenever an older program could not read the file. */
    const std::string format = "thermocontact checkpoint 9";



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
  } // namespace



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



  std::string
  read_nodes(const Checkpoint &checkpoint, const unsigned int rank)
  {
    std::ifstream stream = open_file(checkpoint.path);
    return read_part(checkpoint.parts[rank], stream);
  }



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
} // namespace ThermoContact
