// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_rod_snapshot_h
#define thermocontact_output_rod_snapshot_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <deal.II/lac/full_matrix.h>

#include <string>

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
     * Whether a body has such files.
     *
     * @param body of a rod, whose nodes are numbered from one end to the other
     */
    static bool
    is_for(const Body<1> &body);

    /** @param body one for which it is, borrowed */
    explicit RodSnapshot(const Body<1> &body);

    /** The file of a state, snapshot number @p cycle. */
    std::string
    file(const State &state, const unsigned int cycle) const;

  private:
    const Body<1>      &body;
    const RodLayout     layout;
    FullMatrix<double>  values; ///< of nodes at equidistant points of a cell
    FullMatrix<double>  derivatives; ///< the same, over the length of the cell
    std::vector<double> vertices;
    std::string         cells; ///< points and cells

    /** Values of nodes or derivatives along the rod at the points of cells. */
    std::vector<double>
    at_points(const Vector             &nodes,
              const FullMatrix<double> &matrix,
              const bool                is_derivative) const;
  };
} // namespace ThermoContact

#endif
