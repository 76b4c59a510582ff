// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_load_breaks_h
#define thermocontact_method_load_breaks_h

#include <thermocontact/method/load_samples.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Where a load jumps, to the last digit, and where its slope does, in order.
   *
   * @throw UnresolvedLoad if there are too many
   */
  std::vector<LoadBreak>
  find_load_breaks(LoadSamples &samples);
} // namespace ThermoContact

#endif
