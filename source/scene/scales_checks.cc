// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/scene/scales_checks.h>

#include <string>
#include <tuple>

namespace ThermoContact
{
  void
  check_scales(const Parameters &parameters)
  {
    const ScalesParameters &scales = parameters.scales;
    if (!scales.is_given())
      return;
    const bool has_temperature = parameters.model.fields != "displacement";
    for (const auto &[name, value, is_needed] :
         {std::make_tuple("Length", scales.length, true),
          std::make_tuple("Time", scales.time, true),
          std::make_tuple("Stress", scales.stress, true),
          std::make_tuple("Area", scales.area, true),
          std::make_tuple("Displacement", scales.displacement, false),
          std::make_tuple("Temperature",
                          scales.temperature,
                          has_temperature || scales.reference_temperature),
          std::make_tuple("Reference temperature",
                          scales.reference_temperature,
                          has_temperature || scales.temperature)})
      {
        const std::string entry = std::string("Scales/") + name;
        if (is_needed && !value)
          throw InputError(entry +
                           " = none\n  allowed: a number, since the scene has "
                           "other scales\n  remedy:  give all scales, as "
                           "--units writes them, or remove section Scales");
        if (value && !(*value > 0.))
          throw InputError(entry +
                           " = 0\n  allowed: a positive number\n  remedy:  "
                           "the SI value of one unit of the scene");
      }
  }
} // namespace ThermoContact
