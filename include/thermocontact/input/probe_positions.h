// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_probe_positions_h
#define thermocontact_input_probe_positions_h

#include <array>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Reads Output/Probes: positions separated by ';', the coordinates of each by
   * ',', e.g. "0.25; 0.5; 1" or, if @p dim is 2, "0.5, 0.05; 1, 0.1".
   *
   * @param width of the body, the upper limit of y and z
   * @return the coordinates of each position, 0 beyond @p dim
   * @throw InputError if a position is malformed or not in the body
   */
  std::vector<std::array<double, 3>>
  parse_probe_positions(const std::string &text,
                        const unsigned int dim,
                        const double       width);
} // namespace ThermoContact

#endif
