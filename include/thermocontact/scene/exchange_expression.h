// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_exchange_expression_h
#define thermocontact_scene_exchange_expression_h

#include <thermocontact/contact/heat_exchange.h>
#include <thermocontact/input/parameters.h>

#include <memory>

namespace ThermoContact
{
  /**
   * The heat exchange that Boundary/Heat exchange says as an expression in gap
   * and pressure; constant if it names neither.
   *
   * @param largest_gap up to which it is checked
   * @throw InputError if it cannot be read, or if it is negative or not finite
   *   at a gap up to there or a pressure up to 1
   */
  std::unique_ptr<const HeatExchange>
  exchange_by_expression(const Parameters &parameters,
                         const double      largest_gap);
} // namespace ThermoContact

#endif
