// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_expression_h
#define thermocontact_input_expression_h

#include <thermocontact/base/types.h>

#include <deal.II/base/function_parser.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** An expression of the parameter file and the entry it comes from. */
  struct Expression
  {
    std::string path;
    std::string text;

    bool
    is_zero() const;
  };



  /** True if the name occurs in the text of an expression. */
  bool
  depends_on(const std::string &text, const std::string &name);



  /** The names that an expression of a scene may use. */
  struct ExpressionNames
  {
    std::map<std::string, double> constants;
    bool                          has_time = false; ///< t is known

    /** In place of x, y, z, as many as there are. */
    std::vector<std::string> variables;

    std::string example = "20*x*(x-1)^2"; ///< for messages
  };



  /** Those of the temperature of the obstacle: x, y, z, t and pi. */
  ExpressionNames
  obstacle_names();



  /**
   * The function with the components that @p text separates by ';', not
   * checked.
   */
  template <int dim>
  std::unique_ptr<FunctionParser<dim>>
  make_function(const std::string &text, const ExpressionNames &names);

  /**
   * Checks an expression: parses it and evaluates each component at 17 points
   * of the axis, the first variable from 0 to 1, at $t=0$.
   *
   * @param n_components largest number of components
   * @return its text, filled up with zeros to @p n_components: one component
   *   alone is the axial one
   * @throw InputError naming entry and expression, and the column of the fault,
   *   if it cannot be parsed, assigns or separates what is no argument
   * (muParser
   *   would do so), has neither one nor @p n_components components, or is not
   *   finite
   */
  template <int dim>
  std::string
  check_expression(const Expression      &expression,
                   const unsigned int     n_components,
                   const ExpressionNames &names);
} // namespace ThermoContact

#endif
