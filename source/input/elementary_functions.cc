// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/elementary_functions.h>

#include <deal.II/base/numbers.h>

namespace ThermoContact
{
  namespace
  {
    /** The list of all functions while it is made. */
    struct FunctionList
    {
      std::vector<ElementaryFunction> functions;

      /**
       * A smooth function.
       *
       * @param derivatives the function, its first and its second derivative at
       *   a number or in an interval
       */
      template <typename Derivatives>
      void
      add(const std::string &name,
          double (*number)(double),
          const Derivatives &derivatives)
      {
        const auto jet = [derivatives](const auto &x) {
          const auto f = derivatives(x.value);
          return chain(x, f.value, f.first, f.second);
        };
        functions.push_back({name, number, jet, jet});
      }



      /** A logarithm, 1/@p scale that of e. */
      void
      add_logarithm(const std::string &name,
                    double (*number)(double),
                    const double scale)
      {
        add(name, number, [number, scale](const auto &v) {
          const auto slope = 1. / (scale * v);
          return Jet(monotone(number, v), slope, -scale * square(slope));
        });
      }



      /** One that is constant but for its jumps, at which it grows. */
      void
      add_steps(const std::string &name, double (*number)(double))
      {
        functions.push_back(
          {name,
           number,
           [number](const NumberJet &x) { return NumberJet(number(x.value)); },
           [number](const IntervalJet &x) {
             const Interval value(number(x.value.low), number(x.value.high));
             const Interval slope =
               value.width() == 0. ? Interval(0.) : Interval::everything();
             return IntervalJet(value, slope, slope);
           }});
      }
    };



    std::vector<ElementaryFunction>
    list_functions()
    {
      using std::cos;
      using std::cosh;
      using std::exp;
      using std::sin;
      using std::sqrt;
      using std::tan;
      FunctionList list;
      list.add("sin", std::sin, [](const auto &v) {
        return Jet(sin(v), cos(v), -sin(v));
      });
      list.add("cos", std::cos, [](const auto &v) {
        return Jet(cos(v), -sin(v), -cos(v));
      });
      list.add("tan", std::tan, [](const auto &v) {
        const auto t = tan(v), slope = 1. + square(t);
        return Jet(t, slope, 2. * (t * slope));
      });
      const auto sec = [](const double x) { return 1. / std::cos(x); };
      list.add("sec", sec, [](const auto &v) {
        const auto s = 1. / cos(v), t = s * sin(v);
        return Jet(s, s * t, s * (square(s) + square(t)));
      });
      const auto csc = [](const double x) { return 1. / std::sin(x); };
      list.add("csc", csc, [](const auto &v) {
        const auto s = 1. / sin(v), t = s * cos(v);
        return Jet(s, -s * t, s * (square(s) + square(t)));
      });
      const auto cot = [](const double x) { return 1. / std::tan(x); };
      list.add("cot", cot, [](const auto &v) {
        const auto s = 1. / sin(v), t = s * cos(v);
        return Jet(t, -square(s), 2. * (t * square(s)));
      });
      list.add("asin", std::asin, [](const auto &v) {
        const auto slope = 1. / sqrt(1. - square(v));
        return Jet(monotone(std::asin, v), slope, v * (slope * square(slope)));
      });
      list.add("acos", std::acos, [](const auto &v) {
        const auto slope = -1. / sqrt(1. - square(v));
        return Jet(monotone(std::acos, v), slope, v * (slope * square(slope)));
      });
      list.add("atan", std::atan, [](const auto &v) {
        const auto slope = 1. / (1. + square(v));
        return Jet(monotone(std::atan, v), slope, -2. * (v * square(slope)));
      });
      list.add("sinh", std::sinh, [](const auto &v) {
        const auto value = monotone(std::sinh, v);
        return Jet(value, cosh(v), value);
      });
      list.add("cosh", std::cosh, [](const auto &v) {
        return Jet(cosh(v), monotone(std::sinh, v), cosh(v));
      });
      list.add("tanh", std::tanh, [](const auto &v) {
        // of intervals 1 - tanh^2 would not vanish far from zero
        const auto t = monotone(std::tanh, v), slope = 1. / square(cosh(v));
        return Jet(t, slope, -2. * (t * slope));
      });
      list.add("asinh", std::asinh, [](const auto &v) {
        const auto slope = 1. / sqrt(1. + square(v));
        return Jet(monotone(std::asinh, v),
                   slope,
                   -v * (slope * square(slope)));
      });
      list.add("acosh", std::acosh, [](const auto &v) {
        const auto slope = 1. / sqrt(square(v) - 1.);
        return Jet(monotone(std::acosh, v),
                   slope,
                   -v * (slope * square(slope)));
      });
      list.add("atanh", std::atanh, [](const auto &v) {
        const auto slope = 1. / (1. - square(v));
        return Jet(monotone(std::atanh, v), slope, 2. * (v * square(slope)));
      });
      list.add("exp", std::exp, [](const auto &v) {
        const auto value = exp(v);
        return Jet(value, value, value);
      });
      list.add_logarithm("log", std::log, 1.);
      list.add_logarithm("ln", std::log, 1.);
      list.add_logarithm("log2", std::log2, std::log(2.));
      list.add_logarithm("log10", std::log10, std::log(10.));
      const auto root = [](const auto &x) { return constant_power(x, 0.5); };
      list.functions.push_back({"sqrt", std::sqrt, root, root});
      const double of_erf = 2. / std::sqrt(dealii::numbers::PI);
      list.add("erf", std::erf, [of_erf](const auto &v) {
        const auto slope = of_erf * exp(-square(v));
        return Jet(monotone(std::erf, v), slope, -2. * (v * slope));
      });
      list.add("erfc", std::erfc, [of_erf](const auto &v) {
        const auto slope = -of_erf * exp(-square(v));
        return Jet(monotone(std::erfc, v), slope, -2. * (v * slope));
      });
      list.add_steps("sign", [](const double x) -> double {
        return (x > 0.) - (x < 0.);
      });
      list.add_steps("rint",
                     [](const double x) { return std::floor(x + 0.5); });
      list.add_steps("int", [](const double x) {
        return std::trunc(x + (x >= 0. ? 0.5 : -0.5));
      });
      list.add_steps("floor", std::floor);
      list.add_steps("ceil", std::ceil);
      return list.functions;
    }
  } // namespace



  const std::vector<ElementaryFunction> &
  elementary_functions()
  {
    static const std::vector<ElementaryFunction> functions = list_functions();
    return functions;
  }
} // namespace ThermoContact
