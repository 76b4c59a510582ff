// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/atomic_file.h>
#include <thermocontact/base/collective_errors.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/base/table_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace ThermoContact
{
  using namespace dealii;

  namespace
  {
    /** A file open for writing, closed at the end of its life. */
    class Descriptor
    {
    public:
      Descriptor(const std::string &path, const int flags)
        : path(path)
      {
        do
          number = open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
        while (number < 0 && errno == EINTR);
        if (number < 0)
          fault = file_fault(path, "cannot be opened");
      }

      ~Descriptor()
      {
        if (number >= 0)
          close(number);
      }

      Descriptor(const Descriptor &) = delete;
      Descriptor &
      operator=(const Descriptor &) = delete;

      void
      write(const std::string_view bytes, const std::uint64_t begin)
      {
        std::size_t n = 0;
        while (fault.empty() && n < bytes.size())
          {
            const ssize_t written =
              pwrite(number, bytes.data() + n, bytes.size() - n, begin + n);
            if (written >= 0)
              n += written;
            else if (errno != EINTR)
              fault = file_fault(path, "cannot be written");
          }
      }

      void
      sync()
      {
        if (fault.empty() && fsync(number) != 0)
          fault = file_fault(path, "cannot be written to the disk");
      }

      std::string fault;

    private:
      const std::string path;
      int               number;
    };



    /** Bytes of the ranks before this one. */
    std::uint64_t
    begin_of_part(const std::uint64_t size, const MPI_Comm communicator)
    {
      std::uint64_t end = 0;
      const int     fault =
        MPI_Scan(&size, &end, 1, MPI_UINT64_T, MPI_SUM, communicator);
      AssertThrowMPI(fault);
      return end - size;
    }
  } // namespace



  std::string
  write_parallel_file(const std::string                   &path,
                      const std::vector<std::string_view> &part,
                      const MPI_Comm                       communicator,
                      const bool                           is_durable)
  {
    std::uint64_t size = 0;
    for (const std::string_view piece : part)
      size += piece.size();
    std::uint64_t begin = begin_of_part(size, communicator);

    // The first rank makes the file, so that nothing of an older one is left.
    std::string fault;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      fault = Descriptor(path, O_CREAT | O_TRUNC).fault;
    fault = first_fault(fault, communicator);
    if (!fault.empty())
      return fault;

    Descriptor file(path, 0);
    for (const std::string_view piece : part)
      {
        file.write(piece, begin);
        begin += piece.size();
      }
    if (is_durable)
      file.sync();
    return first_fault(file.fault, communicator);
  }



  std::string
  write_parallel_file_atomically(const std::string                   &path,
                                 const std::vector<std::string_view> &part,
                                 const MPI_Comm communicator)
  {
    std::string fault =
      write_parallel_file(path + part_suffix, part, communicator);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      fault = put_in_place(path, fault);
    return first_fault(fault, communicator);
  }
} // namespace ThermoContact
