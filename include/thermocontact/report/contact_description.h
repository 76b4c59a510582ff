// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_contact_description_h
#define thermocontact_report_contact_description_h

#include <thermocontact/simulation/simulation.h>

#include <string>

namespace ThermoContact
{
  /** Law, gaps and contact nodes of a scene, for the screen. */
  template <int dim>
  std::string
  describe_contact(const Simulation<dim> &simulation);
} // namespace ThermoContact

#endif
