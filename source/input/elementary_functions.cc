// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/elementary_functions.h>

#include <deal.II/base/numbers.h>

#include <tuple>

namespace ThermoContact
{
  namespace
  {
    /**
     * A smooth function.
     *
     * @param derivatives the function, its first and its second derivative at a
     *   number or in an interval
     */
    template <typename Derivatives>
    ElementaryFunction
    smooth(const std::string &name,
           double (*number)(double),
           const Derivatives &derivatives)
    {
      const auto jet = [derivatives](const auto &x) {
        const auto [f, f1, f2] = derivatives(x.value);
        return chain(x, f, f1, f2);
      };
      return {name, number, jet, jet};
    }



    /** A logarithm, 1/@p scale that of e. */
    ElementaryFunction
    logarithm(const std::string &name,
              double (*number)(double),
              const double scale)
    {
      return smooth(name, number, [number, scale](const auto &v) {
        const auto slope = 1. / (scale * v);
        return std::make_tuple(monotone(number, v),
                               slope,
                               -scale * square(slope));
      });
    }



    /** One that is constant but for its jumps, at which it grows. */
    ElementaryFunction
    steps(const std::string &name, double (*number)(double))
    {
      return {name,
              number,
              [number](const NumberJet &x) {
                return NumberJet(number(x.value));
              },
              [number](const IntervalJet &x) {
                const Interval value(number(x.value.low), number(x.value.high));
                const Interval slope = value.low == value.high ?
                                         Interval(0.) :
                                         Interval::everything();
                return IntervalJet(value, slope, slope);
              }};
    }
  } // namespace



  const std::vector<ElementaryFunction> &
  elementary_functions()
  {
    using std::cos;
    using std::cosh;
    using std::exp;
    using std::sin;
    using std::sqrt;
    using std::tan;
    const auto   root   = [](const auto &x) { return constant_power(x, 0.5); };
    const double of_erf = 2. / std::sqrt(dealii::numbers::PI);
    static const std::vector<ElementaryFunction> functions{
      smooth("sin",
             std::sin,
             [](const auto &v) {
               return std::make_tuple(sin(v), cos(v), -sin(v));
             }),
      smooth("cos",
             std::cos,
             [](const auto &v) {
               return std::make_tuple(cos(v), -sin(v), -cos(v));
             }),
      smooth("tan",
             std::tan,
             [](const auto &v) {
               const auto t = tan(v), slope = 1. + square(t);
               return std::make_tuple(t, slope, 2. * (t * slope));
             }),
      smooth(
        "sec",
        [](const double x) { return 1. / std::cos(x); },
        [](const auto &v) {
          const auto s = 1. / cos(v), t = s * sin(v);
          return std::make_tuple(s, s * t, s * (square(s) + square(t)));
        }),
      smooth(
        "csc",
        [](const double x) { return 1. / std::sin(x); },
        [](const auto &v) {
          const auto s = 1. / sin(v), t = s * cos(v);
          return std::make_tuple(s, -s * t, s * (square(s) + square(t)));
        }),
      smooth(
        "cot",
        [](const double x) { return 1. / std::tan(x); },
        [](const auto &v) {
          const auto s = 1. / sin(v), t = s * cos(v);
          return std::make_tuple(t, -square(s), 2. * (t * square(s)));
        }),
      smooth("asin",
             std::asin,
             [](const auto &v) {
               const auto slope = 1. / sqrt(1. - square(v));
               return std::make_tuple(monotone(std::asin, v),
                                      slope,
                                      v * (slope * square(slope)));
             }),
      smooth("acos",
             std::acos,
             [](const auto &v) {
               const auto slope = -1. / sqrt(1. - square(v));
               return std::make_tuple(monotone(std::acos, v),
                                      slope,
                                      v * (slope * square(slope)));
             }),
      smooth("atan",
             std::atan,
             [](const auto &v) {
               const auto slope = 1. / (1. + square(v));
               return std::make_tuple(monotone(std::atan, v),
                                      slope,
                                      -2. * (v * square(slope)));
             }),
      smooth("sinh",
             std::sinh,
             [](const auto &v) {
               const auto value = monotone(std::sinh, v);
               return std::make_tuple(value, cosh(v), value);
             }),
      smooth("cosh",
             std::cosh,
             [](const auto &v) {
               return std::make_tuple(cosh(v), monotone(std::sinh, v), cosh(v));
             }),
      smooth("tanh",
             std::tanh,
             [](const auto &v) {
               // of intervals 1 - tanh^2 would not vanish far from zero
               const auto t     = monotone(std::tanh, v),
                          slope = 1. / square(cosh(v));
               return std::make_tuple(t, slope, -2. * (t * slope));
             }),
      smooth("asinh",
             std::asinh,
             [](const auto &v) {
               const auto slope = 1. / sqrt(1. + square(v));
               return std::make_tuple(monotone(std::asinh, v),
                                      slope,
                                      -(v * (slope * square(slope))));
             }),
      smooth("acosh",
             std::acosh,
             [](const auto &v) {
               const auto slope = 1. / sqrt(square(v) - 1.);
               return std::make_tuple(monotone(std::acosh, v),
                                      slope,
                                      -(v * (slope * square(slope))));
             }),
      smooth("atanh",
             std::atanh,
             [](const auto &v) {
               const auto slope = 1. / (1. - square(v));
               return std::make_tuple(monotone(std::atanh, v),
                                      slope,
                                      2. * (v * square(slope)));
             }),
      smooth("exp",
             std::exp,
             [](const auto &v) {
               const auto value = exp(v);
               return std::make_tuple(value, value, value);
             }),
      logarithm("log", std::log, 1.),
      logarithm("ln", std::log, 1.),
      logarithm("log2", std::log2, std::log(2.)),
      logarithm("log10", std::log10, std::log(10.)),
      {"sqrt", std::sqrt, root, root},
      smooth("erf",
             std::erf,
             [of_erf](const auto &v) {
               const auto slope = of_erf * exp(-square(v));
               return std::make_tuple(monotone(std::erf, v),
                                      slope,
                                      -2. * (v * slope));
             }),
      smooth("erfc",
             std::erfc,
             [of_erf](const auto &v) {
               const auto slope = -of_erf * exp(-square(v));
               return std::make_tuple(monotone(std::erfc, v),
                                      slope,
                                      -2. * (v * slope));
             }),
      steps("sign",
            [](const double x) -> double { return (x > 0.) - (x < 0.); }),
      steps("rint", [](const double x) { return std::floor(x + 0.5); }),
      steps("int",
            [](const double x) {
              return std::trunc(x + (x >= 0. ? 0.5 : -0.5));
            }),
      steps("floor", std::floor),
      steps("ceil", std::ceil)};
    return functions;
  }
} // namespace ThermoContact
