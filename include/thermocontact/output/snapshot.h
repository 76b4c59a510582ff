// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_snapshot_h
#define thermocontact_output_snapshot_h

#include <thermocontact/output/output_units.h>
#include <thermocontact/space/discretization.h>

#include <deal.II/base/data_out_base.h>

#include <deal.II/numerics/data_out.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** Rows of the stress in space; that of a rod is a scalar. */
  template <int dim>
  constexpr unsigned int n_rows = dim == 1 ? 1 : 3;

  template <int dim>
  constexpr unsigned int n_stresses = n_rows<dim> *n_rows<dim>;



  /**
   * DataOut whose part of a file can be had as text, and in which the stress,
   * n_stresses scalars of that name, is a tensor in space whatever the
   * dimension of the mesh.
   */
  template <int dim>
  class Snapshot : public DataOut<dim>
  {
  public:
    /**
     * This rank's part of a VTU file, without header and footer: pieces of some
     * cells each, since patches need several times the memory of the fields.
     */
    std::vector<std::string>
    vtu_pieces(const Discretization<dim>   &discretization,
               const DataOutBase::VtkFlags &flags,
               const OutputUnits           &units);

  private:
    /** None without patches: ParaView does not read a file that starts so. */
    std::string
    vtu_piece(const DataOutBase::VtkFlags &flags,
              const OutputUnits           &units) const;
  };
} // namespace ThermoContact

#endif
