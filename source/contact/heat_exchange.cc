// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/contact/heat_exchange.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  HeatExchange::HeatExchange(const double coefficient)
    : description_(text("k = ", coefficient))
    , is_constant_(true)
    , value([coefficient](const double, const double) { return coefficient; })
  {}



  HeatExchange::HeatExchange(const std::string &description,
                             const std::function<double(double, double)> &value)
    : description_(description)
    , is_constant_(false)
    , value(value)
  {}



  double
  HeatExchange::coefficient(const double penetration,
                            const double pressure) const
  {
    const double gap = std::max(0., -penetration);
    const double k   = value(gap, pressure);
    if (!(k >= 0. && std::isfinite(k)))
      throw ComputationError(text("Boundary/right/Heat exchange: ",
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

} // namespace ThermoContact
