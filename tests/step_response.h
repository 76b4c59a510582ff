// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_step_response_h
#define thermocontact_tests_step_response_h

#include <deal.II/base/numbers.h>

#include <boost/math/interpolators/cardinal_quintic_b_spline.hpp>

#include <cmath>
#include <complex>
#include <functional>
#include <vector>

namespace ThermoContact
{
  /**
   * The response of a linear system to a unit step, for times up to 5, by
   * Talbot's contour with 32 points (1e-10 where the poles are near the
   * negative axis, or decay within some periods) at equal distances of the root
   * of time, and a spline between them.
   */
  class StepResponse
  {
  public:
    using Transform = std::function<std::complex<double>(std::complex<double>)>;

    /** @param F the transform of the response to a unit impulse */
    explicit StepResponse(const Transform &F)
      : spline(values(F), 0., root_of_T / n_intervals)
    {}



    double
    operator()(const double t) const
    {
      return t >= 0. ? spline(std::sqrt(t)) : 0.; // behind the step at 0
    }

  private:
    static constexpr unsigned int n_intervals = 4000;
    static constexpr double       root_of_T   = 2.2361; // and a bit more

    boost::math::interpolators::cardinal_quintic_b_spline<double> spline;



    static double
    talbot(const Transform &F, const double t)
    {
      constexpr unsigned int n   = 32;
      const double           r   = 0.4 * n / t;
      double                 sum = 0.5 * std::exp(r * t) * F(r).real() / r;
      for (unsigned int i = 1; i < n; ++i)
        {
          const double x = i * dealii::numbers::PI / n, cot = 1. / std::tan(x);
          const std::complex<double> p = r * x * std::complex<double>(cot, 1.);
          const std::complex<double> slope(1., x + (x * cot - 1.) * cot);
          sum += (std::exp(t * p) * F(p) / p * slope).real();
        }
      return sum * r / n;
    }



    static std::vector<double>
    values(const Transform &F)
    {
      std::vector<double> result{talbot(F, 1e-12)}; // nodes may jump
      for (unsigned int i = 1; i <= n_intervals; ++i)
        {
          const double root = i * root_of_T / n_intervals;
          result.push_back(talbot(F, root * root));
        }
      return result;
    }
  };
} // namespace ThermoContact

#endif
