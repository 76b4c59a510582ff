// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_box_limits_h
#define thermocontact_scene_box_limits_h

#include <thermocontact/input/parameters.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** An entry that stands against the scheme without dispersion. */
  struct BoxLimit
  {
    std::string entry; ///< path and value, or the range of the value

    /** What to write instead; empty: the scheme can have the entry, but is not
     * chosen beside it. */
    std::string remedy;
  };



  /** The entries of a scene that Time/Scheme = automatic and check_scene() hold
   * against Scheme::has_no_dispersion; empty: there are none. */
  std::vector<BoxLimit>
  limits_of_box(const Parameters &parameters);
} // namespace ThermoContact

#endif
