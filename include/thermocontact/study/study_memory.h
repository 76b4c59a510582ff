// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_study_memory_h
#define thermocontact_study_study_memory_h

#include <thermocontact/scene/scene.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * What the runs of a study are expected to take of the memory of a machine:
   * each rank there has one under way, the largest ones at the same time if it
   * comes to the worst; or the reference, alone.
   */
  class StudyMemory
  {
  public:
    /** @param run its name in messages; each on one rank */
    void
    add(const std::string &run, const Scene &scene);

    void
    add_reference(const Scene &scene);

    /**
     * Lines for the screen: it beside the memory of the machine whose ranks
     * have the least, and a warning if that is less; nothing if all runs are
     * rods. Collective.
     *
     * @throw InputError if it would not be enough were the forecast twice too
     *   large
     */
    std::string
    report(const MPI_Comm communicator) const;

  private:
    struct Run
    {
      std::string name;
      double      bytes;
    };

    std::vector<Run> runs;
    double           bytes_of_reference = 0.;
    bool             has_bodies         = false;

    double
    expected(const Scene &scene);
  };
} // namespace ThermoContact

#endif
