// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameter_text.h>

#include <deal.II/base/utilities.h>

#include <cctype>
#include <cmath>
#include <iostream>
#include <regex>
#include <sstream>

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



    /** Collects what deal.II prints to std::cerr before it throws. */
    class ErrorStreamCatcher
    {
    public:
      ErrorStreamCatcher()
        : old_buffer(std::cerr.rdbuf(caught.rdbuf()))
      {}

      ~ErrorStreamCatcher()
      {
        std::cerr.rdbuf(old_buffer);
      }

      /** What stands between "<" and ">" after @p label. */
      std::string
      value(const std::string &label) const
      {
        const std::string text  = caught.str();
        const auto        begin = text.find(label);
        if (begin == std::string::npos)
          return "";
        const auto first = text.find('<', begin) + 1;
        return text.substr(first, text.find(">\n", first) - first);
      }

    private:
      std::ostringstream    caught;
      std::streambuf *const old_buffer;
    };



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



    /** Says what the parser did not understand. */
    [[noreturn]] void
    refuse_component(const Expression         &expression,
                     const Component          &component,
                     const ErrorStreamCatcher &errors,
                     const std::string        &known_names)
    {
      // the parser counts from 0, and in what deal.II has made of the text
      const std::string fault =
        std::regex_replace(errors.value("Message:"),
                           std::regex(
                             " *(found )?at (expression )?position -?[0-9]+"),
                           "");
      const std::string position = errors.value("Position:");
      const bool        has_position =
        !position.empty() &&
        position.find_first_not_of("0123456789") == std::string::npos &&
        position.size() < 9;
      refuse(expression,
             "cannot be read: " + quote(fault),
             "an expression in " + known_names + ", e.g. 20*x*(x-1)^2",
             has_position ?
               component.begin + find_position(component.text,
                                               errors.value("Formula:"),
                                               std::stoul(position)) :
               nowhere);
    }
  } // namespace



  bool
  Expression::is_zero() const
  {
    return equal_values(text, "0");
  }



  template <int dim>
  std::unique_ptr<FunctionParser<dim>>
  make_function(const std::string &text, const ExpressionNames &names)
  {
    static const std::map<int, std::string> coordinates = {{1, "x"},
                                                           {2, "x,y"},
                                                           {3, "x,y,z"}};

    auto function = std::make_unique<FunctionParser<dim>>(
      Utilities::split_string_list(text, ';').size());
    function->initialize(coordinates.at(dim) + (names.has_time ? ",t" : ""),
                         text,
                         names.constants,
                         names.has_time);
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

    std::string known_names = dim == 1 ? "x" : dim == 2 ? "x, y" : "x, y, z";
    known_names += names.has_time ? ", t" : "";
    for (const auto &constant : names.constants)
      known_names += ", " + constant.first;

    for (const Component &component : components)
      {
        const auto function = make_function<dim>(component.text, names);
        for (unsigned int i = 0; i <= 16; ++i)
          {
            Point<dim> point;
            point[0]                       = i / 16.;
            double                   value = 0.;
            const ErrorStreamCatcher errors;
            try
              {
                value = function->value(point);
              }
            catch (const ExceptionBase &)
              {
                refuse_component(expression, component, errors, known_names);
              }
            if (!std::isfinite(value))
              refuse(expression,
                     "not finite at x = " + Utilities::to_string(point[0]) +
                       (names.has_time ? ", t = 0" : ""),
                     "expressions that are finite on 0 <= x <= 1",
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
