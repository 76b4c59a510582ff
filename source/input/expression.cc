// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
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

namespace ThermoContact
{
  template <typename Number>
  Number
  Expression::evaluate_part(const unsigned int index,
                            const Number      *variables) const
  {
    const Part &part = parts[index];
    switch (part.kind)
      {
        case Part::number:
          return Number(part.value);
        case Part::variable:
          return variables[part.operands[0]];
        case Part::table:
          return tables_[part.operands[1]]->evaluate(
            evaluate_part(part.operands[0], variables));
        default:
          std::array<Number, max_operands> operands;
          for (unsigned int i = 0; i < part.n_operands; ++i)
            operands[i] = evaluate_part(part.operands[i], variables);
          return (*part.operation)(operands.data());
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
      const std::size_t begin  = position - std::min<std::size_t>(position, 60);
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
    refuse_formula(const std::string &path,
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



  /** Reads the part between two positions of a text. */
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
        refuse_formula(path, text, "an empty expression", "0 for none", next);
      choice();
      const char left = skip_blanks();
      if (left == ')')
        cannot_read("a ')' without a '('");
      if (left == ',')
        cannot_read("a ',' outside of parentheses; numbers have a decimal "
                    "point, and ';' is between components");
      if (left != '\0')
        cannot_read(
          "an operator is missing before " + next_word() +
          (left == ':' ? "; ranges, for Study/Vary, are 1 .. 2 (7)" : ""));
      // a sign changes no unit; a factor may have one
      const Part *last = &parts.back();
      while (last->operation == find_operation("-") &&
             parts[last->operands[0]].kind == Part::number &&
             parts[last->operands[0]].value == 0.)
        last = &parts[last->operands[1]];
      if (last->kind == Part::table && !names.units.empty())
        {
          const MeasuredTable &table = *tables[last->operands[1]];
          check_unit(table, table.unit_of_values, names.units.back());
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



    /** The units of the numbers in an expression, if they are known. */
    std::string
    units_text() const
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
      refuse_formula(path,
                     text,
                     "cannot be read: " + fault,
                     "an expression in " + join_words(known_names()) +
                       units_text(),
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
    is_name_character(const char letter)
    {
      return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
             letter == '_';
    }



    /** The word at the present position, in quotes. */
    std::string
    next_word() const
    {
      std::size_t stop = next;
      while (is_name_character(at(stop)))
        ++stop;
      while (stop < end && (stop == next || (text[stop] & 0xC0) == 0x80))
        ++stop; // all bytes of a letter
      return "'" + quote(text.substr(next, stop - next), 40) + "'";
    }



    // ------------------------------------------------------------- the parts

    unsigned int
    add(const Part &part)
    {
      if (part.n_levels > max_levels)
        cannot_read("more than " + std::to_string(max_levels) +
                    " operations one after the other");
      parts.push_back(part);
      return parts.size() - 1;
    }



    unsigned int
    number(const double value)
    {
      return add({Part::number, value});
    }



    /** An operation, or its value if it is one of numbers. */
    unsigned int
    apply(const Operation &operation, const std::vector<unsigned int> &operands)
    {
      Part part{Part::operation_on_parts, 0., &operation};
      part.n_operands = operands.size();
      std::array<double, max_operands> values{};
      bool                             all_numbers = true;
      for (unsigned int i = 0; i < operands.size(); ++i)
        {
          const Part &operand = parts[operands[i]];
          part.operands[i]    = operands[i];
          part.n_levels       = std::max(part.n_levels, operand.n_levels + 1);
          values[i]           = operand.value;
          all_numbers &= operand.kind == Part::number;
        }
      return all_numbers ? number(operation(values.data())) : add(part);
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
          result = apply(*find_operation("if"), {result, first, second});
        }
      --n_levels;
      return result;
    }



    /** Operators of @p level and above. */
    unsigned int
    binary(const unsigned int level)
    {
      if (level == Operation::n_levels)
        return signed_power();
      unsigned int result = binary(level + 1);
      while (true)
        {
          const auto found =
            std::find_if(operations().begin(),
                         operations().end(),
                         [&](const Operation &one) {
                           return one.level == level && takes(one.name.c_str());
                         });
          if (found == operations().end())
            {
              if (level == Operation::level_of_comparisons)
                refuse_assignment();
              return result;
            }
          result = apply(*found, {result, binary(level + 1)});
        }
    }



    void
    refuse_assignment()
    {
      if (skip_blanks() == '=')
        refuse_formula(path, text, "an '='", "== to compare", next);
    }



    unsigned int
    signed_power()
    {
      enter();
      unsigned int result;
      if (takes("-"))
        result = apply(*find_operation("-"), {number(0.), signed_power()});
      else if (takes("+"))
        result = signed_power();
      else if (result = operand(); takes("^"))
        result = apply(*find_operation("^"), {result, signed_power()});
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
      if (!is_name_character(first))
        {
          refuse_assignment();
          cannot_read(first == '\0' ?
                        "it ends where a number or a name should stand" :
                        "a number or a name is missing before " + next_word() +
                          (first == '*' ? "; powers are written x^2" : ""));
        }
      const std::size_t begin = next;
      while (is_name_character(at(next)))
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
        refuse_formula(
          path,
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
      if (is_name_character(at(next)) || at(next) == '.')
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
          return add({Part::variable, 0., nullptr, 0, {{index}}});
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
      cannot_read("there is no name '" + quote(name) + "'" +
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
        refuse_formula(path,
                       text,
                       name + "() has another value each time",
                       "functions of position and time",
                       begin);
      const Operation *const function = find_operation(name);
      if (function == nullptr)
        cannot_read("there is no function '" + quote(name) + "()'" +
                      did_you_mean(name, function_names()),
                    begin);
      std::vector<unsigned int> arguments;
      if (skip_blanks() != ')')
        do
          arguments.push_back(choice());
        while (takes(","));
      const std::size_t last = next;
      close(parenthesis);
      const unsigned int n = function->n_operands;
      if (n == 0 ? arguments.empty() : arguments.size() != n)
        cannot_read(name + "() takes " +
                      (n == 0 ? "one argument or more" :
                       n == 1 ? "one argument" :
                       n == 2 ? "two arguments" :
                                "three arguments") +
                      ", and has " + std::to_string(arguments.size()),
                    last);
      if (n > 0)
        return apply(*function, arguments);
      unsigned int result = arguments[0];
      for (unsigned int i = 1; i < arguments.size(); ++i)
        result = apply(*function, {result, arguments[i]});
      return name == "avg" ?
               apply(*find_operation("/"), {result, number(arguments.size())}) :
               result;
    }



    /** Refuses the unit of a column that is no measure of what is @p needed. */
    void
    check_unit(const MeasuredTable &table,
               const std::string   &unit,
               const std::string   &needed) const
    {
      if (!unit.empty() && unit != needed && !convert_unit(1., unit, needed))
        throw InputError(path + " = " + quote(text) + ": " +
                         quote(table.file_name) + ": the header has the unit " +
                         unit + "\n  allowed: a unit of the kind of " + needed +
                         "\n  remedy:  another column, or its unit");
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
                      "() takes the name of a file, perhaps of a column "
                      "in it, and its argument: " +
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
          part.kind == Part::variable && !names.units.empty())
        check_unit(*tables.back(),
                   tables.back()->unit_of_arguments,
                   names.units[part.operands[0]]);
      return add({Part::table,
                  0.,
                  nullptr,
                  0,
                  {{argument, static_cast<unsigned int>(tables.size() - 1)}},
                  parts[argument].n_levels + 1});
    }
  };



  std::vector<std::string>
  Expression::function_names()
  {
    std::vector<std::string> names{"table", "smooth"};
    for (const Operation &operation : operations())
      if (operation.level == Operation::is_function)
        names.push_back(operation.name);
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
    const auto          first =
      std::find_if(variable_names.begin(),
                   variable_names.end(),
                   [](const std::string &name) { return !name.empty(); });
    const bool varies = first != variable_names.end();
    for (unsigned int i = 0; i <= (varies ? 16 : 0); ++i)
      {
        if (varies)
          variables[first - variable_names.begin()] = i / 16.;
        if (!std::isfinite(evaluate(variables.data())))
          refuse_formula(path_,
                         text_,
                         "not finite" +
                           (varies ? " at " + *first + " = " +
                                       significant(i / 16., few_digits) :
                                     "") +
                           (varies && *first != "t" &&
                                variable_names.back() == "t" ?
                              ", t = 0" :
                              ""),
                         "expressions that are finite" +
                           (varies ? " on 0 <= " + *first + " <= 1" : ""),
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
                        return a.kind == b.kind && a.value == b.value &&
                               a.operation == b.operation &&
                               a.operands == b.operands;
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
      if (part.kind == Part::table &&
          !tables_[part.operands[1]]->range().contains(
            evaluate_part(part.operands[0], variables)))
        files.push_back(tables_[part.operands[1]]->file_name);
    return files;
  }



  std::string
  Expression::doubt_beyond(const std::string &file,
                           const std::string &where) const
  {
    return path() + ": " + quote(file) + " has no row " + where +
           ": the value of its nearest row holds there";
  }



  std::vector<std::string>
  Expression::doubts_of_tables() const
  {
    std::vector<std::string> doubts;
    for (const auto &table : tables_)
      doubts.insert(doubts.end(), table->doubts.begin(), table->doubts.end());
    return doubts;
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



  std::string
  Expression::with_variables(const std::vector<std::string> &others) const
  {
    std::string result;
    std::size_t end = 0; // of the part that is in the result
    for (const NamedVariable &one : named)
      {
        result += text_.substr(end, one.position - end) + others[one.index];
        end = one.position + variable_names[one.index].size();
      }
    return result + text_.substr(end);
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
      refuse_formula(
        path,
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
