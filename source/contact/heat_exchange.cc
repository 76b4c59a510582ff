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
    , law([coefficient](const double,
                        const double,
                        const ExchangeConditions &) { return coefficient; })
  {}



  HeatExchange::HeatExchange(const std::string &description,
                             const Dependence  &dependence,
                             const Law         &law)
    : description_(description)
    , dependence_(dependence)
    , law(law)
  {}



  double
  HeatExchange::coefficient(const double              penetration,
                            const double              pressure,
                            const ExchangeConditions &there) const
  {
    const double gap = std::max(0., -penetration);
    const double k   = law(gap, pressure, there);
    if (!(k >= 0. && std::isfinite(k)))
      {
        std::string place;
        const auto  add =
          [&place](const bool counts, const char *name, const double value) {
            if (counts)
              place += (place.empty() ? "" : ", ") + text(name, " = ", value);
          };
        add(dependence_.on_contact, "gap", gap);
        add(dependence_.on_contact, "pressure", pressure);
        add(dependence_.on_temperature, "theta", there.temperature);
        add(dependence_.on_temperature, "theta_obs", there.surroundings);
        add(dependence_.on_time, "t", there.time);
        throw ComputationError(text("Boundary/right/Heat exchange: ",
                                    description(),
                                    " is ",
                                    k,
                                    " at ",
                                    place,
                                    "\n  allowed: k >= 0, finite for all "
                                    "values that occur"));
      }
    return k;
  }

} // namespace ThermoContact
