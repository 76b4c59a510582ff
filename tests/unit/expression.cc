// SPDX-License-Identifier: LGPL-2.1-or-later
//
// 1. Expressions are accepted if and only if deal.II's FunctionParser
//    understands them: every function that it names, with none to three
//    arguments, with and without blanks behind its name, and its operators.
//    rand() and rand_seed(), which have another value each time, are refused;
//    erf, which deal.II 9.4 names and does not know, is known. deal.II 9.4
//    names 38 functions: 38 * 4 numbers of arguments * 2, and 12 more texts.
// 2. Where both understand it they have the same value, to 4 units in the last
//    place, at 1000 points of 40 expressions (muParser's inverse hyperbolic
//    functions lose digits near 0 and 1 and are compared elsewhere). Conditions
//    are 0 or 1, or 0.6: FunctionParser rounds some of them, here all but 0 is
//    true.
// 3. In other variables, 2 x' for x and t'/2 for t: each name of a variable is
//    another text, at x' = 1, t' = 3 of 3 x + t the value 6 + 1.5. Names of
//    functions, files and columns stay, and the e of 1e3 is no name.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/expression.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/mu_parser_internal.h>

#include <fstream>
#include <iostream>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const ExpressionNames names = {{"x", "t"}, {{"omega", 2.}}};



  double
  value_by_deal(const std::string &text, const double x, const double t)
  {
    FunctionParser<1> function;
    function.initialize("x,t",
                        text,
                        {{"pi", numbers::PI}, {"omega", 2.}},
                        true);
    function.set_time(t);
    return function.value(Point<1>(x));
  }



  bool
  is_understood_by_deal(const std::string &text)
  {
    // it prints what it does not understand
    std::ostringstream    printed;
    std::streambuf *const buffer = std::cerr.rdbuf(printed.rdbuf());
    bool                  result = true;
    try
      {
        value_by_deal(text, 0.5, 0.);
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
        const Expression expression("Sources/Heat source", text, names);
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
        if (text.rfind("rand", 0) == 0)
          {
            if (fault.find("another value each time") == std::string::npos)
              deallog << text << ": " << fault << std::endl;
          }
        else if (text.rfind("erf(", 0) == 0 || text.rfind("erf ", 0) == 0)
          continue;
        else if (is_understood ==
                 (fault.find("cannot be read") != std::string::npos))
          deallog << text << ": understood by FunctionParser " << is_understood
                  << ", " << fault << std::endl;
      }
    deallog << texts.size() << " texts, some understood " << (n_understood > 38)
            << ", some not " << (n_understood < texts.size()) << std::endl;
  }



  void
  test_values()
  {
    double       worst    = 0.;
    unsigned int n_values = 0;
    for (const std::string text : {"20*x*(x-1)^2",
                                   "omega*(cos(2*pi*x)-sin(pi*x/2))",
                                   "sin(3*t)-0.2",
                                   "x^3-x^4/(1+t)",
                                   "2^-x^t",
                                   "-x^2",
                                   "x-t-1",
                                   "x/(t+1)/3",
                                   "x-2^2^x",
                                   "x<t ? t : x>0.7 ? 2 : 3",
                                   "if(x<=t,x,t)",
                                   "(x>=0.5)+(t==x)+(t!=x)",
                                   "x<0.5 && t<0.3 || x>0.9",
                                   "(x<0.5)|(t>1)&(x>0.2)",
                                   "0.4 ? x : t",
                                   "if(0.6,x,t)",
                                   "1.6 && x>0.3",
                                   "tan(x)+asin(x)*acos(x)-atan(t)",
                                   "atan2(x-0.5,t-0.5)",
                                   "sinh(x)*cosh(t)-tanh(x*t)",
                                   "asinh(x+1)+acosh(2+t)+atanh(x/2+0.2)",
                                   "sec(x)+csc(t+1)-cot(x+1)",
                                   "exp(-x/0.1)",
                                   "log(x+1)+ln(t+2)",
                                   "log2(x+1)*log10(t+2)",
                                   "sqrt(x*t)",
                                   "pow(x,2.5)+pow(t,3)",
                                   "erfc(4*x)",
                                   "abs(x-t)*sign(x-0.5)",
                                   "rint(3*x)+int(3*t-1)",
                                   "floor(5*x)-ceil(5*t)",
                                   "min(x,t,0.3)+max(x,t)",
                                   "sum(x,t,1)*avg(x,2,t)",
                                   "pi*x+_e*omega",
                                   "1e-3*x+.5*t+2.",
                                   "+x*-t",
                                   "exp(-((t-0.4)/0.5)^2)",
                                   "0.1*cos(3*t)*if(t<0.5,1,exp(-t))",
                                   "x*(1-x)*sin(omega*t)^2",
                                   "(((x)))*((t+(1)))"})
      {
        const Expression expression("Sources/Heat source", text, names);
        for (unsigned int i = 1; i <= 1000; ++i)
          {
            const double x[]    = {std::fmod(0.618033988749895 * i, 1.),
                                   std::fmod(0.754877666246693 * i, 1.)};
            const double ours   = expression.evaluate(x);
            const double theirs = value_by_deal(text, x[0], x[1]);
            const double size   = std::max(std::abs(ours), std::abs(theirs));
            ++n_values;
            if (size > 0. && !(ours == theirs))
              raise(worst,
                    std::abs(ours - theirs) /
                      (std::nextafter(size, 2. * size) - size));
          }
      }
    deallog << n_values << " values, to 4 units in the last place "
            << (worst <= 4.) << std::endl;
  }



  void
  test_other_variables()
  {
    const auto rename = [](const std::string &text) {
      return Expression("Sources/Heat source", text, names)
        .with_variables({"(2*x)", "(0.5*t)"});
    };
    const double variables[] = {1., 3.};
    deallog << rename("3*x + t") << " = "
            << Expression("Sources/Heat source", rename("3*x + t"), names)
                 .evaluate(variables)
            << std::endl;
    std::ofstream("x.csv") << "t, x\n0, 2\n1, 4\n";
    deallog << rename("exp(-t)+1e3*x+table(x.csv, x, t-1)*max(x, t)")
            << std::endl;
  }
} // namespace



void
main_expression()
{
  initlog();
  test_names();
  test_values();
  test_other_variables();
  const auto is_first = [](const std::string &text) {
    return Expression("here", "sin(t)+2*x", names) ==
           Expression("here", text, names);
  };
  deallog << "the same: " << is_first("sin(t) + 2*x")
          << ", others: " << is_first("cos(t)+2*x") << is_first("sin(t)+3*x")
          << is_first("sin(x)+2*x") << is_first("sin(t)") << std::endl;
}
