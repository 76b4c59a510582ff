// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/elementary_functions.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/measured_table.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/unit_text.h>
#include <thermocontact/input/unknown_names.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <functional>
#include <type_traits>

namespace ThermoContact
{
  enum class Expression::Operation
  {
    number,
    variable,
    function, ///< an elementary one
    table,
    // of one operand
    minus_sign,
    negation,
    abs,
    // of two
    plus,
    minus,
    times,
    over,
    power,
    angle,
    less,
    less_equal,
    equal,
    both,
    any,
    smaller,
    larger,
    choice ///< of three, the first one is a condition
  };



  namespace
  {
    constexpr double least = std::numeric_limits<double>::denorm_min();



    // ---------------------------------------------------- powers and angles

    /** Whole powers that are small are products. */
    double
    power(const double a, const double b)
    {
      return b == 2. ? a * a :
             b == 3. ? a * a * a :
             b == 4. ? a * a * a * a :
                       std::pow(a, b);
    }

    template <typename Number>
    Jet<Number>
    power(const Jet<Number> &a, const Jet<Number> &b)
    {
      using std::exp;
      if (Interval(b.value).width() == 0. && Interval(b.first).width() == 0. &&
          Interval(b.first).contains(0.))
        return constant_power(a, Interval(b.value).low);
      const Number slope = 1. / a.value;
      const auto   exponent =
        b *
        chain(a, monotone(std::log, a.value), slope, Number(-square(slope)));
      const Number value  = exp(exponent.value);
      Jet<Number>  result = chain(exponent, value, value, value);
      if constexpr (std::is_same_v<Number, double>)
        result.value = std::pow(a.value, b.value);
      return result;
    }

    double
    angle(const double y, const double x)
    {
      return std::atan2(y, x);
    }

    Interval
    angle(const Interval &y, const Interval &x)
    {
      if (x.low <= 0. && y.contains(0.))
        return Interval::everything(); // the origin, or the branch cut
      return hull(widened(std::atan2(y.low, x.low), std::atan2(y.high, x.high)),
                  widened(std::atan2(y.low, x.high),
                          std::atan2(y.high, x.low)));
    }

    template <typename Number>
    Jet<Number>
    angle(const Jet<Number> &y, const Jet<Number> &x)
    {
      const Number n  = x.value * y.first - y.value * x.first;
      const Number n1 = x.value * y.second - y.value * x.second;
      const Number r  = square(x.value) + square(y.value);
      const Number r1 = 2. * (x.value * x.first + y.value * y.first);
      return {angle(y.value, x.value), n / r, (n1 * r - n * r1) / square(r)};
    }



    // ------------------------------------------------------- jumps and kinks

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

    /** What is one or the other in a span of time; numbers decide. */
    template <typename Number>
    Number
    either(const Number &a, const Number &b)
    {
      if constexpr (std::is_same_v<Number, IntervalJet>)
        return {hull(a.value, b.value),
                Interval::everything(),
                Interval::everything()};
      return a;
    }

    /** The smaller or the larger one of two. */
    template <typename Number>
    Number
    extremum(const Number &a, const Number &b, const bool is_larger)
    {
      const Truth takes_b = is_larger ? is_less(value_of(a), value_of(b)) :
                                        is_less(value_of(b), value_of(a));
      if constexpr (std::is_same_v<Number, IntervalJet>)
        if (takes_b == Truth::undecided)
          {
            const auto of = [is_larger](const double x, const double y) {
              return is_larger ? std::max(x, y) : std::min(x, y);
            };
            return {{of(a.value.low, b.value.low),
                     of(a.value.high, b.value.high)},
                    hull(a.first, b.first),
                    Interval::everything()};
          }
      return takes_b == Truth::yes ? b : a;
    }

    template <typename Number>
    Number
    number_of(const Truth truth)
    {
      return truth == Truth::undecided ? either(Number(0.), Number(1.)) :
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
               either(b(), evaluate_part(part.operands[2], variables)) :
             truth == Truth::yes ? b() :
                                   evaluate_part(part.operands[2], variables);
    };
    const auto is_true = [&](const Number &x) {
      return is_at_least(value_of(x), part.number);
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
        case Operation::power:
          return power(a(), b());
        case Operation::less:
          return number_of<Number>(is_less(value_of(a()), value_of(b())));
        case Operation::less_equal:
          return number_of<Number>(!is_less(value_of(b()), value_of(a())));
        case Operation::equal:
          return number_of<Number>(is_equal(value_of(a()), value_of(b())));
        case Operation::negation:
          return Number(1.) - a();
        case Operation::both:
          return number_of<Number>(both(is_true(a()), is_true(b())));
        case Operation::any:
          return number_of<Number>(!both(!is_true(a()), !is_true(b())));
        case Operation::smaller:
          return extremum(a(), b(), false);
        case Operation::larger:
          return extremum(a(), b(), true);
        case Operation::angle:
          return angle(a(), b());
        case Operation::choice:
          return choose(is_true(a()));
        case Operation::table:
          return tables_[part.operands[1]]->evaluate(a());
        case Operation::minus_sign:
          return -a();
        case Operation::abs:
          {
            const Number x = a();
            return extremum(x, Number(-x), true);
          }
        default:
          return elementary_functions()[part.operands[1]](a());
      }
  }



  namespace
  {
    /** A function, and how many arguments it has; 0: any number but none. */
    struct Function
    {
      const char           *name;
      Expression::Operation operation;
      unsigned int          n_arguments;
    };

    /** Those that are not elementary. */
    constexpr Function functions[] = {
      {"abs", Expression::Operation::abs, 1},
      {"atan2", Expression::Operation::angle, 2},
      {"pow", Expression::Operation::power, 2},
      {"min", Expression::Operation::smaller, 0},
      {"max", Expression::Operation::larger, 0},
      {"sum", Expression::Operation::plus, 0},
      {"avg", Expression::Operation::plus, 0},
      {"if", Expression::Operation::choice, 3}};



    /** An operator between two operands. */
    struct Operator
    {
      const char           *sign;
      unsigned int          level; ///< larger ones bind first
      Expression::Operation operation;
      bool                  is_swapped = false, is_negated = false;
      double                truth = 0.; ///< as Part::number
    };

    /** Of those that begin alike the longer one is first. */
    constexpr Operator operators[] = {
      {"||", 0, Expression::Operation::any, false, false, 1.},
      {"|", 0, Expression::Operation::any, false, false, 0.5},
      {"&&", 1, Expression::Operation::both, false, false, 1.},
      {"&", 1, Expression::Operation::both, false, false, 0.5},
      {"<=", 2, Expression::Operation::less_equal},
      {">=", 2, Expression::Operation::less_equal, true},
      {"==", 2, Expression::Operation::equal},
      {"!=", 2, Expression::Operation::equal, false, true},
      {"<", 2, Expression::Operation::less},
      {">", 2, Expression::Operation::less, true},
      {"+", 3, Expression::Operation::plus},
      {"-", 3, Expression::Operation::minus},
      {"*", 4, Expression::Operation::times},
      {"/", 4, Expression::Operation::over}};

    constexpr unsigned int level_of_comparisons = 2, level_of_signs = 5;



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
      , named(expression.named)
      , next(begin)
      , end(end)
    {}



    void
    read()
    {
      if (skip_blanks() == '\0')
        refuse(path, text, "an empty expression", "0 for none", next);
      const unsigned int whole = choice();
      const char         left  = skip_blanks();
      if (left == ')')
        cannot_read("a ')' without a '('");
      if (left == ',')
        refuse(path,
               text,
               "a ',' outside of parentheses",
               "a decimal point, and ';' between components",
               next);
      if (left != '\0')
        cannot_read(
          "an operator is missing before " + next_word() +
          (left == ':' ? "; ranges, for Study/Vary, are 1 .. 2 (7)" : ""));
      if (whole + 1 != parts.size()) // the whole is to be the last one
        parts.push_back(Part(parts[whole]));
      if (parts.back().operation == Operation::table && !names.units.empty())
        {
          const MeasuredTable &table = *tables[parts.back().operands[1]];
          check_unit(table, table.unit_of_values(), names.units.back());
        }
    }

  private:
    const std::string                                 &path;
    const std::string                                 &text;
    const ExpressionNames                             &names;
    std::vector<Part>                                 &parts;
    std::vector<std::shared_ptr<const MeasuredTable>> &tables;
    std::vector<NamedVariable>                        &named;
    std::size_t                                        next;
    const std::size_t                                  end;
    unsigned int                                       n_levels = 0;



    /** The names of numbers. */
    std::vector<std::string>
    known_names() const
    {
      std::vector<std::string> known = names.variables;
      known.emplace_back("pi");
      for (const auto &constant : names.constants)
        known.push_back(constant.first);
      return known;
    }



    /** In which the numbers of an expression are, if that is known. */
    std::string
    words_of_units() const
    {
      std::string words;
      for (unsigned int i = 0; i < names.units.size(); ++i)
        words +=
          (words.empty() ? "; numbers have no units: " : ", ") +
          (i < names.variables.size() ? names.variables[i] : "the value") +
          " is in " + names.units[i];
      return words;
    }



    /** @param position the present one if it is nowhere */
    [[noreturn]] void
    cannot_read(const std::string &fault, const std::size_t position = nowhere)
    {
      refuse(path,
             text,
             "cannot be read: " + fault,
             "an expression in " + join_words(known_names()) + ", e.g. " +
               names.example + words_of_units(),
             position == nowhere ? next : position);
    }



    /** A part within another one begins. */
    void
    enter()
    {
      if (++n_levels > max_levels)
        cannot_read("more than " + std::to_string(max_levels / 2) +
                    " parts within each other");
    }



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
        const unsigned int               elementary = 0,
        const double                     truth      = 0.)
    {
      Part part{operation, truth, {0, elementary, 0}, 1};
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



    // ---------------------------------------------------------- the language

    unsigned int
    choice()
    {
      enter();
      unsigned int result = binary(0);
      if (takes("?"))
        {
          const unsigned int first = choice();
          if (!takes(":"))
            cannot_read("a ':' is missing for a '?'");
          const unsigned int second = choice();
          result = add(Operation::choice, {result, first, second}, 0, least);
        }
      --n_levels;
      return result;
    }



    /** Operators of @p level and above. */
    unsigned int
    binary(const unsigned int level)
    {
      if (level == level_of_signs)
        return signed_power();
      unsigned int result = binary(level + 1);
      while (true)
        {
          const auto found =
            std::find_if(std::begin(operators),
                         std::end(operators),
                         [&](const Operator &o) {
                           return o.level == level && takes(o.sign);
                         });
          if (found == std::end(operators))
            {
              if (level == level_of_comparisons)
                refuse_assignment();
              return result;
            }
          const unsigned int other = binary(level + 1);
          result                   = found->is_swapped ?
                                       add(found->operation, {other, result}) :
                                       add(found->operation, {result, other}, 0, found->truth);
          if (found->is_negated)
            result = add(Operation::negation, {result});
        }
    }



    void
    refuse_assignment()
    {
      if (skip_blanks() == '=')
        refuse(path, text, "an '='", "== to compare", next);
    }



    unsigned int
    signed_power()
    {
      enter();
      unsigned int result;
      if (takes("-"))
        result = add(Operation::minus_sign, {signed_power()});
      else if (takes("+"))
        result = signed_power();
      else if (result = operand(); takes("^"))
        result = add(Operation::power, {result, signed_power()});
      --n_levels;
      return result;
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
          refuse_assignment();
          cannot_read(first == '\0' ?
                        "it ends where a number or a name should stand" :
                        "a number or a name is missing before " + next_word() +
                          (first == '*' ? "; powers are written x^2" : ""));
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
        {
          const unsigned int index = variable - names.variables.begin();
          named.push_back({index, begin});
          parts.push_back({Operation::variable, 0., {index, 0, 0}, 1});
          return parts.size() - 1;
        }
      if (const auto constant = names.constants.find(name);
          constant != names.constants.end())
        return number(constant->second);
      if (name == "pi" || name == "_pi")
        return number(dealii::numbers::PI);
      if (name == "_e")
        return number(dealii::numbers::E);
      std::vector<std::string> known = function_names();
      if (std::find(known.begin(), known.end(), name) != known.end())
        cannot_read("the function " + name + " has no argument; " + name +
                      "(...)",
                    begin);
      for (const std::string &other : known_names())
        known.push_back(other);
      cannot_read("there is no name '" + quote(name, 40) + "'" +
                    did_you_mean(name, known),
                  begin);
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
      const auto is_it = [&](const auto &f) { return f.name == name; };
      const auto function =
        std::find_if(std::begin(functions), std::end(functions), is_it);
      const auto elementary    = std::find_if(elementary_functions().begin(),
                                           elementary_functions().end(),
                                           is_it);
      const bool is_elementary = elementary != elementary_functions().end();
      if (function == std::end(functions) && !is_elementary)
        cannot_read("there is no function '" + quote(name, 40) + "()'" +
                      did_you_mean(name, function_names()),
                    begin);
      std::vector<unsigned int> arguments;
      if (skip_blanks() != ')')
        do
          arguments.push_back(choice());
        while (takes(","));
      const std::size_t last = next;
      close(parenthesis);
      const unsigned int n = is_elementary ? 1 : function->n_arguments;
      if (n == 0 ? arguments.empty() : arguments.size() != n)
        cannot_read(name + "() takes " +
                      (n == 0 ? "one argument or more" :
                       n == 1 ? "one argument" :
                       n == 2 ? "two arguments" :
                                "three arguments") +
                      ", and has " + std::to_string(arguments.size()),
                    last);
      if (is_elementary)
        return add(Operation::function,
                   arguments,
                   elementary - elementary_functions().begin());
      if (n > 0)
        return add(function->operation, arguments, 0, 0.5);
      unsigned int result = arguments[0];
      for (unsigned int i = 1; i < arguments.size(); ++i)
        result = add(function->operation, {result, arguments[i]});
      return name == "avg" ?
               add(Operation::over, {result, number(arguments.size())}) :
               result;
    }



    /** Refuses the unit of a column that is no measure of what is @p needed. */
    void
    check_unit(const MeasuredTable &table,
               const std::string   &unit,
               const std::string   &needed) const
    {
      if (!unit.empty() && !convert_unit(1., unit, needed))
        throw InputError(path + " = " + quote(text) + ": " +
                         quote(table.file_name()) +
                         ": the header has the unit " + unit +
                         "\n  allowed: a unit that measures what " + needed +
                         " does\n  remedy:  another column, or its unit");
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
      if (file[0] == '"' || file[0] == '\'')
        cannot_read("names of files stand without quotes");
      const std::string column =
        commas.size() > 1 ? between(commas[0] + 1, commas[1]) : "";
      try
        {
          tables.push_back(std::make_shared<const MeasuredTable>(
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
      if (const Part &part = parts[argument];
          part.operation == Operation::variable && !names.units.empty())
        check_unit(*tables.back(),
                   tables.back()->unit_of_arguments(),
                   names.units[part.operands[0]]);
      parts.push_back(
        {Operation::table,
         0.,
         {argument, static_cast<unsigned int>(tables.size() - 1), 0},
         parts[argument].n_levels + 1});
      return parts.size() - 1;
    }
  };



  std::vector<std::string>
  Expression::function_names()
  {
    std::vector<std::string> names{"table", "smooth"};
    for (const Function &function : functions)
      names.emplace_back(function.name);
    for (const ElementaryFunction &function : elementary_functions())
      names.push_back(function.name);
    return names;
  }



  Expression::Expression(const std::string     &path,
                         const std::string     &text,
                         const ExpressionNames &names,
                         const std::size_t      begin,
                         const std::size_t      end)
    : path_(path)
    , text_(text)
    , variable_names(names.variables)
  {
    Reader(*this, names, begin, std::min(end, text.size())).read();
    if (names.checks_values)
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
    return std::any_of(named.begin(),
                       named.end(),
                       [&](const NamedVariable &one) {
                         return variable_names[one.index] == variable;
                       });
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
    std::vector<std::string> taken = Expression::function_names();
    for (const char *const variable :
         {"x", "y", "z", "t", "gap", "pressure", "theta_A", "pi", "_pi", "_e"})
      taken.emplace_back(variable);
    return identifiers_in(name) == std::vector<std::string>{name} &&
           name.find('.') == std::string::npos &&
           std::find(taken.begin(), taken.end(), name) == taken.end();
  }



  std::map<std::string, double>
  evaluate_constants(const std::map<std::string, std::string> &texts)
  {
    std::map<std::string, double>                  known;
    std::vector<std::string>                       open; // being evaluated
    const std::function<void(const std::string &)> evaluate =
      [&](const std::string &name) {
        if (known.count(name) > 0)
          return;
        const std::string path = "Constants/" + name, &text = texts.at(name);
        const auto        first = std::find(open.begin(), open.end(), name);
        if (first != open.end())
          {
            std::string circle;
            for (auto other = first; other != open.end(); ++other)
              circle += *other + " -> ";
            refuse(path,
                   text,
                   "it depends on itself: " + circle + name,
                   "numbers, or expressions in other constants");
          }
        open.push_back(name);
        for (const std::string &other : identifiers_in(text))
          if (texts.count(other) > 0)
            evaluate(other);
        known[name] = Expression(path, text, {{}, known, "2*pi/3"})
                        .evaluate<double>(nullptr);
        open.pop_back();
      };
    // numbers first, so that a misprint of their names is answered with them
    for (const bool is_number : {true, false})
      for (const auto &[name, text] : texts)
        if (parse_number(text).has_value() == is_number)
          evaluate(name);
    return known;
  }



  std::string
  rename_variables(const std::string              &path,
                   const std::string              &text,
                   const ExpressionNames          &names,
                   const std::vector<std::string> &others)
  {
    ExpressionNames unchecked = names;
    unchecked.checks_values   = false;
    const Expression expression(path, text, unchecked);
    std::string      result;
    std::size_t      end = 0; // of what is in the result
    for (const Expression::NamedVariable &one : expression.named_variables())
      {
        result += text.substr(end, one.position - end) + others[one.index];
        end = one.position + names.variables[one.index].size();
      }
    return result + text.substr(end);
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
      components.emplace_back(path, text, names, begins[c], begins[c + 1] - 1);
    while (components.size() < n_components)
      components.emplace_back(path, "0", names);
    return components;
  }
} // namespace ThermoContact
