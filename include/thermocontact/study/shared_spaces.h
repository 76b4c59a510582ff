// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_shared_spaces_h
#define thermocontact_study_shared_spaces_h

#include <thermocontact/scene/spatial_entries.h>
#include <thermocontact/space/assembled_space.h>
#include <thermocontact/study/scene_reader.h>

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
    /**
     * Those of the scene with @p overrides, on this rank alone; until the next
     * call.
     *
     * @param parameters of that scene
     * @throw InputError if an expression cannot be evaluated
     */
    template <int dim>
    const AssembledSpace<dim> &
    get(const Parameters &parameters, const Overrides &overrides)
    {
      Overrides spatial;
      for (const auto &[path, value] : overrides)
        if (changes_matrices(path))
          spatial.emplace_back(path, value);
      auto &kept = std::get<dim - 1>(all_kept);
      if (!kept || present != spatial)
        {
          all_kept = decltype(all_kept)();
          kept     = std::make_unique<const Kept<dim>>(parameters);
          present  = spatial;
        }
      return kept->space;
    }

  private:
    template <int dim>
    struct Kept
    {
      explicit Kept(const Parameters &parameters)
        : scene(parameters)
        , space(scene, MPI_COMM_SELF)
      {}

      const Scene               scene;
      const AssembledSpace<dim> space;
    };

    /** Overrides that change matrices, of what is kept. */
    Overrides present;
    std::tuple<std::unique_ptr<const Kept<1>>,
               std::unique_ptr<const Kept<2>>,
               std::unique_ptr<const Kept<3>>>
      all_kept;
  };
} // namespace ThermoContact

#endif
