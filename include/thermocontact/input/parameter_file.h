// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_parameter_file_h
#define thermocontact_input_parameter_file_h

#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/parameter_text.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace ThermoContact
{
  using dealii::ParameterHandler;

  struct Parameters;



  /**
   * Sets one entry.
   *
   * @throw dealii::ExceptionBase if there is none, or the value does not fit
   */
  void
  set_entry(const Assignment &assignment, ParameterHandler &prm);

  /**
   * Writes @p assignments, those of a whole file, into @p prm. Of a file in SI
   * units the scene without units is written.
   *
   * @param parameters to which the entries of @p prm are bound
   * @return entries that follow from section Rod and are written beside them
   * @throw InputError with place, path, value, the allowed ones and the
   *   meaning of the entry if a section or a name is unknown (then with the
   * nearest known one), a value or its unit does not fit, or a file sets an
   * entry twice
   */
  std::vector<Assignment>
  assign_entries(const std::vector<Assignment> &assignments,
                 ParameterHandler              &prm,
                 Parameters                    &parameters);

  /**
   * Completes a message that begins with the path of an entry, by the place of
   * the last assignment to it (for a default value: the place of the
   * assignment that the message gives as its reason) and by the meaning of the
   * entry. A value in it is shown as the file has it, with its unit. Other
   * messages stay as they are.
   */
  std::string
  complete_message(const std::string             &message,
                   const std::vector<Assignment> &assignments,
                   const ParameterHandler        &prm);

  /** Path and present value of every entry. */
  std::map<std::string, std::string>
  entry_values(const ParameterHandler &prm);

  /** True for the same text or the same number. */
  bool
  equal_values(const std::string &a, const std::string &b);

  /**
   * Writes entries with their values as a parameter file.
   *
   * @param entries of a section one after the other
   * @param omit paths that are left out
   */
  void
  write_entries(const std::vector<DeclaredEntry> &entries,
                const std::set<std::string>      &omit,
                std::ostream                     &output);



  /**
   * Writes the reference of all entries as a page of Markdown that GitHub and
   * Doxygen render alike: a section for each subsection, a row for each entry
   * with name, default, allowed values and meaning. Present values do not
   * matter. The page of the present program is doc/parameters.md.
   */
  void
  write_parameter_reference(const ParameterHandler &prm, std::ostream &output);
} // namespace ThermoContact

#endif
