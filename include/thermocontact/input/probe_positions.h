// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_probe_positions_h
#define thermocontact_input_probe_positions_h

#include <thermocontact/input/parameters.h>

#include <array>

namespace ThermoContact
{
  /**
   * Reads Output/Probes: positions separated by ';', the coordinates of each by
   * ',', e.g. "0.25; 0.5; 1" or, in two dimensions, "0.5, 0.05; 1, 0.1".
   *
   * @return the coordinates of each position, 0 beyond the dimension
   * @throw InputError if a position is malformed or not in the body
   */
  std::vector<std::array<double, 3>>
  probe_positions(const Parameters &parameters);
} // namespace ThermoContact

#endif
