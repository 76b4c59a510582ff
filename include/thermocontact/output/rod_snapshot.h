// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_rod_snapshot_h
#define thermocontact_output_rod_snapshot_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/point_values.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Snapshots of a rod of few cells as VTU files: the points, cells and arrays
   * of FieldOutput, in single precision, as binary data without compression.
   * That of deal.II sets up a compression of 300 kB for each array, ten times
   * the work of all else. For files of the size of a disk block.
   */
  class RodSnapshot
  {
  public:
    /**
     * Whether a body has such files: not a static one, whose velocity at first
     * is NaN in PointValues.
     */
    static bool
    is_for(const Body<1> &body);

    /** @param body one for which it is, borrowed */
    explicit RodSnapshot(const Body<1> &body);

    /** The file of a state, snapshot number @p cycle. */
    std::string
    file(const State &state, const unsigned int cycle);

  private:
    const SceneFields          &fields;
    const std::vector<Place<1>> places; ///< points, cell by cell
    PointValues<1>              point_values;
    std::string                 cells; ///< points and cells
  };
} // namespace ThermoContact

#endif
