// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>

namespace ThermoContact
{
  std::vector<std::string>
  all_gather(const MPI_Comm communicator, const std::string &bytes)
  {
    if (is_alone(communicator)) // theirs compresses
      return {bytes};
    return dealii::Utilities::MPI::all_gather(communicator, bytes);
  }



  std::string
  broadcast(const MPI_Comm     communicator,
            const std::string &bytes,
            const unsigned int root)
  {
    if (is_alone(communicator))
      return bytes;
    return dealii::Utilities::MPI::broadcast(communicator, bytes, root);
  }



  std::string
  first_fault(const std::string &fault, const MPI_Comm communicator)
  {
    for (const std::string &message : all_gather(communicator, fault))
      if (!message.empty())
        return message;
    return "";
  }
} // namespace ThermoContact
