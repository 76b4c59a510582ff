// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_output_directory_h
#define thermocontact_output_output_directory_h

#include <thermocontact/base/types.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/scene/scheme_choice.h>

#include <deal.II/base/parameter_handler.h>

#include <set>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Looks whether prepare_output_directory() would refuse @p directory; changes
   * nothing. Collective, same exceptions.
   */
  void
  check_output_directory(const std::string &directory,
                         const MPI_Comm     communicator);

  /**
   * Makes @p directory ready for a run: creates it, or removes the files of an
   * earlier run (recognised by its used.prm). Collective.
   *
   * @throw InputError if the directory holds anything else, or cannot be
   *   created or emptied; nothing has been removed then
   */
  void
  prepare_output_directory(const std::string &directory,
                           const MPI_Comm     communicator);

  /**
   * Keeps other runs out of an output directory as long as it lives, also if
   * the program is killed. Where the file system has no locks nothing is kept
   * out.
   */
  class DirectoryLock
  {
  public:
    /**
     * Creates @p directory if it is not there, unless a run is to go on in it.
     * Collective.
     *
     * @throw InputError if it cannot be created, or another run has it
     */
    DirectoryLock(const std::string &directory,
                  const bool         must_exist,
                  const MPI_Comm     communicator);

    ~DirectoryLock();

    DirectoryLock(const DirectoryLock &) = delete;
    DirectoryLock &
    operator=(const DirectoryLock &) = delete;

  private:
    int descriptor = -1;
  };



  /**
   * Writes used.prm: all entries of @p prm, but @p directory as
   * Output/Directory, so that running the file again gives the same files. Rank
   * 0 writes; collective.
   *
   * @param omit paths of entries that are left out
   * @param assignments of the file: those in SI units stand as they are given,
   *   with their values in the scene behind them
   * @param choice of entries that are automatic, which stand as they are
   *   chosen, with the reason
   * @throw ComputationError if the file cannot be written
   */
  void
  write_used_parameters(const std::string             &directory,
                        const std::set<std::string>   &omit,
                        const ParameterHandler        &prm,
                        const std::vector<Assignment> &assignments,
                        const SchemeChoice            &choice,
                        const MPI_Comm                 communicator);
} // namespace ThermoContact

#endif
