// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_output_page_h
#define thermocontact_output_output_page_h

namespace ThermoContact
{
  /**
   * The page doc/output.md: the contents of each file of an output directory.
   * The only list of columns, keys and arrays with their kinds of quantities,
   * by which they have their units: a heading of the second level is the name
   * of a file, a row of its table has a name, its kind and its meaning.
   */
  extern const char *const output_page;
} // namespace ThermoContact

#endif
