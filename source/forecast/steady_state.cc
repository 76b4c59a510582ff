// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/forecast/steady_state.h>
#include <thermocontact/input/parameter_file.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** $c$ of (M.7), the part of the way to the obstacle's temperature. */
    double
    temperature_drop(const BoundaryParameters &boundary)
    {
      const double k = boundary.heat_exchange;
      return k / (k + 1.);
    }



    /** Why a scene without sources has no steady state in closed form. */
    std::string
    obstruction(const Parameters &parameters)
    {
      const ModelParameters &model = parameters.model;
      if (has_sources(parameters))
        return "no closed form with sources";
      if (!model.has_displacement())
        return "";
      if (parameters.dimension > 1 &&
          parameters.boundary.lateral_support == "free" &&
          (model.thermal_stress() != 0. || parameters.contact_law().is_active))
        return "no closed form with free lateral faces";
      if (model.inertia > 0. && model.viscosity == 0. &&
          model.thermoelastic_heating() == 0.)
        return "none: nothing damps the motion, which goes on for ever";
      return "";
    }
  } // namespace



  bool
  has_sources(const Parameters &parameters)
  {
    const auto acts = [](const bool has_field, const std::string &expression) {
      return has_field && !equal_values(expression, "0");
    };
    const SourceParameters &sources = parameters.sources;
    const bool              heat    = parameters.model.has_temperature();
    const bool              motion  = parameters.model.has_displacement();
    return acts(heat, sources.heat_source) ||
           acts(heat, sources.end_heat_flux) ||
           acts(motion, sources.body_force) ||
           acts(motion, sources.end_traction);
  }



  double
  free_expansion(const Parameters &parameters)
  {
    const BoundaryParameters &boundary = parameters.boundary;
    return parameters.model.thermal_stress() *
           (boundary.fixed_end_temperature -
            0.5 * temperature_drop(boundary) *
              (boundary.fixed_end_temperature - boundary.obstacle_temperature));
  }



  SteadyForecast
  steady_state(const Parameters &parameters)
  {
    SteadyForecast         forecast;
    const ModelParameters &model = parameters.model;
    forecast.remark              = obstruction(parameters);
    if (!forecast.remark.empty())
      return forecast;

    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    SteadyState      state{nan, nan, nan, false};
    if (model.has_displacement())
      {
        const ContactLaw law       = parameters.contact_law();
        const double     expansion = free_expansion(parameters);
        state.in_contact           = law.is_active && expansion > law.gap;
        state.contact_force =
          state.in_contact ? (expansion - law.gap) / (1. + law.compliance) : 0.;
        state.displacement_end = expansion - state.contact_force;
      }
    if (model.has_temperature())
      {
        const double theta_A = parameters.boundary.fixed_end_temperature;
        state.temperature_end =
          theta_A - temperature_drop(parameters.boundary) *
                      (theta_A - parameters.boundary.obstacle_temperature);
      }
    forecast.state = state;
    if (model.has_displacement() && model.inertia > 0. && model.viscosity == 0.)
      forecast.remark =
        text("damped by heat conduction alone, over times of the order of ",
             significant(2. * (model.inertia + 0.4) /
                           std::pow(model.thermal_stress(), 2),
                         1));
    return forecast;
  }
} // namespace ThermoContact
