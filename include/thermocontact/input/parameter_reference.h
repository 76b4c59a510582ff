// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_parameter_reference_h
#define thermocontact_input_parameter_reference_h

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>

namespace ThermoContact
{
  /**
   * Writes the reference of all entries as a page of Markdown that GitHub and
   * Doxygen render alike: a section for each subsection, a row for each entry
   * with name, default, allowed values and meaning. Present values do not
   * matter. The page of the present program is doc/parameters.md.
   */
  void
  write_parameter_reference(const dealii::ParameterHandler &prm,
                            std::ostream                   &output);
} // namespace ThermoContact

#endif
