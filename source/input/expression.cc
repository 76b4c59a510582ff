// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameter_text.h>

#include <deal.II/base/mu_parser_internal.h>
#include <deal.II/base/utilities.h>

#include <muParser.h>

#include <cctype>
#include <cmath>
#include <regex>

namespace ThermoContact
{
  namespace
  {
    constexpr std::size_t nowhere = std::string::npos;



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
    refuse(const Expression  &expression,
           const std::string &fault,
           const std::string &allowed,
           const std::size_t  position = nowhere)
    {
      throw InputError(expression.path + " = " + quote(expression.text) + ": " +
                       fault +
                       (position == nowhere || expression.text.empty() ?
                          "" :
                          show_position(expression.text, position)) +
                       "\n  allowed: " + allowed);
    }



    struct Component
    {
      std::size_t begin; ///< in the text of the expression
      std::string text;
    };

    /** Splits an expression at ';'; none of the parts is empty. */
    std::vector<Component>
    split_components(const Expression &expression)
    {
      const std::string     &text = expression.text;
      std::vector<Component> components;
      std::size_t            begin = 0;
      while (true)
        {
          const auto end = text.find(';', begin);
          components.push_back({begin, text.substr(begin, end - begin)});
          if (Utilities::trim(components.back().text).empty())
            refuse(expression, "an empty expression", "0 for none", begin);
          if (end == std::string::npos)
            return components;
          begin = end + 1;
        }
    }



    /**
     * Refuses what muParser reads without a word, and not as it is meant: of
     * 0,5 it keeps the 5, and x=1 changes x.
     */
    void
    check_signs(const Expression &expression)
    {
      const std::string &text  = expression.text;
      int                depth = 0;
      for (std::size_t i = 0; i < text.size(); ++i)
        {
          depth =
            text[i] == ';' ? 0 : depth + (text[i] == '(') - (text[i] == ')');
          if (text[i] == ',' && depth <= 0)
            refuse(expression,
                   "a ',' outside of parentheses",
                   "a decimal point, and ';' between components",
                   i);
          const bool is_comparison =
            text.find_first_of("=", i + 1) == i + 1 ||
            (i > 0 && std::string("=<>!").find(text[i - 1]) != nowhere);
          if (text[i] == '=' && !is_comparison)
            refuse(expression, "an '='", "== to compare", i);
        }
    }



    /** Refuses functions whose values differ from run to run. */
    void
    check_determinism(const Expression &expression)
    {
      static const std::regex random("\\brand\\s*\\(");
      std::smatch             match;
      if (std::regex_search(expression.text, match, random))
        refuse(expression,
               "rand() differs from run to run",
               "functions of position and time; rand_seed(n) for one value",
               match.position());
    }



    /**
     * The text that deal.II hands to muParser, which wants no blank between the
     * name of a function and its parenthesis.
     */
    std::string
    without_blanks_behind_names(std::string text)
    {
      for (const std::string &name :
           dealii::internal::FunctionParser::get_function_names())
        for (auto at = text.find(name); at != nowhere;
             at      = text.find(name, at + name.size()))
          {
                 const std::size_t end = at + name.size();
                 text.erase(end, text.find_first_not_of(" \t", end) - end);
          }
      return text;
    }



    /**
     * Tells a muParser the names that deal.II's FunctionParser adds to its own.
     * Only their numbers of arguments matter where expressions are checked.
     */
    void
    define_functions(mu::Parser &parser)
    {
      const auto none  = []() { return 0.; };
      const auto one   = [](double) { return 0.; };
      const auto two   = [](double, double) { return 0.; };
      const auto three = [](double, double, double) { return 0.; };
      for (const char *name : {"int",
                               "ceil",
                               "cot",
                               "csc",
                               "floor",
                               "sec",
                               "log",
                               "erfc",
                               "rand_seed"})
        parser.DefineFun(name, +one);
      parser.DefineFun("rand", +none);
      parser.DefineFun("pow", +two);
      parser.DefineFun("if", +three);
      parser.DefineOprt("|", +two, 1);
      parser.DefineOprt("&", +two, 2);
    }



    /**
     * The position in @p text of what is at @p position of the same text with
     * other blanks, @p parsed. Not beyond the last letter by more than one.
     */
    std::size_t
    find_position(const std::string &text,
                  const std::string &parsed,
                  const std::size_t  position)
    {
      const auto is_blank = [](const unsigned char letter) {
        return std::isspace(letter) != 0;
      };
      std::size_t n_letters = 0;
      for (const char letter : parsed.substr(0, position))
        n_letters += !is_blank(letter);
      std::size_t i = 0, end_of_last = 0;
      for (; i < text.size(); ++i)
        if (!is_blank(text[i]))
          {
            if (n_letters == 0)
              return i;
            --n_letters;
            end_of_last = i + 1;
          }
      return end_of_last;
    }



    /** The coordinates or what stands for them, and t if it is known. */
    std::vector<std::string>
    variable_names(const unsigned int dim, const ExpressionNames &names)
    {
      std::vector<std::string> variables =
        names.variables.empty() ? std::vector<std::string>{"x", "y", "z"} :
                                  names.variables;
      variables.resize(dim);
      if (names.has_time)
        variables.push_back("t");
      return variables;
    }



    /** What muParser says of a fault, but for its place. */
    std::string
    describe_fault(const mu::ParserError &error)
    {
      static const std::regex place(
        " *(found )?at (expression )?position -?[0-9]+");
      return std::regex_replace(error.GetMsg(), place, "");
    }



    /** Refuses what muParser, and thus FunctionParser, does not understand. */
    void
    check_syntax(const Expression               &expression,
                 const Component                &component,
                 const std::vector<std::string> &variables,
                 const ExpressionNames          &names,
                 const std::string              &known_names)
    {
      mu::Parser parser;
      double     value = 0.;
      for (const auto &[name, constant] : names.constants)
        parser.DefineConst(name, constant);
      for (const std::string &name : variables)
        parser.DefineVar(name, &value);
      define_functions(parser);
      try
        {
          parser.SetExpr(without_blanks_behind_names(component.text));
          parser.Eval();
        }
      catch (const mu::ParserError &error)
        {
          refuse(expression,
                 "cannot be read: " + quote(describe_fault(error)),
                 "an expression in " + known_names + ", e.g. " + names.example,
                 error.GetPos() < 0 ?
                   nowhere :
                   component.begin + find_position(component.text,
                                                   error.GetExpr(),
                                                   error.GetPos()));
        }
    }
  } // namespace



  bool
  depends_on(const std::string &text, const std::string &name)
  {
    return std::regex_search(text, std::regex("\\b" + name + "\\b"));
  }



  bool
  Expression::is_zero() const
  {
    return equal_values(text, "0");
  }



  ExpressionNames
  obstacle_names()
  {
    ExpressionNames names;
    names.constants["pi"] = dealii::numbers::PI;
    names.has_time        = true;
    names.example         = "5*sin(2*pi*t)";
    return names;
  }



  template <int dim>
  std::unique_ptr<FunctionParser<dim>>
  make_function(const std::string &text, const ExpressionNames &names)
  {
    std::string variables;
    for (const std::string &name : variable_names(dim, names))
      variables += (variables.empty() ? "" : ",") + name;
    auto function = std::make_unique<FunctionParser<dim>>(
      Utilities::split_string_list(text, ';').size());
    function->initialize(variables, text, names.constants, names.has_time);
    return function;
  }



  template <int dim>
  std::string
  check_expression(const Expression      &expression,
                   const unsigned int     n_components,
                   const ExpressionNames &names)
  {
    const std::vector<Component> components = split_components(expression);
    if (components.size() != 1 && components.size() != n_components)
      refuse(
        expression,
        std::to_string(components.size()) + " components",
        n_components > 1 ? "1 (axial) or " + std::to_string(n_components) +
                             ", separated by ';'" :
                           "one expression, without ';'",
        components[std::min<std::size_t>(n_components, components.size() - 1)]
          .begin);
    check_signs(expression);
    check_determinism(expression);

    const std::vector<std::string> variables = variable_names(dim, names);
    std::string                    known_names;
    for (const std::string &name : variables)
      known_names += (known_names.empty() ? "" : ", ") + name;
    for (const auto &constant : names.constants)
      known_names += ", " + constant.first;

    for (const Component &component : components)
      {
        check_syntax(expression, component, variables, names, known_names);
        const auto function = make_function<dim>(component.text, names);
        for (unsigned int i = 0; i <= 16; ++i)
          {
            Point<dim> point;
            point[0] = i / 16.;
            if (!std::isfinite(function->value(point)))
              refuse(expression,
                     "not finite at " + variables.front() + " = " +
                       Utilities::to_string(point[0]) +
                       (names.has_time ? ", t = 0" : ""),
                     "expressions that are finite on 0 <= " +
                       variables.front() + " <= 1",
                     components.size() > 1 ? component.begin : nowhere);
          }
      }
    std::string text = expression.text;
    for (unsigned int c = components.size(); c < n_components; ++c)
      text += "; 0";
    return text;
  }



  template std::unique_ptr<FunctionParser<1>>
  make_function<1>(const std::string &, const ExpressionNames &);
  template std::unique_ptr<FunctionParser<2>>
  make_function<2>(const std::string &, const ExpressionNames &);
  template std::unique_ptr<FunctionParser<3>>
  make_function<3>(const std::string &, const ExpressionNames &);
  template std::string
  check_expression<1>(const Expression &,
                      const unsigned int,
                      const ExpressionNames &);
  template std::string
  check_expression<2>(const Expression &,
                      const unsigned int,
                      const ExpressionNames &);
  template std::string
  check_expression<3>(const Expression &,
                      const unsigned int,
                      const ExpressionNames &);
} // namespace ThermoContact
