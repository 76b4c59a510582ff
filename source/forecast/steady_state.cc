// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/forecast/steady_state.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** Why a scene without sources has no steady state in closed form. */
    std::string
    obstruction(const Scene &scene)
    {
      if (scene.sources.any())
        return "no closed form with sources";
      if (!scene.fields.has_displacement)
        return "";
      const Material &material = scene.material;
      if (scene.parameters.dimension > 1 && !scene.has_rollers &&
          (material.has_thermal_stress() || scene.contact.law->is_active()))
        return "no closed form with free lateral faces";
      if (scene.contact.law->is_active() && !scene.contact.has_uniform_gap())
        return "no closed form with a gap that is not the same everywhere";
      if (material.has_inertia() && !material.has_viscosity() &&
          !material.has_heating())
        return "none: nothing damps the motion, which goes on for ever";
      return "";
    }



    /**
     * Pressure under which an obstacle and a body of stiffness 1 meet, which
     * without it would overlap by @p penetration.
     */
    double
    pressure_at_rest(const ContactLaw &law, const double penetration)
    {
      return law.local_pressure(penetration, 1.);
    }
  } // namespace



  double
  free_expansion(const Scene &scene)
  {
    const HeatExchange &heat = scene.heat;
    return scene.material.thermal_stress *
           (heat.fixed_end_temperature -
            0.5 * heat.steady_drop() *
              (heat.fixed_end_temperature - heat.obstacle_temperature));
  }



  SteadyForecast
  steady_state(const Scene &scene)
  {
    SteadyForecast forecast;
    forecast.remark = obstruction(scene);
    if (!forecast.remark.empty())
      return forecast;

    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    SteadyState      state{nan, nan, nan, false};
    const Material  &material = scene.material;
    if (scene.fields.has_displacement)
      {
        const double expansion = free_expansion(scene);
        state.contact_force =
          pressure_at_rest(*scene.contact.law, expansion - scene.contact.gap);
        state.in_contact       = state.contact_force > 0.;
        state.displacement_end = expansion - state.contact_force;
      }
    if (scene.fields.has_temperature)
      state.temperature_end = scene.heat.steady_temperature(1.);
    forecast.state = state;
    if (scene.fields.has_displacement && material.has_inertia() &&
        !material.has_viscosity())
      forecast.remark =
        text("damped by heat conduction alone, over times of the order of ",
             significant(2. * (material.inertia + 0.4) /
                           std::pow(material.thermal_stress, 2),
                         1));
    return forecast;
  }
} // namespace ThermoContact
