// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_time_function_h
#define thermocontact_input_time_function_h

#include <thermocontact/input/expression.h>

#include <deal.II/base/point.h>

#include <array>

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
      : expression_(expression)
      , place{}
    {
      for (unsigned int d = 0; d < dim; ++d)
        this->place[d] = place[d];
    }

    const Expression &
    expression() const
    {
      return expression_;
    }

    /** As it was written. */
    const std::string &
    text() const
    {
      return expression_.text();
    }

    double
    value(const double time) const;

    /** With the derivatives in time; one that is not finite is 0. */
    TimeDerivatives
    derivatives(const double time) const;

    /** What it does at all times of @p span. */
    IntervalJet
    enclosure(const Interval &span) const;

    /** The largest absolute value at many times of $[0,T]$. */
    double
    largest_value(const double end_time) const;

  private:
    Expression            expression_;
    std::array<double, 3> place;

    /** Evaluates at the place and @p time. */
    template <typename Number>
    Number
    evaluate(const Number &time) const;
  };
} // namespace ThermoContact

#endif
