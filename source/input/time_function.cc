// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/time_function.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ThermoContact
{
  namespace
  {
    /** Intervals of $[0,T]$ at whose ends a function is looked at. */
    constexpr unsigned int n_times = 97;



    ExpressionNames
    names_of_time(const std::map<std::string, double> &place)
    {
      ExpressionNames names;
      names.constants       = place;
      names.constants["pi"] = dealii::numbers::PI;
      names.variables       = {"t"};
      names.example         = "0.1*sin(2*pi*t)";
      return names;
    }



    [[noreturn]] void
    refuse_formula(const Expression &expression, const std::string &fault)
    {
      throw InputError(
        expression.path + " = " + quote(expression.text) +
        ": its rate cannot be found: " + fault +
        "\n  allowed: + - * / ^, comparisons, if, min, max, abs, sqrt, exp, "
        "log, trigonometric and hyperbolic functions of t"
        "\n  remedy:  parentheses, or other functions");
    }
  } // namespace



  TimeFunction::TimeFunction(const Expression                    &expression,
                             const std::map<std::string, double> &place)
    : expression(expression)
    , place(place)
  {
    check_expression<1>(expression, 1, names_of_time(place));
    function = make_function<1>(expression.text, names_of_time(place));
    try
      {
        differentiate(expression.text, 0., place);
      }
    catch (const std::invalid_argument &fault)
      {
        refuse_formula(expression, fault.what());
      }
  }



  double
  TimeFunction::value(const double time) const
  {
    return function->value(dealii::Point<1>(time));
  }



  TimeDerivatives
  TimeFunction::derivatives(const double time) const
  {
    TimeDerivatives result = differentiate(expression.text, time, place);
    result.value           = value(time);
    return result;
  }



  bool
  TimeFunction::starts_with_unbounded_rate(const double end_time) const
  {
    const double near = std::abs(derivatives(1e-14 * end_time).first);
    const double far  = std::abs(derivatives(1e-10 * end_time).first);
    return !(near <= 2. * far) && near > 0.;
  }



  double
  TimeFunction::largest_value(const double end_time) const
  {
    double largest = 0.;
    for (unsigned int i = 0; i <= n_times; ++i)
      largest = std::max(largest, std::abs(value(end_time * i / n_times)));
    return largest;
  }



  void
  TimeFunction::check(const double end_time) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double     largest  = largest_value(end_time);
    for (unsigned int i = 0; i <= n_times; ++i)
      {
        const double time = end_time * i / n_times;
        // at a bend the rounding of the time decides on which side it is
        double low = infinity, high = -infinity;
        for (const double part : {1. - 1e-13, 1., 1. + 1e-13})
          {
            const double x =
              differentiate(expression.text, part * time, place).value;
            low  = std::min(low, x);
            high = std::max(high, x);
          }
        if (const double x = value(time);
            !(x >= low - 1e-9 * largest && x <= high + 1e-9 * largest))
          throw ComputationError(ThermoContact::text(
            expression.path,
            " = ",
            quote(expression.text),
            ": at t = ",
            time,
            " the formula that is differentiated has another value"
            "\n  remedy:  parentheses, or other functions"));
      }
  }
} // namespace ThermoContact
