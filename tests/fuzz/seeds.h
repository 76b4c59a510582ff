// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_fuzz_seeds_h
#define thermocontact_fuzz_seeds_h

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Texts of files that the program accepts: those of prm, a scene of each rod
   * in units there, with its scales, bodies small enough for a few steps, and
   * files that hold all entries.
   */
  std::vector<std::string>
  valid_files();
} // namespace ThermoContact

#endif
