// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/table.h>
#include <thermocontact/input/unknown_names.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>

namespace ThermoContact
{
  enum class Expression::Operation
  {
    number,
    variable,
    // of two operands
    plus,
    minus,
    times,
    over,
    to_the_power,
    whole_power,
    less,
    less_equal,
    equal,
    both,
    any,
    both_rounded,
    any_rounded,
    smaller,
    larger,
    angle,
    // of three, the first one is a condition
    choice,
    choice_rounded,
    // of one
    table,
    minus_sign,
    negation,
    sin,
    cos,
    tan,
    asin,
    acos,
    atan,
    sinh,
    cosh,
    tanh,
    asinh,
    acosh,
    atanh,
    exp,
    log,
    sqrt,
    erf,
    erfc,
    abs,
    sign,
    rint,
    nearest,
    floor,
    ceil,
    // made of others
    log2,
    log10,
    sec,
    csc,
    cot,
    sum,
    mean
  };



  namespace
  {
    constexpr double least = std::numeric_limits<double>::denorm_min();



    // ------------------------------------------------------- constant powers

    double
    whole_power(const double a, const double exponent)
    {
      return exponent == 2. ? a * a :
             exponent == 3. ? a * a * a :
                              a * a * a * a;
    }

    /** The derivative of a power where it is one; at zero it may be infinite.
     */
    double
    slope_of_power(const double a, const double factor, const double exponent)
    {
      const double slope = factor == 0. ? 0. : factor * std::pow(a, exponent);
      return std::isfinite(slope) ? slope : 0.;
    }

    Interval
    slope_of_power(const Interval &a,
                   const double    factor,
                   const double    exponent)
    {
      return factor == 0. ? Interval(0.) : factor * pow(a, exponent);
    }

    template <typename Number>
    Jet<Number>
    constant_power(const Jet<Number> &a, const double exponent)
    {
      using std::pow;
      return chain(a,
                   Number(pow(a.value, exponent)),
                   slope_of_power(a.value, exponent, exponent - 1.),
                   slope_of_power(a.value,
                                  exponent * (exponent - 1.),
                                  exponent - 2.));
    }

    template <typename Number>
    Jet<Number>
    whole_power(const Jet<Number> &a, const double exponent)
    {
      return constant_power(a, exponent);
    }



    // ------------------------------------------------------- smooth functions

    template <typename Number>
    Number
    inverse(const Number &x)
    {
      return 1. / x;
    }

    template <typename Number>
    Jet<Number>
    exp_of(const Jet<Number> &x)
    {
      using std::exp;
      const Number value = exp(x.value);
      return chain(x, value, value, value);
    }

    template <typename Number>
    Jet<Number>
    log_of(const Jet<Number> &x)
    {
      using std::log;
      const Number slope = inverse(x.value);
      return chain(x, Number(log(x.value)), slope, -square(slope));
    }

    double
    power(const double a, const double b)
    {
      return std::pow(a, b);
    }

    NumberJet
    power(const NumberJet &a, const NumberJet &b)
    {
      if (b.first == 0. && b.second == 0.)
        return constant_power(a, b.value);
      NumberJet result = exp_of(b * log_of(a));
      result.value     = std::pow(a.value, b.value);
      return result;
    }

    IntervalJet
    power(const IntervalJet &a, const IntervalJet &b)
    {
      return b.value.width() == 0. ? constant_power(a, b.value.low) :
                                     exp_of(b * log_of(a));
    }

    double
    angle(const double y, const double x)
    {
      return std::atan2(y, x);
    }

    Interval
    angle_of(const Interval &y, const Interval &x)
    {
      if (x.low <= 0. && y.contains(0.))
        return Interval::everything(); // the origin, or the branch cut
      Interval result =
        widened(std::atan2(y.low, x.low), std::atan2(y.high, x.high));
      result =
        hull(result,
             widened(std::atan2(y.low, x.high), std::atan2(y.high, x.low)));
      return result;
    }

    double
    angle_of(const double y, const double x)
    {
      return std::atan2(y, x);
    }

    template <typename Number>
    Jet<Number>
    angle(const Jet<Number> &y, const Jet<Number> &x)
    {
      const Number n  = x.value * y.first - y.value * x.first;
      const Number n1 = x.value * y.second - y.value * x.second;
      const Number r  = square(x.value) + square(y.value);
      const Number r1 = 2. * (x.value * x.first + y.value * y.first);
      return {angle_of(y.value, x.value), n / r, (n1 * r - n * r1) / square(r)};
    }



    // ------------------------------------------------------- steps and kinks

    double
    value_of(const double x)
    {
      return x;
    }

    template <typename Number>
    const Number &
    value_of(const Jet<Number> &x)
    {
      return x.value;
    }

    double
    step(const double x, double (*function)(double))
    {
      return function(x);
    }

    NumberJet
    step(const NumberJet &x, double (*function)(double))
    {
      return NumberJet(function(x.value));
    }

    IntervalJet
    step(const IntervalJet &x, double (*function)(double))
    {
      const Interval value(function(x.value.low), function(x.value.high));
      const Interval slope =
        value.low == value.high ? Interval(0.) : Interval::everything();
      return {value, slope, slope};
    }

    double
    sign_of(const double x)
    {
      return (x > 0.) - (x < 0.);
    }

    double
    rint_of(const double x)
    {
      return std::floor(x + 0.5);
    }

    double
    nearest_of(const double x)
    {
      return std::trunc(x + (x >= 0. ? 0.5 : -0.5));
    }

    double
    floor_of(const double x)
    {
      return std::floor(x);
    }

    double
    ceil_of(const double x)
    {
      return std::ceil(x);
    }



    /** What is one or the other, and continuous; @p value is that of both. */
    template <typename Number>
    Number
    kink(const Number &a, const Number &, const Interval &)
    {
      return a; // numbers decide
    }

    template <>
    IntervalJet
    kink(const IntervalJet &a, const IntervalJet &b, const Interval &value)
    {
      const Interval first = hull(a.first, b.first);
      return {value, first, Interval::everything()};
    }

    /** What is one or the other. */
    template <typename Number>
    Number
    jump(const Number &a, const Number &)
    {
      return a;
    }

    template <>
    IntervalJet
    jump(const IntervalJet &a, const IntervalJet &b)
    {
      return {hull(a.value, b.value),
              Interval::everything(),
              Interval::everything()};
    }

    template <typename Number>
    Number
    number_of(const Truth truth)
    {
      return truth == Truth::undecided ? jump(Number(0.), Number(1.)) :
                                         Number(truth == Truth::yes ? 1. : 0.);
    }

    /** Whether the absolute value is at least @p threshold. */
    Truth
    is_at_least(const double x, const double threshold)
    {
      return std::abs(x) >= threshold ? Truth::yes : Truth::no;
    }

    Truth
    is_at_least(const Interval &x, const double threshold)
    {
      return x.low >= threshold || x.high <= -threshold ? Truth::yes :
             x.magnitude() < threshold                  ? Truth::no :
                                                          Truth::undecided;
    }

    Truth
    both(const Truth a, const Truth b)
    {
      return a == Truth::no || b == Truth::no   ? Truth::no :
             a == Truth::yes && b == Truth::yes ? Truth::yes :
                                                  Truth::undecided;
    }

    Interval
    as_interval(const double x)
    {
      return x;
    }

    Interval
    as_interval(const Interval &x)
    {
      return x;
    }

    /** The smaller or the larger one of two. */
    template <typename Number>
    Number
    extremum(const Number &a, const Number &b, const bool is_larger)
    {
      const Truth takes_b = is_larger ? is_less(value_of(a), value_of(b)) :
                                        is_less(value_of(b), value_of(a));
      if (takes_b != Truth::undecided)
        return takes_b == Truth::yes ? b : a;
      const Interval x = as_interval(value_of(a)), y = as_interval(value_of(b));
      return kink(a,
                  b,
                  is_larger ?
                    Interval(std::max(x.low, y.low), std::max(x.high, y.high)) :
                    Interval(std::min(x.low, y.low), std::min(x.high, y.high)));
    }
  } // namespace



  namespace
  {
    /** A smooth function of one argument, of a number. */
    template <typename Operation>
    double
    smooth(const Operation operation, const double x)
    {
      switch (operation)
        {
          case Operation::sin:
            return std::sin(x);
          case Operation::cos:
            return std::cos(x);
          case Operation::tan:
            return std::tan(x);
          case Operation::asin:
            return std::asin(x);
          case Operation::acos:
            return std::acos(x);
          case Operation::atan:
            return std::atan(x);
          case Operation::sinh:
            return std::sinh(x);
          case Operation::cosh:
            return std::cosh(x);
          case Operation::tanh:
            return std::tanh(x);
          case Operation::asinh:
            return std::asinh(x);
          case Operation::acosh:
            return std::acosh(x);
          case Operation::atanh:
            return std::atanh(x);
          case Operation::exp:
            return std::exp(x);
          case Operation::log:
            return std::log(x);
          case Operation::sqrt:
            return std::sqrt(x);
          case Operation::erfc:
            return std::erfc(x);
          default:
            return std::erf(x);
        }
    }



    /** The same with its derivatives. */
    template <typename Operation, typename Number>
    Jet<Number>
    smooth(const Operation operation, const Jet<Number> &x)
    {
      using std::acos;
      using std::acosh;
      using std::asin;
      using std::asinh;
      using std::atan;
      using std::atanh;
      using std::cos;
      using std::cosh;
      using std::erf;
      using std::erfc;
      using std::exp;
      using std::sin;
      using std::sinh;
      using std::sqrt;
      using std::tan;
      using std::tanh;
      const Number &v = x.value;
      switch (operation)
        {
          case Operation::sin:
            return chain(x, Number(sin(v)), Number(cos(v)), Number(-sin(v)));
          case Operation::cos:
            return chain(x, Number(cos(v)), Number(-sin(v)), Number(-cos(v)));
          case Operation::tan:
            {
              const Number t = tan(v), slope = 1. + square(t);
              return chain(x, t, slope, 2. * (t * slope));
            }
          case Operation::asin:
          case Operation::acos:
            {
              const Number slope = inverse(Number(sqrt(1. - square(v))));
              const Number f2    = v * (slope * square(slope));
              return operation == Operation::asin ?
                       chain(x, Number(asin(v)), slope, f2) :
                       chain(x, Number(acos(v)), -slope, -f2);
            }
          case Operation::atan:
            {
              const Number slope = inverse(Number(1. + square(v)));
              return chain(x,
                           Number(atan(v)),
                           slope,
                           -2. * (v * square(slope)));
            }
          case Operation::sinh:
            return chain(x, Number(sinh(v)), Number(cosh(v)), Number(sinh(v)));
          case Operation::cosh:
            return chain(x, Number(cosh(v)), Number(sinh(v)), Number(cosh(v)));
          case Operation::tanh:
            {
              // of intervals 1 - tanh^2 would not vanish far from zero
              const Number t     = tanh(v),
                           slope = inverse(square(Number(cosh(v))));
              return chain(x, t, slope, -2. * (t * slope));
            }
          case Operation::asinh:
            {
              const Number slope = inverse(Number(sqrt(1. + square(v))));
              return chain(x,
                           Number(asinh(v)),
                           slope,
                           -(v * (slope * square(slope))));
            }
          case Operation::acosh:
            {
              const Number slope = inverse(Number(sqrt(square(v) - 1.)));
              return chain(x,
                           Number(acosh(v)),
                           slope,
                           -(v * (slope * square(slope))));
            }
          case Operation::atanh:
            {
              const Number slope = inverse(Number(1. - square(v)));
              return chain(x,
                           Number(atanh(v)),
                           slope,
                           2. * (v * square(slope)));
            }
          case Operation::exp:
            return exp_of(x);
          case Operation::log:
            return log_of(x);
          case Operation::sqrt:
            return constant_power(x, 0.5);
          default:
            {
              const Number slope =
                2. / std::sqrt(dealii::numbers::PI) * Number(exp(-square(v)));
              return operation == Operation::erf ?
                       chain(x, Number(erf(v)), slope, -2. * (v * slope)) :
                       chain(x, Number(erfc(v)), -slope, 2. * (v * slope));
            }
        }
    }
  } // namespace



  template <typename Number>
  Number
  Expression::evaluate_part(const unsigned int index,
                            const Number      *variables) const
  {
    const Part &part = parts[index];
    const auto a = [&]() { return evaluate_part(part.operands[0], variables); };
    const auto b = [&]() { return evaluate_part(part.operands[1], variables); };
    const auto choose = [&](const Truth truth) {
      return truth == Truth::undecided ?
               jump(b(), evaluate_part(part.operands[2], variables)) :
             truth == Truth::yes ? b() :
                                   evaluate_part(part.operands[2], variables);
    };
    const auto logic = [&](const bool needs_both, const double threshold) {
      const Truth x = is_at_least(value_of(a()), threshold);
      if (x == (needs_both ? Truth::no : Truth::yes))
        return number_of<Number>(x);
      const Truth y = is_at_least(value_of(b()), threshold);
      return number_of<Number>(needs_both ? both(x, y) : !both(!x, !y));
    };
    switch (part.operation)
      {
        case Operation::number:
          return Number(part.number);
        case Operation::variable:
          return variables[part.operands[0]];
        case Operation::plus:
          return a() + b();
        case Operation::minus:
          return a() - b();
        case Operation::times:
          return a() * b();
        case Operation::over:
          return a() / b();
        case Operation::to_the_power:
          return power(a(), b());
        case Operation::whole_power:
          return whole_power(a(), part.number);
        case Operation::less:
          return number_of<Number>(is_less(value_of(a()), value_of(b())));
        case Operation::less_equal:
          return number_of<Number>(!is_less(value_of(b()), value_of(a())));
        case Operation::equal:
          return number_of<Number>(is_equal(value_of(a()), value_of(b())));
        case Operation::negation:
          return Number(1.) - a();
        case Operation::both:
          return logic(true, 1.);
        case Operation::any:
          return logic(false, 1.);
        case Operation::both_rounded:
          return logic(true, 0.5);
        case Operation::any_rounded:
          return logic(false, 0.5);
        case Operation::smaller:
          return extremum(a(), b(), false);
        case Operation::larger:
          return extremum(a(), b(), true);
        case Operation::angle:
          return angle(a(), b());
        case Operation::choice:
          return choose(is_at_least(value_of(a()), least));
        case Operation::choice_rounded:
          return choose(is_at_least(value_of(a()), 0.5));
        case Operation::table:
          return tables_[part.operands[1]]->evaluate(a());
        case Operation::minus_sign:
          return -a();
        case Operation::abs:
          {
            const Number x = a();
            return extremum(x, Number(-x), true);
          }
        case Operation::sign:
          return step(a(), sign_of);
        case Operation::rint:
          return step(a(), rint_of);
        case Operation::nearest:
          return step(a(), nearest_of);
        case Operation::floor:
          return step(a(), floor_of);
        case Operation::ceil:
          return step(a(), ceil_of);
        default:
          return smooth(part.operation, a());
      }
  }



  namespace
  {
    constexpr std::size_t nowhere = std::string::npos;

    /**
     * Parts within parts; each takes some of the stack where the expression is
     * read, and where it is evaluated.
     */
    constexpr unsigned int max_levels = 1000;



    /** The expression around @p position, with a caret below it. */
    std::string
    show_position(const std::string &text, const std::size_t position)
    {
      const std::size_t begin  = position > 60 ? position - 60 : 0;
      const std::string dots   = begin > 0 ? "..." : "";
      const std::string before = quote(text.substr(begin, position - begin));
      std::size_t       column = dots.size();
      for (const unsigned char letter : before)
        column += (letter & 0xC0) != 0x80; // bytes that begin a character
      return "\n  here:    " + dots + before +
             quote(text.substr(position), 40) + "\n           " +
             std::string(column, ' ') + "^";
    }



    [[noreturn]] void
    refuse(const std::string &path,
           const std::string &text,
           const std::string &fault,
           const std::string &allowed,
           const std::size_t  position = nowhere)
    {
      throw InputError(path + " = " + quote(text) + ": " + fault +
                       (position == nowhere || text.empty() ?
                          "" :
                          show_position(text, position)) +
                       "\n  allowed: " + allowed);
    }
  } // namespace



  /** Reads what stands between two positions of a text. */
  class Expression::Reader
  {
  public:
    Reader(Expression            &expression,
           const ExpressionNames &names,
           const std::size_t      begin,
           const std::size_t      end)
      : path(expression.path_)
      , text(expression.text_)
      , names(names)
      , parts(expression.parts)
      , tables(expression.tables_)
      , is_named(expression.is_named)
      , next(begin)
      , end(end)
    {}



    static bool
    is_function(const std::string &name)
    {
      return name == "table" || name == "smooth" ||
             std::any_of(std::begin(functions),
                         std::end(functions),
                         [&](const Function &f) { return f.name == name; });
    }



    void
    read()
    {
      if (skip_blanks() == '\0')
        refuse(path, text, "an empty expression", "0 for none", next);
      unsigned int whole = choice();
      const char   left  = skip_blanks();
      if (left == ')')
        cannot_read("a ')' without a '('");
      if (left == ',')
        refuse(path,
               text,
               "a ',' outside of parentheses",
               "a decimal point, and ';' between components",
               next);
      if (left != '\0')
        cannot_read("an operator is missing before " + next_word());
      if (names.origin != 0.)
        whole = add(Operation::minus, {whole, number(names.origin)});
      if (names.unit != 1.)
        whole = add(Operation::over, {whole, number(names.unit)});
      if (whole + 1 != parts.size()) // the whole is to be the last one
        parts.push_back(Part(parts[whole]));
    }

  private:
    const std::string                         &path;
    const std::string                         &text;
    const ExpressionNames                     &names;
    std::vector<Part>                         &parts;
    std::vector<std::shared_ptr<const Table>> &tables;
    std::vector<bool>                         &is_named;
    std::size_t                                next;
    const std::size_t                          end;
    unsigned int                               n_levels = 0;



    /** A function, and how many arguments it has; 0: any number but none. */
    struct Function
    {
      const char  *name;
      Operation    operation;
      unsigned int n_arguments;
    };

    static constexpr Function functions[] = {
      {"sin", Operation::sin, 1},          {"cos", Operation::cos, 1},
      {"tan", Operation::tan, 1},          {"asin", Operation::asin, 1},
      {"acos", Operation::acos, 1},        {"atan", Operation::atan, 1},
      {"atan2", Operation::angle, 2},      {"sinh", Operation::sinh, 1},
      {"cosh", Operation::cosh, 1},        {"tanh", Operation::tanh, 1},
      {"asinh", Operation::asinh, 1},      {"acosh", Operation::acosh, 1},
      {"atanh", Operation::atanh, 1},      {"sec", Operation::sec, 1},
      {"csc", Operation::csc, 1},          {"cot", Operation::cot, 1},
      {"exp", Operation::exp, 1},          {"log", Operation::log, 1},
      {"ln", Operation::log, 1},           {"log2", Operation::log2, 1},
      {"log10", Operation::log10, 1},      {"sqrt", Operation::sqrt, 1},
      {"pow", Operation::to_the_power, 2}, {"erf", Operation::erf, 1},
      {"erfc", Operation::erfc, 1},        {"abs", Operation::abs, 1},
      {"sign", Operation::sign, 1},        {"rint", Operation::rint, 1},
      {"int", Operation::nearest, 1},      {"floor", Operation::floor, 1},
      {"ceil", Operation::ceil, 1},        {"if", Operation::choice_rounded, 3},
      {"min", Operation::smaller, 0},      {"max", Operation::larger, 0},
      {"sum", Operation::sum, 0},          {"avg", Operation::mean, 0}};



    [[noreturn]] void
    cannot_read(const std::string &fault)
    {
      cannot_read(fault, next);
    }



    [[noreturn]] void
    cannot_read(const std::string &fault, const std::size_t position)
    {
      std::string known;
      for (const std::string &name : names.variables)
        known += name.empty() ? "" : name + ", ";
      known += "pi";
      for (const auto &constant : names.constants)
        known += ", " + constant.first;
      refuse(path,
             text,
             "cannot be read: " + fault,
             "an expression in " + known + ", e.g. " + names.example,
             position);
    }



    /** A part is within another one for the time of its life. */
    class Level
    {
    public:
      explicit Level(Reader &reader)
        : reader(reader)
      {
        if (++reader.n_levels > max_levels)
          reader.cannot_read("more than " + std::to_string(max_levels / 2) +
                             " parts within each other");
      }

      ~Level()
      {
        --reader.n_levels;
      }

      Level(const Level &) = delete;

      Level &
      operator=(const Level &) = delete;

    private:
      Reader &reader;
    };



    char
    at(const std::size_t position) const
    {
      return position < end ? text[position] : '\0';
    }



    char
    skip_blanks()
    {
      while (next < end &&
             std::isspace(static_cast<unsigned char>(text[next])) != 0)
        ++next;
      return at(next);
    }



    bool
    takes(const char *const sign)
    {
      skip_blanks();
      const std::size_t length = std::strlen(sign);
      if (next + length > end || text.compare(next, length, sign) != 0)
        return false;
      next += length;
      return true;
    }



    static bool
    is_of_name(const char letter)
    {
      return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
             letter == '_';
    }



    /** What stands at the present position, in quotes. */
    std::string
    next_word() const
    {
      std::size_t stop = next;
      while (is_of_name(at(stop)))
        ++stop;
      while (stop < end && (stop == next || (text[stop] & 0xC0) == 0x80))
        ++stop; // all bytes of a letter
      return "'" + quote(text.substr(next, stop - next), 40) + "'";
    }



    // ------------------------------------------------------------- the parts

    unsigned int
    number(const double value)
    {
      parts.push_back({Operation::number, value, {0, 0, 0}, 1});
      return parts.size() - 1;
    }



    /** An operation, or its value if it is one of numbers. */
    unsigned int
    add(const Operation                  operation,
        const std::vector<unsigned int> &operands,
        const double                     value = 0.)
    {
      Part part{operation, value, {0, 0, 0}, 1};
      bool is_of_numbers = true;
      for (unsigned int i = 0; i < operands.size(); ++i)
        {
          const Part &operand = parts[operands[i]];
          part.operands[i]    = operands[i];
          part.n_levels       = std::max(part.n_levels, operand.n_levels + 1);
          is_of_numbers &= operand.operation == Operation::number;
        }
      if (part.n_levels > max_levels)
        cannot_read("more than " + std::to_string(max_levels) +
                    " operations one after the other");
      if (is_of_numbers)
        {
          Expression alone;
          for (unsigned int i = 0; i < operands.size(); ++i)
            {
              alone.parts.push_back(parts[operands[i]]);
              part.operands[i] = i;
            }
          alone.parts.push_back(part);
          return number(alone.evaluate<double>(nullptr));
        }
      parts.push_back(part);
      return parts.size() - 1;
    }



    /** Squares, and small powers of variables, are products. */
    unsigned int
    add_power(const unsigned int base, const unsigned int exponent)
    {
      const Part &part        = parts[exponent];
      const bool  is_variable = parts[base].operation == Operation::variable;
      if (part.operation == Operation::number &&
          (part.number == 2. ||
           (is_variable && (part.number == 3. || part.number == 4.))))
        return add(Operation::whole_power, {base}, part.number);
      return add(Operation::to_the_power, {base, exponent});
    }



    // ---------------------------------------------------------- the language

    unsigned int
    choice()
    {
      const Level        level(*this);
      const unsigned int condition = disjunction();
      if (!takes("?"))
        return condition;
      const unsigned int first = choice();
      if (!takes(":"))
        cannot_read("a ':' is missing for a '?'");
      const unsigned int second = choice();
      return add(Operation::choice, {condition, first, second});
    }



    unsigned int
    disjunction()
    {
      unsigned int result = conjunction();
      while (true)
        if (takes("||"))
          result = add(Operation::any, {result, conjunction()});
        else if (takes("|"))
          result = add(Operation::any_rounded, {result, conjunction()});
        else
          return result;
    }



    unsigned int
    conjunction()
    {
      unsigned int result = comparison();
      while (true)
        if (takes("&&"))
          result = add(Operation::both, {result, comparison()});
        else if (takes("&"))
          result = add(Operation::both_rounded, {result, comparison()});
        else
          return result;
    }



    unsigned int
    comparison()
    {
      unsigned int result = sum();
      while (true)
        if (takes("<="))
          result = add(Operation::less_equal, {result, sum()});
        else if (takes(">="))
          {
            const unsigned int other = sum();
            result = add(Operation::less_equal, {other, result});
          }
        else if (takes("=="))
          result = add(Operation::equal, {result, sum()});
        else if (takes("!="))
          result =
            add(Operation::negation, {add(Operation::equal, {result, sum()})});
        else if (takes("<"))
          result = add(Operation::less, {result, sum()});
        else if (takes(">"))
          {
            const unsigned int other = sum();
            result                   = add(Operation::less, {other, result});
          }
        else if (skip_blanks() == '=')
          refuse(path, text, "an '='", "== to compare", next);
        else
          return result;
    }



    unsigned int
    sum()
    {
      unsigned int result = product();
      while (true)
        if (takes("+"))
          result = add(Operation::plus, {result, product()});
        else if (takes("-"))
          result = add(Operation::minus, {result, product()});
        else
          return result;
    }



    unsigned int
    product()
    {
      unsigned int result = signed_power();
      while (true)
        if (takes("*"))
          result = add(Operation::times, {result, signed_power()});
        else if (takes("/"))
          result = add(Operation::over, {result, signed_power()});
        else
          return result;
    }



    unsigned int
    signed_power()
    {
      const Level level(*this);
      if (takes("-"))
        return add(Operation::minus_sign, {signed_power()});
      if (takes("+"))
        return signed_power();
      const unsigned int base = operand();
      return takes("^") ? add_power(base, signed_power()) : base;
    }



    unsigned int
    operand()
    {
      const char first = skip_blanks();
      if (takes("("))
        {
          const std::size_t  begin  = next - 1;
          const unsigned int result = choice();
          close(begin);
          return result;
        }
      if (std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '.')
        return literal();
      if (!is_of_name(first))
        {
          if (first == '=')
            refuse(path, text, "an '='", "== to compare", next);
          cannot_read(first == '\0' ?
                        "it ends where a number or a name should stand" :
                        "a number or a name is missing before " + next_word());
        }
      const std::size_t begin = next;
      while (is_of_name(at(next)))
        ++next;
      const std::string name = text.substr(begin, next - begin);
      return takes("(") ? call(name, begin) : value_of_name(name, begin);
    }



    /** Takes the ')' for the '(' at @p begin. */
    void
    close(const std::size_t begin)
    {
      if (takes(")"))
        return;
      if (skip_blanks() == '\0')
        cannot_read("a ')' is missing");
      if (at(next) == ',')
        refuse(path,
               text,
               "a ',' that separates no arguments",
               "a decimal point, and ',' between arguments of functions",
               next);
      cannot_read("an operator or a ')' is missing before " + next_word() +
                  ", for the '(' at column " + std::to_string(begin + 1));
    }



    unsigned int
    literal()
    {
      double      value = 0.;
      const char *begin = text.data() + next;
      const auto  read  = std::from_chars(begin, text.data() + end, value);
      if (read.ec == std::errc::result_out_of_range)
        cannot_read("a number that is too large or too small");
      if (read.ec != std::errc())
        cannot_read("'.' is no number");
      next += read.ptr - begin;
      if (is_of_name(at(next)) || at(next) == '.')
        cannot_read("an operator is missing before " + next_word());
      return number(value);
    }



    unsigned int
    value_of_name(const std::string &name, const std::size_t begin)
    {
      const auto variable =
        std::find(names.variables.begin(), names.variables.end(), name);
      if (variable != names.variables.end())
        return read_variable(variable - names.variables.begin());
      if (const auto constant = names.constants.find(name);
          constant != names.constants.end())
        return number(constant->second);
      if (name == "pi" || name == "_pi")
        return number(dealii::numbers::PI);
      if (name == "_e")
        return number(dealii::numbers::E);
      std::vector<std::string> known{"pi"};
      for (const std::string &variable : names.variables)
        if (!variable.empty())
          known.push_back(variable);
      for (const auto &constant : names.constants)
        known.push_back(constant.first);
      for (const Function &function : functions)
        {
          if (name == function.name)
            cannot_read("the function " + name + " has no argument; " + name +
                          "(...)",
                        begin);
          known.push_back(function.name);
        }
      cannot_read("there is no name '" + quote(name, 40) + "'" +
                    did_you_mean(name, known),
                  begin);
    }



    unsigned int
    read_variable(const unsigned int index)
    {
      is_named[index] = true;
      parts.push_back({Operation::variable, 0., {index, 0, 0}, 1});
      const unsigned int value = parts.size() - 1;
      if (names.variable_units.empty() || names.variable_units[index] == 1.)
        return value;
      return add(Operation::times,
                 {value, number(names.variable_units[index])});
    }



    /** The opening parenthesis has been read. */
    unsigned int
    call(const std::string &name, const std::size_t begin)
    {
      const std::size_t parenthesis = next - 1;
      if (name == "table" || name == "smooth")
        return read_table(name, parenthesis);
      if (name == "rand" || name == "rand_seed")
        refuse(path,
               text,
               name + "() has another value each time",
               "functions of position and time",
               begin);
      const auto function =
        std::find_if(std::begin(functions),
                     std::end(functions),
                     [&](const Function &f) { return f.name == name; });
      if (function == std::end(functions))
        {
          std::vector<std::string> known;
          for (const Function &f : functions)
            known.push_back(f.name);
          cannot_read("there is no function '" + quote(name, 40) + "()'" +
                        did_you_mean(name, known),
                      begin);
        }
      std::vector<unsigned int> arguments;
      if (skip_blanks() != ')')
        do
          arguments.push_back(choice());
        while (takes(","));
      const std::size_t last = next;
      close(parenthesis);
      const unsigned int n = function->n_arguments;
      if (n == 0 ? arguments.empty() : arguments.size() != n)
        cannot_read(name + "() takes " +
                      (n == 0 ? "one argument or more" :
                       n == 1 ? "one argument" :
                       n == 2 ? "two arguments" :
                                "three arguments") +
                      ", and has " + std::to_string(arguments.size()),
                    last);
      return add_function(function->operation, arguments);
    }



    /** "(FILE, t)" or "(FILE, COLUMN, t)" behind the name. */
    unsigned int
    read_table(const std::string &name, const std::size_t parenthesis)
    {
      std::vector<std::size_t> commas;
      std::size_t              stop = next;
      for (unsigned int depth = 1; stop < end; ++stop)
        {
          depth += text[stop] == '(' ? 1 : 0;
          if (text[stop] == ')' && --depth == 0)
            break;
          if (text[stop] == ',' && depth == 1)
            commas.push_back(stop);
        }
      if (commas.empty() || commas.size() > 2)
        cannot_read(name +
                      "() takes the name of a file, perhaps that of a "
                      "column, and its argument: " +
                      name + "(FILE, COLUMN, t)",
                    parenthesis + 1);
      const auto between = [&](const std::size_t a, const std::size_t b) {
        return dealii::Utilities::trim(text.substr(a, b - a));
      };
      const std::string file = between(next, commas[0]);
      const std::string column =
        commas.size() > 1 ? between(commas[0] + 1, commas[1]) : "";
      try
        {
          tables.push_back(std::make_shared<const Table>(
            names.folder.empty() || file[0] == '/' ? file :
                                                     names.folder + "/" + file,
            column,
            name == "smooth",
            names.has_units));
        }
      catch (const InputError &error)
        {
          throw InputError(path + " = " + quote(text) + ": " + error.what());
        }
      next                        = commas.back() + 1;
      const unsigned int argument = choice();
      close(parenthesis);
      parts.push_back(
        {Operation::table,
         0.,
         {argument, static_cast<unsigned int>(tables.size() - 1), 0},
         parts[argument].n_levels + 1});
      return parts.size() - 1;
    }



    unsigned int
    add_function(const Operation operation, const std::vector<unsigned int> &x)
    {
      switch (operation)
        {
          case Operation::log2:
          case Operation::log10:
            {
              const double base = operation == Operation::log2 ? 2. : 10.;
              return add(Operation::over,
                         {add(Operation::log, x), number(std::log(base))});
            }
          case Operation::sec:
            return add(Operation::over, {number(1.), add(Operation::cos, x)});
          case Operation::csc:
            return add(Operation::over, {number(1.), add(Operation::sin, x)});
          case Operation::cot:
            return add(Operation::over, {number(1.), add(Operation::tan, x)});
          case Operation::smaller:
          case Operation::larger:
          case Operation::sum:
          case Operation::mean:
            {
              const bool adds =
                operation == Operation::sum || operation == Operation::mean;
              unsigned int result = x[0];
              for (unsigned int i = 1; i < x.size(); ++i)
                result =
                  add(adds ? Operation::plus : operation, {result, x[i]});
              if (operation != Operation::mean)
                return result;
              return add(Operation::over, {result, number(x.size())});
            }
          default:
            return add(operation, x);
        }
    }
  };



  Expression::Expression(const std::string     &path,
                         const std::string     &text,
                         const ExpressionNames &names)
    : Expression(path, text, names, 0, text.size())
  {}



  Expression::Expression(const std::string     &path,
                         const std::string     &text,
                         const ExpressionNames &names,
                         const std::size_t      begin,
                         const std::size_t      end)
    : path_(path)
    , text_(text)
    , variable_names(names.variables)
    , is_named(names.variables.size(), false)
  {
    Reader(*this, names, begin, end).read();
    check_values(begin > 0 || end < text.size() ? begin : nowhere);
  }



  void
  Expression::check_values(const std::size_t position) const
  {
    std::vector<double> variables(variable_names.size(), 0.);
    const unsigned int  first =
      std::find_if(variable_names.begin(),
                   variable_names.end(),
                   [](const std::string &name) { return !name.empty(); }) -
      variable_names.begin();
    const bool        has_variable = first < variables.size();
    const std::string name         = has_variable ? variable_names[first] : "";
    const bool        has_time = has_variable && first + 1 < variables.size() &&
                          variable_names.back() == "t";
    for (unsigned int i = 0; i <= 16; ++i)
      {
        if (has_variable)
          variables[first] = i / 16.;
        if (!std::isfinite(evaluate(variables.data())))
          refuse(path_,
                 text_,
                 !has_variable ? "not finite" :
                                 "not finite at " + name + " = " +
                                   significant(i / 16., few_digits) +
                                   (has_time ? ", t = 0" : ""),
                 !has_variable ?
                   "expressions that are finite" :
                   "expressions that are finite on 0 <= " + name + " <= 1",
                 position);
      }
  }



  bool
  Expression::operator==(const Expression &other) const
  {
    return tables_.empty() && other.tables_.empty() &&
           std::equal(parts.begin(),
                      parts.end(),
                      other.parts.begin(),
                      other.parts.end(),
                      [](const Part &a, const Part &b) {
                        return a.operation == b.operation &&
                               a.number == b.number &&
                               std::equal(a.operands,
                                          a.operands + 3,
                                          b.operands);
                      });
  }



  bool
  Expression::depends_on(const std::string &variable) const
  {
    for (unsigned int i = 0; i < variable_names.size(); ++i)
      if (variable_names[i] == variable)
        return is_named[i];
    return false;
  }



  std::vector<std::string>
  Expression::tables_left(const double *variables) const
  {
    std::vector<std::string> files;
    for (const Part &part : parts)
      if (part.operation == Operation::table &&
          !tables_[part.operands[1]]->range().contains(
            evaluate_part(part.operands[0], variables)))
        files.push_back(tables_[part.operands[1]]->file_name());
    return files;
  }



  bool
  Expression::is_constant() const
  {
    return std::none_of(is_named.begin(), is_named.end(), [](const bool is) {
      return is;
    });
  }



  template double
  Expression::evaluate_part(const unsigned int, const double *) const;
  template NumberJet
  Expression::evaluate_part(const unsigned int, const NumberJet *) const;
  template IntervalJet
  Expression::evaluate_part(const unsigned int, const IntervalJet *) const;



  std::vector<std::string>
  identifiers_in(const std::string &text)
  {
    const auto is_in_word = [&text](const std::size_t i) {
      return i < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[i])) != 0 ||
              text[i] == '_' || text[i] == '.');
    };
    std::vector<std::string> names;
    for (std::size_t i = 0; i < text.size(); ++i)
      if (is_in_word(i))
        {
          const std::size_t begin = i;
          while (is_in_word(i))
            ++i;
          if (std::isdigit(static_cast<unsigned char>(text[begin])) == 0)
            names.push_back(text.substr(begin, i - begin));
        }
    return names;
  }



  bool
  can_name_constant(const std::string &name)
  {
    static const std::vector<std::string> taken{
      "x", "y", "z", "t", "gap", "pressure", "theta_A", "pi", "_pi", "_e"};
    return identifiers_in(name) == std::vector<std::string>{name} &&
           name.find('.') == std::string::npos &&
           std::find(taken.begin(), taken.end(), name) == taken.end() &&
           !Expression::Reader::is_function(name);
  }



  namespace
  {
    /** Constants whose values follow from each other. */
    class ConstantEvaluator
    {
    public:
      explicit ConstantEvaluator(
        const std::map<std::string, std::string> &texts)
        : texts(texts)
      {}

      std::map<std::string, double>
      values()
      {
        for (const auto &constant : texts)
          evaluate(constant.first);
        return known;
      }

    private:
      const std::map<std::string, std::string> &texts;
      std::map<std::string, double>             known;
      std::vector<std::string>                  open; ///< being evaluated

      void
      evaluate(const std::string &name)
      {
        if (known.count(name) > 0)
          return;
        const std::string &text  = texts.at(name);
        const auto         first = std::find(open.begin(), open.end(), name);
        if (first != open.end())
          {
            std::string path;
            for (auto other = first; other != open.end(); ++other)
              path += *other + " -> ";
            path += name;
            throw InputError("Constants/" + name + " = " + quote(text) +
                             ": it depends on itself: " + path +
                             "\n  allowed: numbers, or expressions in other "
                             "constants");
          }
        open.push_back(name);
        for (const std::string &other : identifiers_in(text))
          if (texts.count(other) > 0)
            evaluate(other);
        known[name] =
          Expression("Constants/" + name, text, {{}, known, "2*pi/3"})
            .evaluate<double>(nullptr);
        open.pop_back();
      }
    };
  } // namespace



  std::map<std::string, double>
  evaluate_constants(const std::map<std::string, std::string> &texts)
  {
    return ConstantEvaluator(texts).values();
  }



  std::vector<Expression>
  read_components(const std::string     &path,
                  const std::string     &text,
                  const unsigned int     n_components,
                  const ExpressionNames &names)
  {
    std::vector<std::size_t> begins{0};
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == ';')
        begins.push_back(i + 1);
    if (begins.size() != 1 && begins.size() != n_components)
      refuse(path,
             text,
             std::to_string(begins.size()) + " components",
             n_components > 1 ? "1 (axial) or " + std::to_string(n_components) +
                                  ", separated by ';'" :
                                "one expression, without ';'",
             begins[std::min<std::size_t>(n_components, begins.size() - 1)]);
    std::vector<Expression> components;
    begins.push_back(text.size() + 1);
    for (unsigned int c = 0; c + 1 < begins.size(); ++c)
      components.push_back(
        Expression(path, text, names, begins[c], begins[c + 1] - 1));
    while (components.size() < n_components)
      components.emplace_back(path, "0", names);
    return components;
  }
} // namespace ThermoContact
