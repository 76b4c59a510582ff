// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The tableaux against the definitions (Hairer, Norsett, Wanner, II.2 and
// Hairer, Wanner, IV.3):
// * order p: all conditions of the rooted trees up to order p hold to 1e-14,
//   and one of order p + 1 does not, so that the order is p exactly;
// * equal diagonal entries; stiffly accurate: c of the last stage is 1;
// * A-stable: the poles 1/gamma of the stability function are positive and
//   |R(iy)| <= 1; L-stable: R(z) -> 0 for z -> -infinity;
// * the weights of the error estimate satisfy all conditions up to order p - 1,
//   and not all of order p. Those for a static body are the same, or of order 2
//   and exact for the cubics u = t^m that the stages are on: their rates are
//   a^{-1} c^m.

#include <thermocontact/method/butcher_tableau.h>

#include <complex>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  using Values = std::vector<double>;

  /** a x, the sum over the earlier stages and the stage itself. */
  Values
  stage_sums(const ButcherTableau &tableau, const Values &x)
  {
    Values result(x.size(), 0.);
    for (unsigned int i = 0; i < x.size(); ++i)
      for (unsigned int j = 0; j <= i; ++j)
        result[i] += tableau.a[i][j] * x[j];
    return result;
  }



  Values
  product(const Values &x, const Values &y)
  {
    Values result(x);
    for (unsigned int i = 0; i < x.size(); ++i)
      result[i] *= y[i];
    return result;
  }



  double
  weigh(const Values &weights, const Values &x)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < x.size(); ++i)
      sum += weights[i] * x[i];
    return sum;
  }



  /** Largest defect of the conditions of one order with these weights. */
  double
  defect(const ButcherTableau &t,
         const Values         &weights,
         const unsigned int    order)
  {
    const Values one(t.n_stages(), 1.);
    const Values c       = stage_sums(t, one);
    const Values c2      = product(c, c);
    const Values ac      = stage_sums(t, c);
    const Values ac2     = stage_sums(t, c2);
    double       worst   = 0.;
    const auto   require = [&](const Values &x, const double expected) {
      raise(worst, std::abs(weigh(weights, x) - expected));
    };
    switch (order)
      {
        case 1:
          require(one, 1.);
          break;
        case 2:
          require(c, 1. / 2.);
          break;
        case 3:
          require(c2, 1. / 3.);
          require(ac, 1. / 6.);
          break;
        case 4:
          require(product(c, c2), 1. / 4.);
          require(product(c, ac), 1. / 8.);
          require(ac2, 1. / 12.);
          require(stage_sums(t, ac), 1. / 24.);
          break;
        default: // one of the nine of order 5
          require(product(c2, c2), 1. / 5.);
      }
    return worst;
  }



  /** R(z) = 1 + z b (I - z a)^{-1} 1, by forward substitution. */
  std::complex<double>
  stability_function(const ButcherTableau &t, const std::complex<double> z)
  {
    std::vector<std::complex<double>> k(t.n_stages());
    std::complex<double>              r = 1.;
    for (unsigned int i = 0; i < t.n_stages(); ++i)
      {
        std::complex<double> value = 1.;
        for (unsigned int j = 0; j < i; ++j)
          value += z * t.a[i][j] * k[j];
        k[i] = value / (1. - z * t.a[i][i]);
        r += z * t.b()[i] * k[i];
      }
    return r;
  }
} // namespace



void
main_butcher_tableau()
{
  initlog();
  for (const ButcherTableau &t : butcher_tableaus())
    {
      double worst = 0.;
      for (unsigned int order = 1; order <= t.order; ++order)
        raise(worst, defect(t, t.b(), order));
      bool is_sdirk = true;
      for (unsigned int i = 0; i < t.n_stages(); ++i)
        is_sdirk &=
          t.a[i].size() == i + 1 && t.a[i][i] == t.gamma() &&
          std::abs(t.c[i] - stage_sums(t, Values(t.n_stages(), 1.))[i]) < 1e-15;
      double largest = 0.;
      for (double y = 1e-3; y < 1e6; y *= 1.1)
        raise(largest, std::abs(stability_function(t, {0., y})));

      deallog << t.name << ": stages " << t.n_stages() << ", order " << t.order
              << " holds " << within(worst, 1e-14) << ", order " << t.order + 1
              << " does not " << (defect(t, t.b(), t.order + 1) > 1e-3)
              << ", equal diagonal " << is_sdirk << ", stiffly accurate "
              << within(std::abs(t.c.back() - 1.), 1e-14) << ", A-stable "
              << (t.gamma() > 0. && largest < 1. + 1e-12) << ", L-stable "
              << within(std::abs(stability_function(t, -1e12)), 1e-10)
              << std::endl;
      if (!t.has_error_estimate())
        continue;
      worst = 0.;
      for (unsigned int order = 1; order < t.order; ++order)
        raise(worst, defect(t, t.embedded_b, order));
      deallog << t.name << ", embedded: order " << t.order - 1 << " holds "
              << within(worst, 1e-14) << ", order " << t.order << " does not "
              << (defect(t, t.embedded_b, t.order) > 1e-3)
              << ", of a static body ";
      worst = std::max(defect(t, t.static_b, 1), defect(t, t.static_b, 2));
      for (unsigned int m = 1; m <= 3; ++m)
        {
          Values rates(t.n_stages(), 0.);
          for (unsigned int i = 0; i < t.n_stages(); ++i)
            rates[i] =
              (std::pow(t.c[i], m) - stage_sums(t, rates)[i]) / t.gamma();
          raise(worst, std::abs(weigh(t.static_b, rates) - 1.));
        }
      deallog << (t.static_b == t.embedded_b ? "the same" :
                                               within(worst, 1e-13))
              << std::endl;
    }
}
