// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/time_function.h>

#include <deal.II/base/numbers.h>

#include <boost/math/differentiation/autodiff.hpp>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /** A value with its first two derivatives in time. */
    using Jet = boost::math::differentiation::autodiff_fvar<double, 2>;

    using Function = Jet (*)(const Jet &);

    using Arguments = std::vector<Jet>;



    double
    value_of(const Jet &x)
    {
      return static_cast<double>(x);
    }



    /** What deal.II takes for true: what rounds to another number than 0. */
    bool
    is_true(const Jet &x)
    {
      return std::abs(value_of(x)) >= 0.5;
    }



    bool
    is_constant(const Jet &x)
    {
      return x.derivative(1) == 0. && x.derivative(2) == 0.;
    }



    /**
     * A constant power; at zero, where a derivative may be infinite, that one
     * is 0 and the others are what they are.
     */
    Jet
    power(const Jet &base, const double exponent)
    {
      return base.apply_derivatives(2, [&](const std::size_t order) {
        double factor = 1.;
        for (unsigned int i = 0; i < order; ++i)
          factor *= exponent - i;
        const double derivative =
          factor == 0. ? 0. :
                         factor * std::pow(value_of(base), exponent - order);
        return order == 0 || std::isfinite(derivative) ? derivative : 0.;
      });
    }



    Jet
    power(const Jet &base, const Jet &exponent)
    {
      return is_constant(exponent) ? power(base, value_of(exponent)) :
                                     Jet(exp(exponent * log(base)));
    }



    /** Functions of one argument; those with steps have derivatives 0. */
    const std::map<std::string, Function> &
    functions()
    {
      static const std::map<std::string, Function> list = {
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
         [](const Jet &x) -> Jet {
           return Jet(std::floor(value_of(x) + 0.5));
         }},
        {"int",
         [](const Jet &x) -> Jet { return Jet(std::round(value_of(x))); }},
        {"floor",
         [](const Jet &x) -> Jet { return Jet(std::floor(value_of(x))); }},
        {"ceil",
         [](const Jet &x) -> Jet { return Jet(std::ceil(value_of(x))); }}};
      return list;
    }



    /** Reads a formula in the order of muParser's operators. */
    class FormulaReader
    {
    public:
      FormulaReader(const std::string                   &formula,
                    const Jet                           &time,
                    const std::map<std::string, double> &constants)
        : next(formula.c_str())
        , time(time)
        , constants(constants)
      {}



      Jet
      read()
      {
        const Jet result = choice();
        if (skip_blanks() != '\0')
          cannot_read(std::string("'") + *next + "'");
        return result;
      }

    private:
      const char                          *next;
      const Jet                            time;
      const std::map<std::string, double> &constants;



      [[noreturn]] static void
      cannot_read(const std::string &what)
      {
        throw std::invalid_argument(what);
      }



      char
      skip_blanks()
      {
        while (std::isspace(static_cast<unsigned char>(*next)) != 0)
          ++next;
        return *next;
      }



      bool
      takes(const std::string &sign)
      {
        skip_blanks();
        if (std::string(next).compare(0, sign.size(), sign) != 0)
          return false;
        next += sign.size();
        return true;
      }



      void
      need(const std::string &sign)
      {
        if (!takes(sign))
          cannot_read("what should be '" + sign + "'");
      }



      Jet
      choice()
      {
        const Jet condition = disjunction();
        if (!takes("?"))
          return condition;
        const Jet first = choice();
        need(":");
        const Jet second = choice();
        return value_of(condition) != 0. ? first : second;
      }



      Jet
      disjunction()
      {
        Jet result = conjunction();
        while (takes("||") || takes("|"))
          {
            const Jet other = conjunction();
            result          = Jet(is_true(result) || is_true(other) ? 1. : 0.);
          }
        return result;
      }



      Jet
      conjunction()
      {
        Jet result = comparison();
        while (takes("&&") || takes("&"))
          {
            const Jet other = comparison();
            result          = Jet(is_true(result) && is_true(other) ? 1. : 0.);
          }
        return result;
      }



      Jet
      comparison()
      {
        Jet result = sum();
        while (true)
          {
            const double a        = value_of(result);
            const auto   compared = [&](const auto &holds) {
              return Jet(holds(a, value_of(sum())) ? 1. : 0.);
            };
            if (takes("<="))
              result = compared(std::less_equal<>());
            else if (takes(">="))
              result = compared(std::greater_equal<>());
            else if (takes("=="))
              result = compared(std::equal_to<>());
            else if (takes("!="))
              result = compared(std::not_equal_to<>());
            else if (takes("<"))
              result = compared(std::less<>());
            else if (takes(">"))
              result = compared(std::greater<>());
            else
              return result;
          }
      }



      Jet
      sum()
      {
        Jet result = product();
        while (true)
          if (takes("+"))
            result = result + product();
          else if (takes("-"))
            result = result - product();
          else
            return result;
      }



      Jet
      product()
      {
        Jet result = signed_power();
        while (true)
          if (takes("*"))
            result = result * signed_power();
          else if (takes("/"))
            result = result / signed_power();
          else
            return result;
      }



      Jet
      signed_power()
      {
        if (takes("-"))
          return -signed_power();
        if (takes("+"))
          return signed_power();
        const Jet base = operand();
        return takes("^") ? power(base, signed_power()) : base;
      }



      Jet
      operand()
      {
        if (takes("("))
          {
            const Jet result = choice();
            need(")");
            return result;
          }
        if (std::isdigit(static_cast<unsigned char>(*next)) != 0 ||
            *next == '.')
          {
            char        *end    = nullptr;
            const double number = std::strtod(next, &end);
            if (end == next)
              cannot_read("'.'");
            next = end;
            return Jet(number);
          }
        std::string name;
        while (std::isalnum(static_cast<unsigned char>(*next)) != 0 ||
               *next == '_')
          name += *next++;
        if (takes("("))
          return call(name);
        if (name == "t")
          return time;
        if (const auto constant = constants.find(name);
            constant != constants.end())
          return Jet(constant->second);
        if (name == "pi" || name == "_pi")
          return Jet(dealii::numbers::PI);
        if (name == "_e")
          return Jet(dealii::numbers::E);
        cannot_read("'" + name + "'");
      }



      /** The opening parenthesis has been read. */
      Jet
      call(const std::string &name)
      {
        Arguments x;
        do
          x.push_back(choice());
        while (takes(","));
        need(")");
        const auto one = functions().find(name);
        if (one != functions().end() && x.size() == 1)
          return one->second(x[0]);
        if (name == "if" && x.size() == 3)
          return is_true(x[0]) ? x[1] : x[2];
        if (name == "pow" && x.size() == 2)
          return power(x[0], x[1]);
        if (name == "atan2" && x.size() == 2)
          return atan2(x[0], x[1]);
        Jet result = x[0];
        for (unsigned int i = 1; i < x.size(); ++i)
          if (name == "min")
            result = value_of(x[i]) < value_of(result) ? x[i] : result;
          else if (name == "max")
            result = value_of(x[i]) > value_of(result) ? x[i] : result;
          else
            result = result + x[i];
        if (name == "sum" || name == "min" || name == "max")
          return result;
        if (name == "avg")
          return result / static_cast<double>(x.size());
        cannot_read("the function " + name + "()");
      }
    };
  } // namespace



  TimeDerivatives
  differentiate(const std::string                   &formula,
                const double                         time,
                const std::map<std::string, double> &constants)
  {
    const Jet  t = boost::math::differentiation::make_fvar<double, 2>(time);
    const Jet  result = FormulaReader(formula, t, constants).read();
    const auto finite = [](const double x) {
      return std::isfinite(x) ? x : 0.;
    };
    return {value_of(result),
            finite(result.derivative(1)),
            finite(result.derivative(2))};
  }
} // namespace ThermoContact
