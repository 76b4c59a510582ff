// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_declared_entries_h
#define thermocontact_input_declared_entries_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  using dealii::ParameterHandler;

  /** One entry of a ParameterHandler. */
  struct DeclaredEntry
  {
    std::string path;          ///< "Section/Entry", or "Entry" outside sections
    std::string value;         ///< the present one
    std::string default_value; ///< the one declared
    std::string text;          ///< meaning
    std::string pattern;       ///< of allowed values, as deal.II describes it
    std::string kind; ///< of quantity, QuantityUnits; empty: it is none
    std::string remark    = "";    ///< behind the value when it is written
    bool        is_remark = false; ///< all of it, when it is written

    /**
     * The names that an expression for it may have in a body of dimension
     * @p dim; none: it is a number or text.
     */
    std::vector<std::string>
    variables(const unsigned int dim) const;
  };



  /** All declared entries, in the order of declaration. */
  std::vector<DeclaredEntry>
  declared_entries(const ParameterHandler &prm);

  /** "[Double 0...MAX_DOUBLE (inclusive)]" in words: "a number 0 or more". */
  std::string
  describe_pattern(std::string pattern);

  /** The allowed values of its pattern, in words; 0 is no value of some. */
  std::string
  describe_allowed(const DeclaredEntry &entry);
} // namespace ThermoContact

#endif
