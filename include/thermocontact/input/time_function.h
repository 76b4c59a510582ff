// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_time_function_h
#define thermocontact_input_time_function_h

#include <thermocontact/input/expression.h>

#include <deal.II/base/point.h>

#include <array>
#include <cmath>

namespace ThermoContact
{
  using TimeDerivatives = NumberJet;

  /** An expression at one place, as a function of time. */
  class TimeFunction
  {
  public:
    /**
     * @param expression whose variables are x, y, z, t
     * @param place values of the first ones
     */
    template <int dim = 1>
    explicit TimeFunction(
      const Expression         &expression,
      const dealii::Point<dim> &place = dealii::Point<dim>())
      : expression(expression)
      , place{}
    {
      for (unsigned int d = 0; d < dim; ++d)
        this->place[d] = place[d];
    }

    const Expression expression;

    double
    value(const double time) const
    {
      return evaluate(time);
    }

    /** With the derivatives in time; one that is not finite is 0. */
    TimeDerivatives
    derivatives(const double time) const
    {
      TimeDerivatives result = evaluate(NumberJet(time, 1., 0.));
      for (double *const derivative : {&result.first, &result.second})
        if (!std::isfinite(*derivative))
          *derivative = 0.;
      return result;
    }

    /** Its values and rates at all times of @p span. */
    IntervalJet
    enclosure(const Interval &span) const
    {
      return evaluate(IntervalJet(span, 1., 0.));
    }

  private:
    std::array<double, 3> place;

    /** Evaluates at the place and @p time. */
    template <typename Number>
    Number
    evaluate(const Number &time) const
    {
      const std::array<Number, 4> variables = {
        {Number(place[0]), Number(place[1]), Number(place[2]), time}};
      return expression.evaluate(variables.data());
    }
  };
} // namespace ThermoContact

#endif
