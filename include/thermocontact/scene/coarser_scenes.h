// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_coarser_scenes_h
#define thermocontact_scene_coarser_scenes_h

#include <thermocontact/input/parameters.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** A scene that differs from another one in what its accuracy depends on. */
  struct CoarserScene
  {
    Parameters  parameters;
    std::string words; ///< the entries that differ, "Section/Entry = value"

    /** In time: of the difference in the error bar, (D9.3). */
    double weight = 1.;

    /** In space: no error is trusted to fall faster from this mesh on, (D9.4).
     */
    double smallest_rate = 0.;

    /** Its steps are larger, too, by as much as its cells, (D9.5). */
    bool has_coarser_steps = false;
  };



  /**
   * Scenes with larger steps, whose differences to @p parameters tell the error
   * in time; with smaller ones where larger ones are not allowed, or tell
   * little.
   * None where space and time cannot be told apart, because steps and cells
   * belong together.
   */
  std::vector<CoarserScene>
  coarser_in_time(const Parameters &parameters);

  /**
   * One scene on a coarser mesh, and one on a mesh that is coarser still, if
   * there is one; none if there is no coarser mesh.
   */
  std::vector<CoarserScene>
  coarser_in_space(const Parameters &parameters);

  /** Why error bars have no repeats, or nothing. */
  std::string
  reason_for_no_repeats(const Parameters &parameters);

  /** Which they are, and what they cost, for the screen. */
  std::string
  describe_repeats(const Parameters &parameters);
} // namespace ThermoContact

#endif
