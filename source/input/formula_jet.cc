// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/formula_jet.h>

#include <cmath>

namespace ThermoContact
{
  Jet
  power(const Jet &base, const double exponent)
  {
    return base.apply_derivatives(2, [&](const std::size_t order) {
      double factor = 1.;
      for (unsigned int i = 0; i < order; ++i)
        factor *= exponent - i;
      const double derivative =
        factor == 0. ? 0. : factor * std::pow(value_of(base), exponent - order);
      return order == 0 || std::isfinite(derivative) ? derivative : 0.;
    });
  }



  Jet
  power(const Jet &base, const Jet &exponent)
  {
    return is_constant(exponent) ? power(base, value_of(exponent)) :
                                   Jet(exp(exponent * log(base)));
  }



  const std::map<std::string, Jet (*)(const Jet &)> &
  jet_functions()
  {
    static const std::map<std::string, Jet (*)(const Jet &)> list = {
      {"sin", [](const Jet &x) -> Jet { return sin(x); }},
      {"cos", [](const Jet &x) -> Jet { return cos(x); }},
      {"tan", [](const Jet &x) -> Jet { return tan(x); }},
      {"asin", [](const Jet &x) -> Jet { return asin(x); }},
      {"acos", [](const Jet &x) -> Jet { return acos(x); }},
      {"atan", [](const Jet &x) -> Jet { return atan(x); }},
      {"sinh", [](const Jet &x) -> Jet { return sinh(x); }},
      {"cosh", [](const Jet &x) -> Jet { return cosh(x); }},
      {"tanh", [](const Jet &x) -> Jet { return tanh(x); }},
      {"asinh", [](const Jet &x) -> Jet { return asinh(x); }},
      {"acosh", [](const Jet &x) -> Jet { return acosh(x); }},
      {"atanh", [](const Jet &x) -> Jet { return atanh(x); }},
      {"sec", [](const Jet &x) -> Jet { return 1. / cos(x); }},
      {"csc", [](const Jet &x) -> Jet { return 1. / sin(x); }},
      {"cot", [](const Jet &x) -> Jet { return cos(x) / sin(x); }},
      {"exp", [](const Jet &x) -> Jet { return exp(x); }},
      {"log", [](const Jet &x) -> Jet { return log(x); }},
      {"ln", [](const Jet &x) -> Jet { return log(x); }},
      {"log2", [](const Jet &x) -> Jet { return log(x) / std::log(2.); }},
      {"log10", [](const Jet &x) -> Jet { return log(x) / std::log(10.); }},
      {"sqrt", [](const Jet &x) -> Jet { return power(x, 0.5); }},
      {"erf", [](const Jet &x) -> Jet { return erf(x); }},
      {"erfc", [](const Jet &x) -> Jet { return 1. - erf(x); }},
      {"abs", [](const Jet &x) -> Jet { return value_of(x) < 0. ? -x : x; }},
      {"sign",
       [](const Jet &x) -> Jet {
         return Jet((value_of(x) > 0.) - (value_of(x) < 0.));
       }},
      {"rint",
       [](const Jet &x) -> Jet { return Jet(std::floor(value_of(x) + 0.5)); }},
      {"int", [](const Jet &x) -> Jet { return Jet(std::round(value_of(x))); }},
      {"floor",
       [](const Jet &x) -> Jet { return Jet(std::floor(value_of(x))); }},
      {"ceil",
       [](const Jet &x) -> Jet { return Jet(std::ceil(value_of(x))); }}};
    return list;
  }
} // namespace ThermoContact
