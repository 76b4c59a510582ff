// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_field_output_h
#define thermocontact_output_field_output_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <deal.II/base/data_out_base.h>

#include <deal.II/lac/trilinos_parallel_block_vector.h>

#include <string>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /**
   * Snapshots of temperature, displacement, velocity and stress for ParaView:
   * fields/fields-NNNNN.vtu and fields.pvd with their times. The PVD file is
   * replaced in one piece after each snapshot, so that it can be opened while
   * the run goes on.
   *
   * Cells of degree p are cut into p parts along each direction. The stress is
   * $C\varepsilon(u+\zeta v)-a\theta I$, if dim > 1 a tensor in space. Fields
   * that the scene does not have are absent. An obstacle with a shape is beside
   * them, obstacle.vtu, written with the first snapshot.
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

    /** Times of the snapshots so far. */
    const std::vector<double> &
    times() const
    {
      return times_;
    }

    /**
     * Goes on behind the snapshots at @p times, which an earlier run has
     * written. Collective.
     *
     * @throw ComputationError if the PVD file cannot be written
     */
    void
    restore(const std::vector<double> &times);

    /** The snapshots so far survive a loss of power; returns what is wrong. */
    std::string
    sync();

  private:
    const std::string          directory;
    const Body<dim>           &body;
    const Discretization<dim> &discretization;
    std::vector<double>        times_;
    unsigned int               n_synced = 0; ///< snapshots

    /**
     * Both fields in one vector. By blocks: DataOut takes other vectors only if
     * the owned indices are contiguous.
     */
    BlockVector
    joined(const Vector &temperature, const Vector &displacement) const;

    /**
     * Writes a snapshot from the parts of all ranks, and the PVD file. Rank 0
     * does; returns what is wrong, or nothing.
     */
    std::string
    write_files(const double                    time,
                const std::vector<std::string> &pieces,
                const DataOutBase::VtkFlags    &flags);

    /** Returns what is wrong, or nothing. On one rank. */
    std::string
    write_pvd(const std::string &path) const;
  };
} // namespace ThermoContact

#endif
