// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Expressions are accepted if and only if FunctionParser, which evaluates them,
// understands them: every function that deal.II names, with none to three
// arguments, with and without blanks behind its name, and its operators. rand()
// alone is refused for another reason. deal.II 9.4 names 38 functions: 38 * 4
// numbers of arguments * 2, and 12 more texts.
// The column of a fault, from 0, by hand; a tab is shown as <U+0009>, seven
// letters more.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/expression.h>

#include <deal.II/base/mu_parser_internal.h>

#include <iostream>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const ExpressionNames names = {{{"pi", 3.14}}, true};



  bool
  is_understood_by_deal(const std::string &text)
  {
    // it prints what it does not understand
    std::ostringstream    printed;
    std::streambuf *const buffer = std::cerr.rdbuf(printed.rdbuf());
    bool                  result = true;
    try
      {
        make_function<1>(text, names)->value(Point<1>(0.5));
      }
    catch (const dealii::ExceptionBase &)
      {
        result = false;
      }
    std::cerr.rdbuf(buffer);
    return result;
  }



  /** The message, or nothing. */
  std::string
  fault_of(const std::string &text)
  {
    try
      {
        check_expression<1>({"Sources/Heat source", text}, 1, names);
        return "";
      }
    catch (const InputError &error)
      {
        return error.what();
      }
  }



  void
  test_names()
  {
    std::vector<std::string> texts = {"x|1",
                                      "x & 1",
                                      "x<1 ? x : t",
                                      "x < 1 && t == 0 || x != 2",
                                      "x^2 - -pi",
                                      "sinx (0.5)",
                                      "round (0.5)",
                                      "_pi*x",
                                      "x!",
                                      "1e",
                                      "\"x\"",
                                      "sin(x) sin(x)"};
    for (const std::string &name :
         dealii::internal::FunctionParser::get_function_names())
      for (const std::string blanks : {"", " \t "})
        for (const char *arguments :
             {"()", "(0.5)", "(0.5, 0.5)", "(0.5, 0.5, 0.5)"})
          texts.push_back(name + blanks + arguments + "+x");

    unsigned int n_understood = 0;
    for (const std::string &text : texts)
      {
        const bool        is_understood = is_understood_by_deal(text);
        const std::string fault         = fault_of(text);
        n_understood += is_understood;
        if (text.rfind("rand", 0) == 0 && text.rfind("rand_", 0) != 0)
          {
            if (fault.find("differs from run to run") == std::string::npos)
              deallog << text << ": " << fault << std::endl;
          }
        else if (is_understood ==
                 (fault.find("cannot be read") != std::string::npos))
          deallog << text << ": understood by FunctionParser " << is_understood
                  << ", " << fault << std::endl;
      }
    deallog << texts.size() << " texts, some understood " << (n_understood > 38)
            << ", some not " << (n_understood < texts.size()) << std::endl;
  }



  /** The column of the caret. */
  void
  test_place(const std::string &text)
  {
    const std::string message = fault_of(text);
    const auto        caret   = message.find('^');
    const auto        line    = message.rfind('\n', caret);
    deallog << '[' << text << ']';
    if (caret == std::string::npos)
      deallog << " no place" << std::endl;
    else
      deallog << " column "
              << caret - line - 1 - std::string("  here:    ").size()
              << std::endl;
  }
} // namespace



int
main()
{
  initlog();
  test_names();
  test_place("x + y");
  test_place("sin   (x) + foo*2");
  test_place("exp \t(sin  (x)) + 2*exp (y)");
  test_place("x +");
  test_place("(x + 1");
  test_place("pow(x)");
}
