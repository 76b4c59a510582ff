// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/named.h>
#include <thermocontact/method/butcher_tableau.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    ButcherTableau
    make_tableau(const std::string                      &name,
                 const unsigned int                      order,
                 const std::vector<std::vector<double>> &a,
                 const std::vector<double>              &embedded_b = {},
                 const std::vector<double>              &static_b   = {})
    {
      ButcherTableau tableau{name,
                             order,
                             a,
                             {},
                             embedded_b,
                             static_b.empty() ? embedded_b : static_b};
      for (const std::vector<double> &row : a)
        {
          double sum = 0.;
          for (const double entry : row)
            sum += entry;
          tableau.c.push_back(sum);
        }
      return tableau;
    }



    ButcherTableau
    make_sdirk2()
    {
      const double gamma = 1. - std::sqrt(0.5);
      return make_tableau("sdirk2", 2, {{gamma}, {1. - gamma, gamma}});
    }



    ButcherTableau
    make_sdirk3()
    {
      // the middle root of gamma^3 - 3 gamma^2 + 3/2 gamma - 1/6: the one for
      // which the scheme is L-stable
      const double gamma =
        1. + std::sqrt(2.) *
               std::cos((std::acos(std::sqrt(8.) / 3.) - 2. * M_PI) / 3.);
      // of order 2 by the first two stages
      const double embedded = (1. - 2. * gamma) / (1. - gamma);
      return make_tableau("sdirk3",
                          3,
                          {{gamma},
                           {(1. - gamma) / 2., gamma},
                           {(-6. * gamma * gamma + 16. * gamma - 1.) / 4.,
                            (6. * gamma * gamma - 20. * gamma + 5.) / 4.,
                            gamma}},
                          {1. - embedded, embedded, 0.});
    }



    ButcherTableau
    make_sdirk4()
    {
      return make_tableau(
        "sdirk4",
        4,
        {{1. / 4.},
         {1. / 2., 1. / 4.},
         {17. / 50., -1. / 25., 1. / 4.},
         {371. / 1360., -137. / 2720., 15. / 544., 1. / 4.},
         {25. / 24., -49. / 48., 125. / 16., -85. / 12., 1. / 4.}},
        {59. / 48., -17. / 96., 225. / 32., -85. / 12., 0.},
        {47. / 44., 119. / 88., -125. / 88., 0., 0.});
    }
  } // namespace



  namespace
  {
    /** The error estimate of $y'=-z\,y$, $y(0)=1$, in a step of length 1. */
    double
    estimate_of_decay(const ButcherTableau &tableau, const double z)
    {
      std::vector<double> rates;
      double              estimate = 0.;
      for (unsigned int i = 0; i < tableau.n_stages(); ++i)
        {
          double known = 1.;
          for (unsigned int j = 0; j < i; ++j)
            known += tableau.a[i][j] * rates[j];
          rates.push_back(-z * known / (1. + z * tableau.gamma()));
          estimate += (tableau.b()[i] - tableau.embedded_b[i]) * rates[i];
        }
      return std::abs(estimate);
    }
  } // namespace



  std::vector<double>
  ButcherTableau::bounds_of_estimate() const
  {
    if (!has_error_estimate())
      return {};
    // smooth functions of log z, below 1/64 constant or less, beyond 1024 less
    std::vector<double> bounds(order, 0.);
    constexpr int       per_octave = 8;
    for (int k = -6 * per_octave; k <= 10 * per_octave; ++k)
      {
        const double z     = std::exp2(double(k) / per_octave);
        double       bound = estimate_of_decay(*this, z);
        for (double &largest : bounds)
          largest = std::max(largest, bound /= z);
      }
    return bounds;
  }



  const std::vector<ButcherTableau> &
  butcher_tableaus()
  {
    static const std::vector<ButcherTableau> tableaus = {
      make_tableau("backward euler", 1, {{1.}}),
      make_sdirk2(),
      make_sdirk3(),
      make_sdirk4()};
    return tableaus;
  }



  const ButcherTableau &
  butcher_tableau(const std::string &name)
  {
    return named(name, butcher_tableaus());
  }
} // namespace ThermoContact
