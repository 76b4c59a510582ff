// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/long_message.h>
#include <thermocontact/base/table_file.h>
#include <thermocontact/output/checkpoint_file.h>
#include <thermocontact/output/output_directory.h>

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
#include <sstream>
#include <stdexcept>

namespace ThermoContact
{
  namespace
  {
    /** Changes whenever an older program could not read the file. */
    const std::string format = "thermocontact checkpoint 4";



    /** What the line of JSON says of a part. */
    struct Part
    {
      std::uint64_t size;
      std::uint32_t checksum;
    };

    Part
    describe(const std::string &bytes)
    {
      boost::crc_32_type crc;
      crc.process_bytes(bytes.data(), bytes.size());
      return {bytes.size(), crc.checksum()};
    }



    /** All but what the ranks have saved. */
    template <class Archive, class AnyCheckpoint>
    void
    archive_common(Archive &archive, AnyCheckpoint &checkpoint)
    {
      archive &checkpoint.time &checkpoint.step &checkpoint.version &checkpoint
        .parameters &checkpoint.output;
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
    head_of(const Checkpoint &checkpoint, const std::vector<Part> &parts)
    {
      nlohmann::ordered_json header = {{"time", checkpoint.time},
                                       {"step", checkpoint.step},
                                       {"ranks", checkpoint.n_ranks},
                                       {"version", checkpoint.version},
                                       {"parts", nlohmann::json::array()}};
      for (const Part &part : parts)
        header["parts"].push_back(
          {{"size", part.size}, {"checksum", part.checksum}});
      return format + '\n' + header.dump() + '\n';
    }



    /** Reads the lines before the parts. */
    std::vector<Part>
    read_head(std::istream &stream)
    {
      std::string line(format.size() + 1, '\0');
      stream.read(line.data(), line.size());
      if (line != format + '\n')
        throw std::runtime_error("it does not begin with '" + format +
                                 "': not a checkpoint, or of another version "
                                 "of thermocontact");
      std::getline(stream, line);
      const auto        header = nlohmann::json::parse(line);
      std::vector<Part> parts;
      for (const auto &part : header.at("parts"))
        parts.push_back({part.at("size"), part.at("checksum")});
      return parts;
    }



    /** Reads a part and drops it; says whether it is as it was written. */
    bool
    is_whole(const Part &part, std::istream &stream)
    {
      boost::crc_32_type crc;
      std::string        piece(1 << 16, '\0');
      std::uint64_t      n = 0;
      while (n < part.size && stream)
        {
          stream.read(piece.data(),
                      std::min<std::uint64_t>(piece.size(), part.size - n));
          crc.process_bytes(piece.data(), stream.gcount());
          n += stream.gcount();
        }
      return n == part.size && crc.checksum() == part.checksum;
    }
  } // namespace



  CheckpointFile
  open_checkpoint_file(const std::string &path)
  {
    CheckpointFile file{path, "", {}, std::ifstream(path, std::ios::binary)};
    std::ifstream &stream = file.stream;
    if (!stream)
      throw std::runtime_error(std::string("it cannot be opened: ") +
                               std::strerror(errno));
    const std::vector<Part> parts   = read_head(stream);
    const auto              begin   = stream.tellg();
    bool                    is_good = !parts.empty();
    for (const Part &part : parts)
      is_good = is_good && is_whole(part, stream);
    if (!is_good || stream.peek() != std::ifstream::traits_type::eof())
      throw std::runtime_error("it is damaged: size or checksum is wrong");

    stream.clear();
    stream.seekg(begin);
    file.common.resize(parts.front().size);
    stream.read(file.common.data(), file.common.size());
    from_bytes(file.common);
    for (auto part = parts.begin() + 1; part != parts.end(); ++part)
      file.sizes.push_back(part->size);
    return file;
  }



  Checkpoint
  read_checkpoint_file(CheckpointFile &file, const MPI_Comm communicator)
  {
    Checkpoint checkpoint =
      from_bytes(Utilities::MPI::broadcast(communicator, file.common));
    checkpoint.n_ranks =
      Utilities::MPI::broadcast(communicator,
                                static_cast<unsigned int>(file.sizes.size()));
    if (checkpoint.n_ranks != Utilities::MPI::n_mpi_processes(communicator))
      return checkpoint;

    const unsigned int this_rank =
      Utilities::MPI::this_mpi_process(communicator);
    for (unsigned int rank = 0; rank < checkpoint.n_ranks; ++rank)
      {
        std::string part = send_from_first(
          rank,
          this_rank == 0 ? file.sizes[rank] : 0,
          [&file](char *piece, const std::size_t size) {
            file.stream.read(piece, size);
          },
          communicator);
        if (rank == this_rank)
          checkpoint.simulation = std::move(part);
      }
    std::string fault;
    if (file.stream.fail()) // on rank 0, where it is open
      fault = file.path + ": cannot be read to its end\n  remedy:  check the "
                          "disk, and leave the files of a run as they are";
    throw_everywhere<InputError>(fault, communicator);
    return checkpoint;
  }



  std::string
  write_checkpoint_file(const std::string &path,
                        const Checkpoint  &checkpoint,
                        const MPI_Comm     communicator)
  {
    std::vector<Part> parts =
      Utilities::MPI::gather(communicator, describe(checkpoint.simulation));
    TableFile file;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        const std::string common = to_bytes(checkpoint);
        parts.insert(parts.begin(), describe(common));
        file.open(path);
        file.write_row(head_of(checkpoint, parts) + common);
      }
    for (unsigned int rank = 0; rank < checkpoint.n_ranks; ++rank)
      send_to_first(
        rank,
        checkpoint.simulation,
        [&file](const std::string_view piece) {
          file.write_row(piece.data(), piece.size());
        },
        communicator);
    return file.sync();
  }
} // namespace ThermoContact
