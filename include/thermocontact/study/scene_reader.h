// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_scene_reader_h
#define thermocontact_study_scene_reader_h

#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameters.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** Paths "Section/Entry" and the values that they have in one run. */
  using Overrides = std::vector<std::pair<std::string, std::string>>;



  /**
   * Scenes that differ from one by overrides, one after the other. To declare
   * the entries of a scene and to list them costs as much as a short run; this
   * does it once. Each scene is the same, bit for bit, as one that is read
   * alone.
   */
  class SceneReader
  {
  public:
    /**
     * @param assignments of the scene without overrides
     * @throw InputError as assign_entries()
     */
    explicit SceneReader(const std::vector<Assignment> &assignments);

    SceneReader(const SceneReader &) = delete; // prm_ is bound to scene_

    /**
     * Makes scene() the one with @p overrides, whatever it was before.
     *
     * @param place that messages give for them
     * @throw InputError as assign_entries()
     */
    void
    read(const std::string &place, const Overrides &overrides);

    /** As it was read last; until the next read(). */
    const Parameters &
    scene() const
    {
      return scene_;
    }

    /** Bound to scene(). */
    ParameterHandler &
    prm()
    {
      return prm_;
    }

    /** The statements that it was read from. */
    const std::vector<Assignment> &
    assignments() const
    {
      return assignments_;
    }

    /** The value of an entry in the scene without overrides. */
    const std::string &
    own_value(const std::string &path) const;

  private:
    const std::vector<Assignment> own_assignments;
    std::vector<Assignment>       assignments_;
    Parameters                    scene_;
    ParameterHandler              prm_;
    Parameters                    own_scene;
    std::vector<DeclaredEntry>    own_entries;
    std::set<std::string>         changed; ///< paths; empty: perhaps all
  };
} // namespace ThermoContact

#endif
