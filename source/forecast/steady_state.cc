// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/method/bracketed_root.h>
#include <thermocontact/space/node_laws.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Why a scene without sources has no steady state in closed form. */
    std::string
    obstruction(const Scene &scene)
    {
      if (scene.row.is_given())
        return "no closed form of a row of bodies";
      if (scene.has_bodies())
        return "no closed form of a body with a material of its own, or before "
               "a mass";
      if (scene.sources.drives_end())
        return "none: the fixed end is heated or moved";
      if (scene.sources.has_moving_obstacle)
        return "none: the obstacle moves";
      if (scene.sources.has_driven_exchange)
        return "none: the heat exchange varies in time";
      if (scene.sources.any())
        return "no closed form with sources";
      if (scene.heat.right_temperature ||
          scene.parameters.boundary.right.is_clamped())
        return "no closed form with a right end that is held";
      if (!scene.heat.has_given_temperature)
        return "no closed form without a given temperature at the end x = 0";
      const BoundaryParameters &boundary = scene.parameters.boundary;
      if (scene.fields.has_displacement &&
          (scene.has_free_end || boundary.right.is_any()))
        return "no closed form with a free end x = 0, springs or masses";
      if (scene.parameters.dimension > 1 && !scene.heat.has_linear_profile())
        return "no closed form with a lateral heat exchange in more than one "
               "dimension";
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



    /** The body at rest with the profile of a drop $c$, (M2.1). */
    SteadyState
    state_of_drop(const Scene &scene, const double drop)
    {
      SteadyState state{nan, nan, nan, false};
      if (scene.fields.has_displacement)
        {
          // $G$ of (M3.1)
          const double expansion =
            scene.material.thermal_stress *
            RestProfile(scene.heat.surroundings(), drop).mean();
          // where an obstacle and a body of stiffness 1 meet
          double        free = expansion;
          const NodeLaw law =
            make_node_law(scene.contact, 0, scene.contact.gap, free);
          state.contact_force    = law.resolve(free, 1.).pressure;
          state.in_contact       = state.contact_force != 0.;
          state.displacement_end = expansion - state.contact_force;
        }
      if (scene.fields.has_temperature)
        state.temperature_end =
          RestProfile(scene.heat.surroundings(), drop).end();
      return state;
    }



    /** $F(c)$ of (M5.2): zero where the exchange keeps the profile. */
    double
    imbalance(const Scene &scene, const double drop)
    {
      const SteadyState state    = state_of_drop(scene, drop);
      double            position = state.displacement_end;
      const NodeLaw     law =
        make_node_law(scene.contact, 0, scene.contact.gap, position);
      const double reach = law.penetration(position);
      const double k     = scene.heat.exchange->coefficient(
        state.in_contact ? 0. : reach,
        std::abs(state.contact_force),
        {RestProfile(scene.heat.surroundings(), drop).end(),
         scene.heat.obstacle_temperature});
      return drop - k / (1. + k);
    }



    /** All zeros of (M5.2), by sampling; jumps over zero among them. */
    std::vector<SteadyState>
    states_of_varying_exchange(const Scene &scene)
    {
      const auto f = [&scene](const double c) { return imbalance(scene, c); };
      const auto add_state = [&scene](const double              c,
                                      const bool                is_stable,
                                      std::vector<SteadyState> &states) {
        states.push_back(state_of_drop(scene, c));
        states.back().is_stable = is_stable;
      };
      std::vector<SteadyState> states;
      constexpr unsigned int   n           = 20000;
      bool                     is_negative = f(0.) < 0.;
      if (!is_negative) // no exchange at all
        add_state(0., true, states);
      for (unsigned int i = 1; i <= n; ++i)
        if (const double c = static_cast<double>(i) / n;
            (f(c) < 0.) != is_negative)
          {
            add_state(bracketed_root(f, (i - 1.) / n, c).first,
                      is_negative,
                      states);
            is_negative = !is_negative;
          }
      return states;
    }
  } // namespace



  unsigned int
  nearest_state(const std::vector<SteadyState> &states,
                const SteadyState              &state)
  {
    // without temperatures there is one alone
    const auto distance = [&state](const SteadyState &other) {
      return std::abs(other.temperature_end - state.temperature_end);
    };
    return std::min_element(states.begin(),
                            states.end(),
                            [&](const SteadyState &a, const SteadyState &b) {
                              return distance(a) < distance(b);
                            }) -
           states.begin();
  }



  SteadyForecast
  steady_state(const Scene &scene)
  {
    SteadyForecast forecast;
    forecast.remark = obstruction(scene);
    if (!forecast.remark.empty())
      return forecast;

    if (scene.heat.exchange->is_in_matrices())
      forecast.states = {state_of_drop(scene, scene.heat.steady_drop())};
    else
      forecast.states = states_of_varying_exchange(scene);
    const Material &material = scene.material;
    if (scene.fields.has_displacement && material.has_inertia() &&
        !material.has_viscosity())
      forecast.remark =
        text("damped by heat conduction alone, over times of the order of ",
             QuantityUnits(scene.parameters)
               .text("time",
                     2. * (material.inertia + 0.4) /
                       std::pow(material.thermal_stress, 2),
                     1));
    return forecast;
  }
} // namespace ThermoContact
