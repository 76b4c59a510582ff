// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_output_reference_h
#define thermocontact_report_output_reference_h

#include <string>

namespace ThermoContact
{
  /** The page doc/output.md, in Markdown. */
  std::string
  output_reference();
} // namespace ThermoContact

#endif
