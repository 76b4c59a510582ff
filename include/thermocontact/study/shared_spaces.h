// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_shared_spaces_h
#define thermocontact_study_shared_spaces_h

#include <thermocontact/space/assembled_space.h>

#include <memory>
#include <tuple>

namespace ThermoContact
{
  /**
   * Mesh, spaces and matrices of the run of a study that was last, for the next
   * one if that has the same. One of a single dimension is kept at a time, so
   * that a study needs no more memory than its runs.
   */
  class SharedSpaces
  {
  public:
    /** The spaces of @p scene, on this rank alone; until the next call. */
    template <int dim>
    const AssembledSpace<dim> &
    get(const SpatialScene &scene)
    {
      auto &kept = std::get<dim - 1>(all_kept);
      if (!kept || !(kept->scene == scene))
        {
          all_kept = decltype(all_kept)();
          kept =
            std::make_unique<const AssembledSpace<dim>>(scene, MPI_COMM_SELF);
        }
      return *kept;
    }

  private:
    std::tuple<std::unique_ptr<const AssembledSpace<1>>,
               std::unique_ptr<const AssembledSpace<2>>,
               std::unique_ptr<const AssembledSpace<3>>>
      all_kept;
  };
} // namespace ThermoContact

#endif
