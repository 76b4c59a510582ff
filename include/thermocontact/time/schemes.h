// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_schemes_h
#define thermocontact_time_schemes_h

#include <thermocontact/method/scheme.h>

#include <vector>

namespace ThermoContact
{
  // The schemes of each integrator, defined in its file. To add one: a file
  // that defines an integrator and its scheme, and its name in the list of
  // schemes.cc.

  /** One for each Butcher tableau. */
  std::vector<Scheme>
  dirk_schemes();

  /** The midpoint rule of doc/contact-in-time.md section 6. */
  Scheme
  energy_conserving_scheme();

  /** The one without dispersion there. */
  Scheme
  box_scheme();
} // namespace ThermoContact

#endif
