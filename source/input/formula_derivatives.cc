// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/formula_jet.h>
#include <thermocontact/input/time_function.h>

#include <deal.II/base/numbers.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    using Arguments = std::vector<Jet>;

    /** Parts of a formula within parts; each takes some of the stack. */
    constexpr unsigned int max_levels = 1000;



    /** What deal.II takes for true: what rounds to another number than 0. */
    bool
    is_true(const Jet &x)
    {
      return std::abs(value_of(x)) >= 0.5;
    }



    /** Reads a formula in the order of muParser's operators. */
    class FormulaReader
    {
    public:
      /**
       * @param zeros if given, gets the times at which parts of the formula
       *   that are linear in time are zero, or equal in a comparison; names
       *   that are not known are then no constants
       */
      FormulaReader(const std::string                   &formula,
                    const Jet                           &time,
                    const std::map<std::string, double> &constants,
                    std::vector<double>                 *zeros = nullptr)
        : next(formula.c_str())
        , time(time)
        , constants(constants)
        , zeros(zeros)
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
      std::vector<double> *const           zeros;
      unsigned int                         n_levels = 0;



      [[noreturn]] static void
      cannot_read(const std::string &what)
      {
        throw std::invalid_argument(what);
      }



      /** A part is within another one for the time of its life. */
      class Level
      {
      public:
        explicit Level(unsigned int &n_levels)
          : n_levels(n_levels)
        {
          if (++n_levels > max_levels)
            cannot_read("what is nested more than " +
                        std::to_string(max_levels / 2) + " times");
        }

        ~Level()
        {
          --n_levels;
        }

        Level(const Level &) = delete;

        Level &
        operator=(const Level &) = delete;

      private:
        unsigned int &n_levels;
      };



      void
      note_zero(const Jet &x) const
      {
        if (zeros == nullptr || x.derivative(2) != 0. || is_constant(x))
          return;
        const double zero = value_of(time) - value_of(x) / x.derivative(1);
        if (std::isfinite(zero))
          zeros->push_back(zero);
      }



      char
      skip_blanks()
      {
        while (std::isspace(static_cast<unsigned char>(*next)) != 0)
          ++next;
        return *next;
      }



      bool
      takes(const char *sign)
      {
        skip_blanks();
        const std::size_t length = std::strlen(sign);
        if (std::strncmp(next, sign, length) != 0)
          return false;
        next += length;
        return true;
      }



      void
      need(const char *sign)
      {
        if (!takes(sign))
          cannot_read(std::string("what should be '") + sign + "'");
      }



      Jet
      choice()
      {
        const Level level(n_levels);
        const Jet   condition = disjunction();
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
            const Jet  a        = result;
            const auto compared = [&](const auto &holds) {
              const Jet b = sum();
              note_zero(a - b);
              return Jet(holds(value_of(a), value_of(b)) ? 1. : 0.);
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
          {
            if (takes("+"))
              result = result + product();
            else if (takes("-"))
              result = result - product();
            else
              return result;
            note_zero(result);
          }
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
        const Level level(n_levels);
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
        if (zeros != nullptr && !name.empty())
          return Jet(std::numeric_limits<double>::quiet_NaN()) * time;
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
        const auto one = jet_functions().find(name);
        if (one != jet_functions().end() && x.size() == 1)
          return one->second(x[0]);
        if (name == "if" && x.size() == 3)
          return is_true(x[0]) ? x[1] : x[2];
        if (name == "pow" && x.size() == 2)
          return power(x[0], x[1]);
        if (name == "atan2" && x.size() == 2)
          return atan2(x[0], x[1]);
        Jet result = x[0];
        for (unsigned int i = 1; i < x.size() && name != "sum"; ++i)
          note_zero(result - x[i]);
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



  std::vector<double>
  zeros_of_linear_parts(const std::string &formula, const double time)
  {
    std::vector<double>                 zeros;
    const std::map<std::string, double> none;
    const Jet t = boost::math::differentiation::make_fvar<double, 2>(time);
    std::istringstream components(formula);
    for (std::string component; std::getline(components, component, ';');)
      try
        {
          FormulaReader(component, t, none, &zeros).read();
        }
      catch (const std::invalid_argument &)
        {} // those up to there
    return zeros;
  }
} // namespace ThermoContact
