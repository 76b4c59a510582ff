// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/scene/exchange_expression.h>

#include <regex>

namespace ThermoContact
{
  namespace
  {
    /** The plane of gaps and pressures. */
    constexpr unsigned int n_variables = 2;



    class ExchangeExpression : public HeatExchange
    {
    public:
      ExchangeExpression(const std::string &text, const ExpressionNames &names)
        : text(text)
        , function(make_function<n_variables>(text, names))
      {}

      std::string
      description() const override
      {
        return "k = " + text;
      }

    protected:
      double
      value(const double gap, const double pressure) const override
      {
        return function->value(Point<n_variables>(gap, pressure));
      }

    private:
      const std::string                                        text;
      const std::unique_ptr<const FunctionParser<n_variables>> function;
    };
  } // namespace



  std::unique_ptr<const HeatExchange>
  exchange_by_expression(const std::string &text, const double largest_gap)
  {
    ExpressionNames names;
    names.constants["pi"] = numbers::PI;
    names.variables       = {"gap", "pressure"};
    names.example         = "0.1/(0.1 + gap)";
    check_expression<n_variables>({"Boundary/Heat exchange", text}, 1, names);
    auto exchange = std::make_unique<ExchangeExpression>(text, names);
    try
      {
        constexpr unsigned int n = 1000;
        for (unsigned int i = 0; i <= n; ++i)
          {
            const double part = static_cast<double>(i) / n;
            exchange->coefficient(-part * largest_gap, 0.);
            exchange->coefficient(0., part);
          }
      }
    catch (const ComputationError &error)
      {
        throw InputError(error.what());
      }
    static const std::regex variable("\\b(gap|pressure)\\b");
    if (!std::regex_search(text, variable))
      return constant_exchange(exchange->coefficient(0., 0.));
    return exchange;
  }
} // namespace ThermoContact
