// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_plausibility_h
#define thermocontact_input_plausibility_h

#include <thermocontact/input/parameter_text.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * What is said of numbers of a file in SI units that hardly are in the SI
   * base unit that they are read in, with the unit that was probably meant. A
   * number with its unit is not doubted.
   */
  std::vector<std::string>
  implausible_numbers(const std::vector<Assignment> &assignments);
} // namespace ThermoContact

#endif
