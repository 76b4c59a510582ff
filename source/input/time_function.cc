// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/time_function.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  template <typename Number>
  Number
  TimeFunction::evaluate(const Number &time) const
  {
    std::array<Number, 4> variables;
    for (unsigned int i = 0; i < place.size(); ++i)
      variables[i] = Number(place[i]);
    variables.back() = time;
    return expression_.evaluate(variables.data());
  }



  double
  TimeFunction::value(const double time) const
  {
    return evaluate(time);
  }



  TimeDerivatives
  TimeFunction::derivatives(const double time) const
  {
    TimeDerivatives result = evaluate(NumberJet(time, 1., 0.));
    for (double *const derivative : {&result.first, &result.second})
      if (!std::isfinite(*derivative))
        *derivative = 0.;
    return result;
  }



  IntervalJet
  TimeFunction::enclosure(const Interval &span) const
  {
    return evaluate(IntervalJet(span, 1., 0.));
  }



  double
  TimeFunction::largest_value(const double end_time) const
  {
    constexpr unsigned int n_times = 97;
    double                 largest = 0.;
    for (unsigned int i = 0; i <= n_times; ++i)
      largest = std::max(largest, std::abs(value(end_time * i / n_times)));
    return largest;
  }
} // namespace ThermoContact
