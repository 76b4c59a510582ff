// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/long_message.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <limits>

namespace ThermoContact
{
  using namespace dealii;

  static_assert(largest_piece <= std::numeric_limits<int>::max());

  namespace
  {
    constexpr int tag = 1117; // messages of a pair of ranks keep their order



    void
    send(const void        *data,
         const std::size_t  size,
         const unsigned int receiver,
         const MPI_Comm     communicator)
    {
      const int fault =
        MPI_Send(data, size, MPI_BYTE, receiver, tag, communicator);
      AssertThrowMPI(fault);
    }



    void
    receive(void              *data,
            const std::size_t  size,
            const unsigned int sender,
            const MPI_Comm     communicator)
    {
      const int fault = MPI_Recv(
        data, size, MPI_BYTE, sender, tag, communicator, MPI_STATUS_IGNORE);
      AssertThrowMPI(fault);
    }



    /** Calls @p what with begin and size of one piece after the other. */
    template <typename Function>
    void
    for_each_piece(const std::uint64_t size,
                   const std::size_t   piece_size,
                   const Function     &what)
    {
      for (std::uint64_t begin = 0; begin < size; begin += piece_size)
        what(begin, std::min<std::uint64_t>(piece_size, size - begin));
    }
  } // namespace



  void
  send_to_first(const unsigned int                           sender,
                const std::string_view                       bytes,
                const std::function<void(std::string_view)> &take,
                const MPI_Comm                               communicator,
                const std::size_t                            piece_size)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    std::uint64_t      size = bytes.size();
    if (rank == 0 && sender == 0)
      for_each_piece(size, piece_size, [&](const auto begin, const auto n) {
        take(bytes.substr(begin, n));
      });
    else if (rank == 0)
      {
        receive(&size, sizeof(size), sender, communicator);
        std::string piece(std::min<std::uint64_t>(size, piece_size), '\0');
        for_each_piece(size, piece_size, [&](const auto, const auto n) {
          receive(piece.data(), n, sender, communicator);
          take(std::string_view(piece.data(), n));
        });
      }
    else if (rank == sender)
      {
        send(&size, sizeof(size), 0, communicator);
        for_each_piece(size, piece_size, [&](const auto begin, const auto n) {
          send(bytes.data() + begin, n, 0, communicator);
        });
      }
  }

} // namespace ThermoContact
