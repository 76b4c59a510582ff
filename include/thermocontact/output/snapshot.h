// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_snapshot_h
#define thermocontact_output_snapshot_h

#include <thermocontact/output/output_units.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Temperature, displacement, velocity and stress of a state as this rank's
   * part of a VTU file, without header and footer: pieces of some cells each,
   * since patches need several times the memory of the fields. Cells of degree
   * p are cut into p parts along each direction. The stress is
   * $C\varepsilon(u+\zeta v)-a\theta I$, if dim > 1 a tensor in space.
   *
   * @param cycle number of the snapshot
   */
  template <int dim>
  std::vector<std::string>
  snapshot_pieces(const Body<dim>   &body,
                  const State       &state,
                  const unsigned int cycle,
                  const OutputUnits &units);
} // namespace ThermoContact

#endif
