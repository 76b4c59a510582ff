// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_long_message_h
#define thermocontact_base_long_message_h

#include <deal.II/base/mpi.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace ThermoContact
{
  /**
   * Bytes of a piece of a long message. MPI counts the bytes of one message,
   * and MPI_Gatherv those of all ranks together, in an int.
   */
  constexpr std::size_t largest_piece = 1 << 22;

  /**
   * Hands bytes of one rank to rank 0, as many as memory holds. They travel in
   * pieces, of which rank 0 needs to hold only one. All ranks call it, the
   * messages in the same order; those that take no part return at once.
   *
   * @param sender may be 0: then nothing travels
   * @param bytes of the sender; not used elsewhere
   * @param take is called on rank 0 with one piece after the other; must not
   *   throw, since the sender would wait for ever
   */
  void
  send_to_first(const unsigned int                           sender,
                const std::string_view                       bytes,
                const std::function<void(std::string_view)> &take,
                const MPI_Comm                               communicator,
                const std::size_t piece_size = largest_piece);

  /**
   * Hands an object of one rank to rank 0: whatever boost archives of it is the
   * sender's then, the rest stays. All ranks call it, as send_to_first().
   */
  template <typename Object>
  void
  send_object_to_first(const unsigned int sender,
                       Object            &object,
                       const MPI_Comm     communicator)
  {
    if (sender == 0)
      return;
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(communicator);
    std::stringstream stream;
    if (rank == sender)
      boost::archive::binary_oarchive(stream, boost::archive::no_header)
        << std::as_const(object);
    send_to_first(
      sender,
      stream.str(),
      [&stream](const std::string_view piece) { stream << piece; },
      communicator);
    if (rank == 0)
      boost::archive::binary_iarchive(stream, boost::archive::no_header) >>
        object;
  }
} // namespace ThermoContact

#endif
