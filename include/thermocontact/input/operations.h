// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_operations_h
#define thermocontact_input_operations_h

#include <thermocontact/input/jet.h>

#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace ThermoContact
{
  /** A function or an operator of expressions. */
  struct Operation
  {
    static constexpr unsigned int is_function =
      std::numeric_limits<unsigned int>::max();

    /** Level of an operator, which binds after those of larger levels. */
    static constexpr unsigned int n_levels = 5, level_of_comparisons = 2;

    std::string  name;       ///< of a function, or the sign of an operator
    unsigned int n_operands; ///< 0: any number but none, two by two
    unsigned int level = is_function;

    /** The same for each kind of number. */
    std::tuple<std::function<double(const double *)>,
               std::function<NumberJet(const NumberJet *)>,
               std::function<IntervalJet(const IntervalJet *)>>
      forms;

    template <typename Number>
    Number
    operator()(const Number *operands) const
    {
      return std::get<std::function<Number(const Number *)>>(forms)(operands);
    }
  };



  /**
   * All of them, each always at the same place; of operators that begin alike
   * the longer one is first.
   */
  const std::vector<Operation> &
  operations();

  /** The one of that name, or null. */
  const Operation *
  find_operation(const std::string &name);
} // namespace ThermoContact

#endif
