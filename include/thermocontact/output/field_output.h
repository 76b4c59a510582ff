// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_field_output_h
#define thermocontact_output_field_output_h

#include <thermocontact/output/output_units.h>
#include <thermocontact/output/snapshot_series.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <deal.II/base/timer.h>

#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Snapshots of temperature, displacement, velocity and stress for ParaView:
   * fields/fields-NNNNN.vtu and fields.pvd with their times, each file written
   * by all ranks together. If dim > 1 and there is an obstacle, the contact end
   * is beside them, fields/contact-NNNNN.vtu and contact.pvd.
   *
   * Fields that the scene does not have are absent. An obstacle with a shape is
   * beside them, obstacle.vtu, written with the first snapshot; one that moves,
   * of a body, in fields/obstacle-NNNNN.vtu and obstacle.pvd.
   */
  template <int dim>
  class FieldOutput
  {
  public:
    /** @p directory exists; @p body is borrowed. */
    FieldOutput(const std::string &directory, const Body<dim> &body);

    /**
     * Writes one snapshot. Collective.
     *
     * @throw ComputationError naming the file if it cannot be written
     */
    void
    write(const State &state);

    /**
     * The PVD files list all snapshots; to be called at the end of a run, and
     * of one that fails. Replacing them costs more than a small snapshot, so
     * that write() does it for the first one, and then once a second.
     *
     * @param only_due nothing within a second of the last time
     * @return the fault, with the path, or nothing; on this rank
     */
    std::string
    write_lists(const bool only_due = false);

    /** Times of the snapshots so far. */
    const std::vector<double> &
    times() const
    {
      return fields.times();
    }

    /**
     * Goes on behind the snapshots at @p times, which an earlier run has
     * written. Collective.
     *
     * @throw ComputationError if the PVD file cannot be written
     */
    void
    restore(const std::vector<double> &times);

    /**
     * The snapshots so far survive a loss of power; returns the fault, on
     * all ranks. Collective.
     */
    std::string
    sync();

  private:
    const std::string             directory;
    const Body<dim>              &body;
    const Discretization<dim>    &discretization;
    const bool                    is_writer;
    const OutputUnits             units;
    SnapshotSeries                fields;
    std::optional<SnapshotSeries> contact_face;       ///< if there is one
    std::optional<SnapshotSeries> obstacle;           ///< if it moves
    const std::shared_ptr<dealii::Function<dim>> gap; ///< of an obstacle
    Timer                                        since_lists;

    /** All, as far as they are there. */
    std::vector<SnapshotSeries *>
    all_series();

    /** Writes the file of the fields; returns the fault. Collective. */
    std::string
    write_fields(const State &state);

    /**
     * Writes the small files: contact end, obstacle, PVD files. Rank 0 does;
     * returns the fault, or nothing. Collective.
     */
    std::string
    write_others(const State &state);
  };
} // namespace ThermoContact

#endif
