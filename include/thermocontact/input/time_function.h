// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_time_function_h
#define thermocontact_input_time_function_h

#include <thermocontact/input/expression.h>

#include <map>
#include <memory>
#include <string>

namespace ThermoContact
{
  /** A function of time with its first derivatives. */
  struct TimeDerivatives
  {
    double value  = 0.;
    double first  = 0.; ///< 0 where it is not finite
    double second = 0.; ///< likewise
  };



  /**
   * A function of time that an expression of the parameter file says. Its value
   * is muParser's; its derivatives are those of the formula, found by the rules
   * of differentiation and exact to rounding. Where the formula has branches
   * they are those of the branch that holds.
   */
  class TimeFunction
  {
  public:
    /**
     * @param expression in t; pi is known
     * @param place values of other names, such as y
     * @throw InputError if it cannot be read, or not be differentiated
     */
    explicit TimeFunction(const Expression                    &expression,
                          const std::map<std::string, double> &place = {});

    double
    value(const double time) const;

    TimeDerivatives
    derivatives(const double time) const;

    /** As it was written. */
    const std::string &
    text() const
    {
      return expression.text;
    }

    /** Whether the first derivative has no limit at the start, as of sqrt(t):
     * whether it grows towards zero on scales far below $T$. */
    bool
    starts_with_unbounded_rate(const double end_time) const;

    /** The largest absolute value at many times of $[0,T]$. */
    double
    largest_value(const double end_time) const;

    /**
     * Refuses an expression whose formula is not read as muParser reads it:
     * compares the values at times of $[0,T]$.
     */
    void
    check(const double end_time) const;

  private:
    const Expression                         expression;
    const std::map<std::string, double>      place;
    std::unique_ptr<const FunctionParser<1>> function;
  };



  /**
   * The formula and its derivatives at @p time.
   *
   * @param constants values of names other than t and pi
   * @throw std::invalid_argument saying what of it cannot be differentiated
   */
  TimeDerivatives
  differentiate(const std::string                   &formula,
                const double                         time,
                const std::map<std::string, double> &constants = {});
} // namespace ThermoContact

#endif
