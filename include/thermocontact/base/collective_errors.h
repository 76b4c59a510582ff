// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_collective_errors_h
#define thermocontact_base_collective_errors_h

#include <deal.II/base/mpi.h>

#include <string>

namespace ThermoContact
{
  /** On all ranks, the message of the first rank that has one. Collective. */
  inline std::string
  first_fault(const std::string &fault, const MPI_Comm communicator)
  {
    for (const std::string &message :
         dealii::Utilities::MPI::all_gather(communicator, fault))
      if (!message.empty())
        return message;
    return "";
  }

  /**
   * Throws on all ranks if the message of rank 0 is not empty. Collective.
   *
   * @throw Error (InputError or ComputationError) with that message
   */
  template <typename Error>
  void
  throw_everywhere(const std::string &message, const MPI_Comm communicator)
  {
    const std::string shared =
      dealii::Utilities::MPI::broadcast(communicator, message);
    if (!shared.empty())
      throw Error(shared);
  }
} // namespace ThermoContact

#endif
