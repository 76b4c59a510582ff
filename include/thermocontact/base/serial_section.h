// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_serial_section_h
#define thermocontact_base_serial_section_h

#include <thermocontact/base/exceptions.h>

#include <deal.II/base/mpi.h>

namespace ThermoContact
{
  /** How something that one rank does may end. */
  enum class Outcome : int
  {
    done,
    wrong_input, ///< InputError
    failed       ///< ComputationError
  };



  /**
   * Tells @p outcome of rank 0 to the others, which sleep until then and stay
   * alive if they are asked to end. Collective.
   */
  Outcome
  share_outcome(const Outcome outcome, const MPI_Comm communicator);



  /**
   * Rank 0 calls @p action, which may use no other rank; the others wait for
   * its end. Collective.
   *
   * @throw what the action throws, InputError or ComputationError, on all
   *   ranks; the message is known on rank 0
   */
  template <typename Action>
  void
  serial_section(const Action &action, const MPI_Comm communicator)
  {
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          action();
          share_outcome(Outcome::done, communicator);
          return;
        }
      catch (const InputError &)
        {
          share_outcome(Outcome::wrong_input, communicator);
          throw;
        }
      catch (const ComputationError &)
        {
          share_outcome(Outcome::failed, communicator);
          throw;
        }
    switch (share_outcome(Outcome::done, communicator))
      {
        case Outcome::done:
          return;
        case Outcome::wrong_input:
          throw InputError("rank 0 tells what is wrong");
        case Outcome::failed:
          throw ComputationError("rank 0 tells what has failed");
      }
  }
} // namespace ThermoContact

#endif
