// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/scene/exchange_expression.h>

#include <array>

namespace ThermoContact
{
  namespace
  {
    class ExchangeExpression : public HeatExchange
    {
    public:
      explicit ExchangeExpression(const Expression &expression)
        : expression(expression)
      {}

      std::string
      description() const override
      {
        return "k = " + expression.text();
      }

    protected:
      double
      value(const double gap, const double pressure) const override
      {
        const std::array<double, 2> variables{{gap, pressure}};
        return expression.evaluate(variables.data());
      }

    private:
      const Expression expression;
    };
  } // namespace



  std::unique_ptr<const HeatExchange>
  exchange_by_expression(const Parameters &parameters, const double largest_gap)
  {
    const std::string path = "Boundary/Heat exchange";
    const Expression  expression(path,
                                parameters.boundary.exchange_expression,
                                parameters.names(path));
    auto exchange = std::make_unique<ExchangeExpression>(expression);
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
    if (expression.is_constant())
      return constant_exchange(exchange->coefficient(0., 0.));
    return exchange;
  }
} // namespace ThermoContact
