// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/base/writable_file.h>

#include <cstdint>

namespace ThermoContact
{
  using namespace dealii;

  namespace
  {
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

    const bool   is_first = Utilities::MPI::this_mpi_process(communicator) == 0;
    WritableFile file;
    // Others wait for the first rank, so that nothing of an older one is left.
    if (is_first)
      file.open(path, true);
    if (const std::string fault = first_fault(file.fault(), communicator);
        !fault.empty())
      return fault;
    if (!is_first)
      file.open(path, false);
    for (const std::string_view piece : part)
      {
        file.write(piece, begin);
        begin += piece.size();
      }
    if (is_durable)
      file.sync();
    return first_fault(file.fault(), communicator);
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
