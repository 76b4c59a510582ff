// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_serial_section_h
#define thermocontact_base_serial_section_h

#include <thermocontact/base/exceptions.h>

#include <deal.II/base/mpi.h>

namespace ThermoContact
{
  /**
   * Tells the exit status of rank 0 to the others, which sleep until then and
   * stay alive if they are asked to end. Collective.
   */
  int
  share_status(const int status, const MPI_Comm communicator);



  /**
   * Rank 0 calls @p action, which may use no other rank; the others wait for
   * its end. Collective.
   *
   * @throw InputError or ComputationError of the action, on all ranks; the
   * message is known on rank 0
   */
  template <typename Action>
  void
  serial_section(const Action &action, const MPI_Comm communicator)
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          action();
          share_status(0, communicator);
          return;
        }
      catch (const InputError &)
        {
          share_status(2, communicator);
          throw;
        }
      catch (const ComputationError &)
        {
          share_status(1, communicator);
          throw;
        }
    const int status = share_status(0, communicator);
    if (status == 2)
      throw InputError("rank 0 tells what is wrong");
    if (status == 1)
      throw ComputationError("rank 0 tells what has failed");
  }
} // namespace ThermoContact

#endif
