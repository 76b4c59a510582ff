// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_output_reference_h
#define thermocontact_report_output_reference_h

#include <string>
#include <vector>

namespace ThermoContact
{
  /** A column, a key or an array of the output, and what it says. */
  struct OutputTerm
  {
    std::string name; ///< '*' for what depends on the scene
    std::string unit; ///< of one, as --units names scales; empty: a number
    std::string text; ///< one sentence or two, in Markdown
  };



  /** What a file of the output directory holds. */
  struct OutputTable
  {
    std::string             file;
    std::string             text; ///< what the file is, and when it is there
    std::string             kind; ///< column, key or array
    std::vector<OutputTerm> terms;
  };



  /** All files of an output directory that have names in them. */
  const std::vector<OutputTable> &
  output_tables();

  /** The page doc/output.md, in Markdown. */
  std::string
  output_reference();
} // namespace ThermoContact

#endif
