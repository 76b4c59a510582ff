// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_output_tables_h
#define thermocontact_output_output_tables_h

#include <string>
#include <vector>

namespace ThermoContact
{
  /** A column, a key or an array of the output, and what it says. */
  struct OutputTerm
  {
    std::string name; ///< '*' for what depends on the scene
    std::string kind; ///< of quantity, as OutputUnits has them
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

  /**
   * The kind of quantity of a column, key or array, as the table of its file
   * has it.
   */
  const std::string &
  kind_of(const std::string &file, const std::string &name);
} // namespace ThermoContact

#endif
