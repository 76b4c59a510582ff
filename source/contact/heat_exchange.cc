// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/contact/heat_exchange.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** $k$, whatever the gap and the pressure. */
    class ConstantExchange : public HeatExchange
    {
    public:
      explicit ConstantExchange(const double coefficient)
        : constant(coefficient)
      {}

      std::string
      description() const override
      {
        return text("k = ", constant);
      }

      bool
      is_constant() const override
      {
        return true;
      }

    protected:
      double
      value(const double, const double) const override
      {
        return constant;
      }

    private:
      const double constant;
    };
  } // namespace



  double
  HeatExchange::coefficient(const double penetration,
                            const double pressure) const
  {
    const double gap = std::max(0., -penetration);
    const double k   = value(gap, pressure);
    if (!(k >= 0. && std::isfinite(k)))
      throw ComputationError(text("Boundary/Heat exchange: ",
                                  description(),
                                  " is ",
                                  k,
                                  " at gap = ",
                                  gap,
                                  ", pressure = ",
                                  pressure,
                                  "\n  allowed: k >= 0, finite for all gaps "
                                  "and pressures that occur"));
    return k;
  }



  std::unique_ptr<const HeatExchange>
  constant_exchange(const double coefficient)
  {
    return std::make_unique<ConstantExchange>(coefficient);
  }
} // namespace ThermoContact
